#include "run/gtest_flags.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace etalon {
namespace {

// GoogleTest answers a flag that it does not know with its help on the standard output.
constexpr std::array kGoogleTestFlags = {"also_run_disabled_tests",
                                         "break_on_failure",
                                         "brief",
                                         "catch_exceptions",
                                         "color",
                                         "fail_fast",
                                         "filter",
                                         "list_tests",
                                         "output",
                                         "print_time",
                                         "print_utf8",
                                         "random_seed",
                                         "recreate_environments_when_repeating",
                                         "repeat",
                                         "shuffle",
                                         "stack_trace_depth",
                                         "stream_result_to",
                                         "throw_on_failure"};

}  // namespace

Status<> InitGoogleTest(const std::vector<std::string>& arguments) {
    for (const std::string& argument : arguments) {
        const std::string_view prefix = "--gtest_";
        const std::string name = argument.substr(prefix.size(), argument.find('=') - prefix.size());
        if (std::find(kGoogleTestFlags.begin(), kGoogleTestFlags.end(), name) ==
            kGoogleTestFlags.end()) {
            return Error{"GoogleTest knows no flag '" + argument + "'"};
        }
    }
    std::vector<std::string> words = {"etalon"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    int count = static_cast<int>(words.size());
    ::testing::InitGoogleTest(&count, pointers.data());
    return Ok();
}

}  // namespace etalon
