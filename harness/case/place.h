// Place: where a key of a case stands. A case may have its keys from several files.
#pragma once

#include <string>

namespace etalon {

struct Place {
    std::string file;
    int line = 0;

    // What an error about the key begins with: "file:line: ".
    std::string Text() const { return file + ":" + std::to_string(line) + ": "; }
};

}  // namespace etalon
