#include "chart/family.h"

#include <algorithm>

#include "base/file.h"
#include "case/like.h"
#include "case/suggestion.h"
#include "chart/family_reader.h"
#include "run/case_choice.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSuffix = ".family.toml";

// The folder that holds the nearest folder `cases` above the file; empty where there is none.
fs::path RootAbove(const fs::path& file) {
    std::error_code ignored;
    fs::path below = fs::absolute(file, ignored).lexically_normal().parent_path();
    for (; below != below.parent_path(); below = below.parent_path()) {
        if (below.filename() == "cases") {
            return fs::proximate(below.parent_path(), ignored);
        }
    }
    return {};
}

}  // namespace

std::string_view MeasureName(ErrorMeasure measure) {
    constexpr std::string_view kNames[] = {"absolute", "relative", "ulp"};
    return kNames[static_cast<std::size_t>(measure)];
}

Result<Family> ReadFamily(const fs::path& root, const fs::path& file) {
    ETALON_TRY(text, ReadTextFile(file));
    return FamilyReader(root, file, std::move(text)).Read();
}

Result<std::string> ReadQuantity(const fs::path& file) {
    ETALON_TRY(text, ReadTextFile(file));
    const TomlReader reader(file.string());
    ETALON_TRY(table, reader.Parse(text));
    return reader.TextAt(table, "quantity", "");
}

Result<std::vector<std::string>> ListFamilies(const fs::path& root) {
    const fs::path folder = root / "cases";
    std::error_code code;
    std::vector<std::string> addresses;
    fs::recursive_directory_iterator at(folder, code);
    for (; !code && at != fs::recursive_directory_iterator(); at.increment(code)) {
        if (at->is_regular_file() && IsFamily(at->path())) {
            std::string address = at->path().lexically_relative(folder).generic_string();
            address.resize(address.size() - kSuffix.size());
            addresses.push_back(std::move(address));
        }
    }
    if (code) {
        return Error{folder.string() + ": " + code.message()};
    }
    std::sort(addresses.begin(), addresses.end());
    return addresses;
}

Result<FamilyPlace> FindFamily(const fs::path& root, const std::string& name) {
    std::error_code ignored;
    if (name.ends_with(".toml")) {
        const fs::path file = name;
        if (!fs::is_regular_file(file, ignored)) {
            return Error{"there is no file " + name};
        }
        if (!root.empty()) {
            return FamilyPlace{root, file};
        }
        const fs::path above = RootAbove(file);
        if (!above.empty()) {
            return FamilyPlace{above == "." ? fs::path() : above, file};
        }
        return FamilyPlace{file.parent_path(), file};
    }
    FamilyPlace place;
    place.root = root;
    if (root.empty()) {
        ETALON_TRY(found, FindRoot("."));
        place.root = found;
    }
    place.file = place.root / "cases" / (name + std::string(kSuffix));
    if (fs::is_regular_file(place.file, ignored)) {
        return place;
    }
    ETALON_TRY(all, ListFamilies(place.root));
    const std::vector<std::string_view> names(all.begin(), all.end());
    const std::string near = Suggestion(name, names);
    return Error{"no family is called '" + name + "'" +
                 (near.empty() ? "; `etalon chart --list` shows them" : near)};
}

}  // namespace etalon
