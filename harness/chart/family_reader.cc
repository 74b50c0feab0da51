#include "chart/family_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "case/like.h"
#include "case/read_domain.h"
#include "case/suggestion.h"
#include "numeric/number_text.h"

namespace etalon {
namespace {

// The keys that a case of the family takes, and these.
std::vector<std::string_view> KeysWith(std::initializer_list<std::string_view> own) {
    std::vector<std::string_view> keys(own);
    for (const std::string_view key : CaseKeys()) {
        if (!IsAmong(key, kJudgedKeys) && key != "like") {
            keys.push_back(key);
        }
    }
    return keys;
}

std::string LabelOf(const std::string& member, const std::vector<Setting>& settings) {
    std::string label = member;
    for (const Setting& setting : settings) {
        label += ", " + setting.name + "=" + setting.text;
    }
    return label;
}

// The name below cases/, or the file's alone.
std::string AddressOf(const std::filesystem::path& root, const std::filesystem::path& file) {
    std::string address = file.lexically_relative(root / "cases").generic_string();
    if (address.empty() || address.starts_with("..")) {
        address = file.filename().string();
    }
    for (const std::string_view suffix : {".toml", ".family"}) {
        if (address.ends_with(suffix)) {
            address.resize(address.size() - suffix.size());
        }
    }
    return address;
}

// GLSL has no number without a point but the integers.
std::string GlslNumber(double value) {
    std::string text = Shortest(value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

}  // namespace

FamilyReader::FamilyReader(const std::filesystem::path& root, const std::filesystem::path& file,
                           std::string text)
    : root_(root), reader_(file.string()), text_(std::move(text)) {
    family_.address = AddressOf(root.lexically_normal(), file.lexically_normal());
    family_.file = file;
    family_.root = root;
}

Result<Family> FamilyReader::Read() {
    ETALON_TRY(table, reader_.Parse(text_));
    table_ = std::move(table);
    ETALON_TRY_STEP(ReadHead());
    ETALON_TRY_STEP(ReadScenes());
    ETALON_TRY_STEP(ReadMembers());
    ETALON_TRY_STEP(ReadReference());
    return std::move(family_);
}

Status<> FamilyReader::ReadHead() {
    ETALON_TRY_STEP(
        reader_.OnlyKeys(table_, KeysWith({"quantity", "measure", "unit", "reference",
                                           "published_unit", "scene", "member", "at", "like"})));
    const std::pair<const char*, std::string*> texts[] = {
        {"quantity", &family_.quantity},
        {"description", &family_.description},
        {"unit", &family_.unit},
        {"published_unit", &family_.published_unit}};
    for (const auto& [key, text] : texts) {
        ETALON_TRY(read, reader_.TextAt(table_, key, ""));
        *text = read;
    }
    ETALON_TRY(measure, reader_.TextAt(table_, "measure", "absolute"));
    const ErrorMeasure measures[] = {ErrorMeasure::kAbsolute, ErrorMeasure::kRelative,
                                     ErrorMeasure::kUlp};
    const auto* const found =
        std::find_if(std::begin(measures), std::end(measures),
                     [&](ErrorMeasure one) { return MeasureName(one) == measure; });
    if (found == std::end(measures)) {
        return reader_.Fail(*table_.get("measure"), "'measure' must be absolute, relative or ulp");
    }
    family_.measure = *found;
    if (!family_.unit.empty() && family_.measure != ErrorMeasure::kAbsolute) {
        return reader_.Fail(*table_.get("unit"),
                            "'unit' is of absolute errors, and 'measure' is " + measure);
    }
    return Ok();
}

Result<std::vector<FamilyReader::Entry>> FamilyReader::Entries(
    const char* key, std::span<const std::string_view> keys) {
    std::vector<Entry> entries;
    const toml::node* node = table_.get(key);
    if (node == nullptr) {
        return entries;
    }
    const std::string what = "[[" + std::string(key) + "]]";
    ETALON_TRY(list, reader_.List(*node, what));
    for (const toml::node& entry : *list) {
        ETALON_TRY(table, reader_.Table(entry, what));
        if (!table->contains("name")) {
            return reader_.Fail(*table, "a " + std::string(key) + " without a 'name'");
        }
        ETALON_TRY(name, reader_.TextAt(*table, "name", std::nullopt));
        for (const Entry& other : entries) {
            if (other.name == name) {
                return reader_.Fail(*table,
                                    "two " + std::string(key) + "s are called '" + name + "'");
            }
        }
        ETALON_TRY_STEP(reader_.OnlyKeys(*table, keys));
        entries.push_back({name, table});
    }
    return entries;
}

Status<> FamilyReader::ReadScenes() {
    ETALON_TRY(scenes, Entries("scene", KeysWith({"name", "at", "like"})));
    scenes_ = scenes;
    for (const Entry& scene : scenes_) {
        if (scene.name == "all") {
            return reader_.Fail(*scene.table, "'all' is the name of all scenes together");
        }
        ETALON_TRY(description, reader_.TextAt(*scene.table, "description", ""));
        family_.scenes.push_back({scene.name, description});
    }
    if (scenes_.empty()) {
        family_.scenes.push_back({"", ""});
    }
    return Ok();
}

Result<Setting> FamilyReader::ReadSetting(const std::string& name, const toml::node& node) const {
    if (const auto* integer = node.as_integer()) {
        if (integer->get() < std::numeric_limits<std::int32_t>::min() ||
            integer->get() > std::numeric_limits<std::uint32_t>::max()) {
            return reader_.Fail(node, "setting '" + name + "': " + std::to_string(integer->get()) +
                                          " is no integer of 32 bits");
        }
        return Setting{name, std::to_string(integer->get()), static_cast<double>(integer->get())};
    }
    if (const auto* real = node.as_floating_point();
        real != nullptr && std::isfinite(real->get())) {
        return Setting{name, GlslNumber(real->get()), real->get()};
    }
    if (const auto* flag = node.as_boolean()) {
        return Setting{name, flag->get() ? "true" : "false", std::nullopt};
    }
    if (const auto* text = node.as_string()) {
        return Setting{name, text->get(), std::nullopt};
    }
    return reader_.Fail(node, "setting '" + name + "': a value is a number, a flag or a text");
}

Result<std::vector<FamilyReader::Axis>> FamilyReader::Axes(const toml::table& member) const {
    std::vector<Axis> axes;
    const toml::node* node = member.get("settings");
    if (node == nullptr) {
        return axes;
    }
    ETALON_TRY(settings, reader_.Table(*node, "'settings'"));
    for (const auto& [name, values] : TomlReader::InOrder(*settings)) {
        if (!IsIdentifier(name)) {
            return reader_.Fail(*values, "setting '" + name + "': not a GLSL name");
        }
        ETALON_TRY(list, reader_.List(*values, "setting '" + name + "'"));
        if (list->empty()) {
            return reader_.Fail(*values, "setting '" + name + "' has no values");
        }
        Axis axis = {name, {}};
        for (const toml::node& value : *list) {
            ETALON_TRY(setting, ReadSetting(name, value));
            axis.second.push_back(setting);
        }
        axes.push_back(std::move(axis));
    }
    return axes;
}

Status<> FamilyReader::ReadMembers() {
    ETALON_TRY(members, Entries("member", KeysWith({"name", "settings", "published", "at"})));
    if (members.empty()) {
        return reader_.Fail(1, "a family has members: [[member]] is missing");
    }
    members_ = members;
    for (std::size_t index = 0; index < members_.size(); ++index) {
        const toml::table& table = *members_[index].table;
        FamilyMember member;
        member.name = members_[index].name;
        ETALON_TRY(description, reader_.TextAt(table, "description", ""));
        member.description = description;
        ETALON_TRY(axes, Axes(table));
        std::vector<std::vector<Setting>> combinations = {{}};
        for (const Axis& axis : axes) {
            std::vector<std::vector<Setting>> longer;
            for (const std::vector<Setting>& shorter : combinations) {
                for (const Setting& setting : axis.second) {
                    longer.push_back(shorter);
                    longer.back().push_back(setting);
                }
            }
            combinations = std::move(longer);
        }
        if (const toml::node* published = table.get("published")) {
            ETALON_TRY(figure, reader_.Number(*published, "'published'"));
            if (!(figure > 0)) {
                return reader_.Fail(*published, "'published' must be a positive number");
            }
            if (combinations.size() > 1) {
                return reader_.Fail(*published, "'published' is one figure, and the member has " +
                                                    std::to_string(combinations.size()) +
                                                    " points");
            }
            member.published = figure;
        }
        family_.members.push_back(std::move(member));
        for (const std::vector<Setting>& settings : combinations) {
            ETALON_TRY(point, MakePoint(index, settings));
            for (const FamilyPoint& other : family_.points) {
                if (other.label == point.label) {
                    return reader_.Fail(table, "two points are called '" + point.label + "'");
                }
            }
            family_.points.push_back(std::move(point));
        }
    }
    return Ok();
}

Result<FamilyPoint> FamilyReader::MakePoint(std::size_t member,
                                            const std::vector<Setting>& settings) {
    FamilyPoint point;
    point.member = member;
    point.settings = settings;
    point.label = LabelOf(members_[member].name, settings);
    for (std::size_t scene = 0; scene < family_.scenes.size(); ++scene) {
        ETALON_TRY(one, MakeCase(member, scene, settings));
        point.cases.push_back(std::move(one));
    }
    return point;
}

Status<> FamilyReader::ReadReference() {
    const toml::node* node = table_.get("reference");
    if (node == nullptr) {
        return Ok();
    }
    std::string name;
    std::vector<Setting> settings;
    if (const toml::table* table = node->as_table()) {
        ETALON_TRY_STEP(reader_.OnlyKeys(*table, {"member", "settings"}));
        ETALON_TRY(member, reader_.TextAt(*table, "member", std::nullopt));
        name = member;
        if (const toml::node* chosen = table->get("settings")) {
            ETALON_TRY(chosen_table, reader_.Table(*chosen, "'settings'"));
            for (const auto& [key, value] : TomlReader::InOrder(*chosen_table)) {
                ETALON_TRY(setting, ReadSetting(key, *value));
                settings.push_back(setting);
            }
        }
    } else {
        ETALON_TRY(text, reader_.Text(*node, "'reference'"));
        name = text;
    }
    std::vector<std::size_t> found;
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < family_.points.size(); ++i) {
        const FamilyPoint& point = family_.points[i];
        const std::string& member = family_.members[point.member].name;
        names.push_back(member);
        const bool is_set =
            std::all_of(settings.begin(), settings.end(), [&point](const Setting& wanted) {
                return std::any_of(point.settings.begin(), point.settings.end(),
                                   [&wanted](const Setting& one) {
                                       return one.name == wanted.name && one.text == wanted.text;
                                   });
            });
        if ((member == name || point.label == name) && is_set) {
            found.push_back(i);
        }
    }
    if (found.empty()) {
        const std::string written = "'" + LabelOf(name, settings) + "'";
        return settings.empty() ? reader_.Fail(*node, "'reference' names no member: " + written +
                                                          Suggestion(name, names))
                                : reader_.Fail(*node, "'reference' names no point: " + written);
    }
    if (found.size() > 1) {
        return reader_.Fail(*node, "'reference' names " + std::to_string(found.size()) +
                                       " points; the first is '" +
                                       family_.points[found.front()].label + "'");
    }
    family_.reference = found.front();
    return Ok();
}

}  // namespace etalon
