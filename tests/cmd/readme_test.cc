// What the README shows is what the program prints.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "base/file.h"
#include "support/etalon.h"

namespace etalon {
namespace {

struct Example {
    std::string command;
    std::string output;   // what follows the command
    bool is_cut = false;  // the README leaves the rest out ("...")
};

// The commands of the README's console blocks, with what it says they print.
std::vector<Example> Examples() {
    const Result<std::string> readme = ReadTextFile("README.md");
    EXPECT_TRUE(readme.ok()) << readme.error().message;
    std::istringstream lines(*readme);
    std::vector<Example> examples;
    bool in_block = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) {
            in_block = line == "```console";
        } else if (in_block && line.starts_with("$ build/")) {
            examples.push_back({line.substr(std::string("$ build/").size()), "", false});
        } else if (in_block && line == "...") {
            examples.back().is_cut = true;
        } else if (in_block) {
            examples.back().output += line + "\n";
        }
    }
    return examples;
}

TEST(Readme, ShowsWhatTheProgramPrints) {
    const std::vector<Example> examples = Examples();
    ASSERT_GE(examples.size(), 2u);
    for (const Example& example : examples) {
        const Finished finished = RunInShell(example.command);
        if (finished.status == 2 && finished.err.find("no device is called") != std::string::npos) {
            GTEST_SKIP() << finished.err;
        }
        const std::string printed =
            example.is_cut ? finished.out.substr(0, example.output.size()) : finished.out;
        EXPECT_EQ(printed, example.output) << example.command;
    }
}

}  // namespace
}  // namespace etalon
