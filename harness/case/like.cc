#include "case/like.h"

#include <algorithm>

#include "base/file.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kKeys[] = {
    "description", "source", "call",    "oracle", "accept",  "family",          "seed",
    "combine",     "where",  "recipes", "with",   "include", "define",          "out",
    "images",      "domain", "law",     "like",   "covers",  "expected_failure"};
// Keys that say something of one case and of none that is like it.
constexpr std::string_view kOwnKeys[] = {"covers", "expected_failure", "like"};

bool IsOwn(std::string_view key) {
    return std::find(std::begin(kOwnKeys), std::end(kOwnKeys), key) != std::end(kOwnKeys);
}

Result<toml::table> Read(const fs::path& root, const fs::path& file, std::vector<fs::path>& likes);

// Adds to a table that stands in `file` the keys that its `like` names.
Status<> AddKeys(const fs::path& root, const fs::path& file, toml::table& table,
                 std::vector<fs::path>& likes) {
    const TomlReader reader(file.string());
    const toml::node* node = table.get("like");
    if (node == nullptr) {
        return Ok();
    }
    ETALON_TRY(name, reader.TextAt(table, "like", std::nullopt));
    const fs::path other =
        (name.ends_with(".toml") ? file.parent_path() / name : root / "cases" / (name + ".toml"))
            .lexically_normal();
    const auto same = std::find(likes.begin(), likes.end(), other);
    if (same != likes.end()) {
        std::string circle;
        for (auto at = same; at != likes.end(); ++at) {
            circle += at->string() + " is like ";
        }
        return reader.Fail(*node, "'like' leads in a circle: " + circle + other.string());
    }
    std::error_code ignored;
    if (!fs::is_regular_file(other, ignored)) {
        return reader.Fail(*node, "'like': there is no file " + other.string());
    }
    ETALON_TRY(further, Read(root, other, likes));
    for (auto [key, value] : further) {
        if (!IsOwn(key.str())) {
            table.insert(key, std::move(value));
        }
    }
    return Ok();
}

// `likes` are the files that led here, the case itself first.
Result<toml::table> Read(const fs::path& root, const fs::path& file, std::vector<fs::path>& likes) {
    ETALON_TRY(text, ReadTextFile(file));
    const TomlReader reader(file.string());
    ETALON_TRY(table, reader.Parse(text));
    ETALON_TRY_STEP(reader.OnlyKeys(table, kKeys));
    for (const auto& [key, node] : TomlReader::InOrder(table)) {
        if (IsPart(file) && key != "like" && IsOwn(key)) {
            return reader.Fail(*node, "'" + key + "' belongs to a case, and this is a part");
        }
    }
    likes.push_back(file);
    ETALON_TRY_STEP(AddKeys(root, file, table, likes));
    return std::move(table);
}

}  // namespace

bool IsPart(const fs::path& file) {
    return file.string().ends_with(".part.toml");
}

bool IsFamily(const fs::path& file) {
    return file.string().ends_with(".family.toml");
}

std::span<const std::string_view> CaseKeys() {
    return kKeys;
}

Status<> AddLikeKeys(const fs::path& root, const fs::path& file, toml::table& table) {
    std::vector<fs::path> likes = {file.lexically_normal()};
    ETALON_TRY_STEP(AddKeys(root, file, table, likes));
    table.erase("like");
    return Ok();
}

Result<Keys> ReadKeys(const fs::path& root, const fs::path& file) {
    std::vector<fs::path> likes;
    ETALON_TRY(table, Read(root, file.lexically_normal(), likes));
    Keys keys = {std::move(table), ""};
    const auto other = std::find_if(likes.begin() + 1, likes.end(),
                                    [](const fs::path& one) { return !IsPart(one); });
    if (other != likes.end()) {
        keys.like = other->lexically_relative((root / "cases").lexically_normal())
                        .replace_extension()
                        .generic_string();
    }
    return keys;
}

}  // namespace etalon
