#include "run/case_choice.h"

#include <algorithm>

#include "base/file.h"
#include "case/case.h"

namespace etalon {
namespace {

bool IsPrefixOf(const std::string& pattern, const std::string& path) {
    return path == pattern ||
           (path.starts_with(pattern) && (pattern.ends_with('/') || path[pattern.size()] == '/'));
}

}  // namespace

Result<std::filesystem::path> FindRoot(const std::filesystem::path& from) {
    std::error_code ignored;
    for (std::filesystem::path folder = std::filesystem::absolute(from, ignored);;
         folder = folder.parent_path()) {
        if (std::filesystem::is_directory(folder / "cases", ignored)) {
            const std::filesystem::path near = std::filesystem::proximate(folder, ignored);
            // The folder that the user stands in has no name, so that paths read "cases/x.toml".
            return near == "." ? std::filesystem::path() : near;
        }
        if (folder == folder.parent_path()) {
            return Error{
                "no folder 'cases' here or above; --root DIR names the folder that holds it"};
        }
    }
}

Result<std::vector<std::string>> ChooseCases(const std::filesystem::path& root,
                                             const std::vector<std::string>& patterns) {
    ETALON_TRY(all, ListCases(root));
    if (patterns.empty()) {
        if (all.empty()) {
            return Error{(root / "cases").string() + ": holds no case"};
        }
        return all;
    }
    std::vector<std::string> chosen;
    for (const std::string& pattern : patterns) {
        bool any = false;
        for (const std::string& path : all) {
            if (IsPrefixOf(pattern, path) || GlobMatches(pattern, path)) {
                any = true;
                chosen.push_back(path);
            }
        }
        if (!any) {
            return Error{"no case is called '" + pattern + "'; `etalon list` shows them"};
        }
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

Result<std::string> ChooseOneCase(const std::filesystem::path& root, const std::string& pattern,
                                  const std::string& done) {
    ETALON_TRY(paths, ChooseCases(root, {pattern}));
    if (std::find(paths.begin(), paths.end(), pattern) != paths.end()) {
        return pattern;
    }
    if (paths.size() != 1) {
        return Error{"'" + pattern + "' names " + std::to_string(paths.size()) +
                     " cases, and one is " + done + "; `etalon list` shows them"};
    }
    return std::move(paths.front());
}

}  // namespace etalon
