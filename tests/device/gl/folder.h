// A folder tree of its own, and environment variables, for one test.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace etalon {

class FolderTest : public ::testing::Test {
  protected:
    FolderTest() {
        std::string name =
            (std::filesystem::temp_directory_path() / "etalon-folder-XXXXXX").string();
        root_ = mkdtemp(name.data());
    }
    ~FolderTest() override {
        std::filesystem::remove_all(root_);
        for (const std::string& name : variables_) {
            unsetenv(name.c_str());
        }
    }

    // Until the test ends.
    void SetVariable(const std::string& name, const std::string& value) {
        setenv(name.c_str(), value.c_str(), 1);
        variables_.push_back(name);
    }

    // An empty file.
    std::filesystem::path Add(const std::string& path) {
        std::filesystem::create_directories((root_ / path).parent_path());
        std::ofstream(root_ / path) << "";
        return root_ / path;
    }

    std::filesystem::path root_;

  private:
    std::vector<std::string> variables_;
};

}  // namespace etalon
