// Reads the TOML of a family and expands it into points.
#pragma once

#include <algorithm>
#include <span>

#include "case/toml_reader.h"
#include "chart/family.h"

namespace etalon {

// Keys of a case that say what is judged, or where it stands; a family has no use for them.
inline constexpr std::string_view kJudgedKeys[] = {"family", "law", "covers", "expected_failure",
                                                   "map"};

inline bool IsAmong(std::string_view key, std::span<const std::string_view> keys) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

// Its parts: family_reader.cc reads head, scenes and members, family_case.cc makes the cases.
class FamilyReader {
  public:
    // `text` is the file's.
    FamilyReader(const std::filesystem::path& root, const std::filesystem::path& file,
                 std::string text);

    Result<Family> Read();

  private:
    // A setting's name and its values, in the file's order.
    using Axis = std::pair<std::string, std::vector<Setting>>;

    // A table of a member or a scene, and where it stands.
    struct Entry {
        std::string name;
        const toml::table* table = nullptr;
    };

    Status<> ReadHead();
    Status<> ReadScenes();
    Status<> ReadMembers();
    Status<> ReadReference();

    Result<std::vector<Entry>> Entries(const char* key, std::span<const std::string_view> keys);
    Result<std::vector<Axis>> Axes(const toml::table& member) const;
    Result<Setting> ReadSetting(const std::string& name, const toml::node& node) const;
    Result<FamilyPoint> MakePoint(std::size_t member, const std::vector<Setting>& settings);

    // family_case.cc
    Result<Case> MakeCase(std::size_t member, std::size_t scene,
                          const std::vector<Setting>& settings);
    // There is one recipe at most, and it is one.
    Status<> CheckRecipe(const toml::table& keys) const;
    Status<> HoldInputs(const toml::value<std::string>& at, Case& held) const;
    // Takes a case's word for what the family is: all of them must agree.
    Status<> Count(const Case& read, bool is_judged, const toml::table& member);

    std::filesystem::path root_;
    TomlReader reader_;
    std::string text_;
    toml::table table_;
    std::vector<Entry> members_;
    std::vector<Entry> scenes_;
    std::size_t cases_ = 0;             // that have been counted
    std::vector<std::string> recipes_;  // of the first of these
    Family family_;
};

}  // namespace etalon
