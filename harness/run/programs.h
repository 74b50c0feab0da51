// The programs of a run: each is compiled once, for all devices that take the same text or module.
#pragma once

#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "compile/compile.h"
#include "probe/call.h"

namespace etalon {

class Programs {
  public:
    using Compiled = Result<Program, CompileFailure>;

    // What `baked` rows of the call, or its inputs at run time, compile to by that recipe. Waits
    // where another thread is at it. The reference stays valid as long as this object.
    const Compiled& Get(const Call& call, const Signature& signature, const Recipe& recipe,
                        Target target, const std::vector<std::vector<std::uint32_t>>& baked);

    // Everything that a program depends on, but for the content of its files, which does not change
    // in a run, and for the target. An image is named by its address.
    static std::string KeyOf(const Call& call, const Recipe& recipe);

    std::size_t size() const;

  private:
    // Of the call's images, a program has those that it reaches; its key names all of them, and
    // their addresses must not be given to others.
    struct Entry {
        std::shared_future<std::unique_ptr<const Compiled>> compiled;
        std::vector<BoundImage> images;
    };

    mutable std::mutex mutex_;
    std::map<std::string, Entry> entries_;
};

}  // namespace etalon
