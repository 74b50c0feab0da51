// The case of a member in a scene at its settings.

#include <algorithm>

#include "case/like.h"
#include "case/read_case.h"
#include "chart/family_reader.h"
#include "probe/recipe.h"
#include "run/given.h"
#include "run/prepared_case.h"

namespace etalon {
namespace {

// Keys that a table has of its own, and hands on to no point.
constexpr std::string_view kOwn[] = {"name", "description", "settings", "published", "at", "like"};

// Puts `over` over the keys.
void Lay(toml::table&& over, toml::table& keys) {
    for (auto [key, value] : over) {
        toml::node* const below = keys.get(key);
        if (IsAmong(key.str(), kOwn) || below == nullptr) {
            keys.insert(key, std::move(value));
        } else if ((key.str() == "define" || key.str() == "images") && below->is_table() &&
                   value.is_table()) {
            for (auto [name, entry] : *value.as_table()) {
                below->as_table()->insert_or_assign(name, std::move(entry));
            }
        } else if ((key.str() == "with" || key.str() == "include") && below->is_array() &&
                   value.is_array()) {
            for (toml::node& entry : *value.as_array()) {
                below->as_array()->push_back(std::move(entry));
            }
        } else {
            keys.insert_or_assign(key, std::move(value));
        }
    }
}

}  // namespace

Result<Case> FamilyReader::MakeCase(std::size_t member, std::size_t scene,
                                    const std::vector<Setting>& settings) {
    // A copy of a node forgets where it stands, a moved one does not: hence a table of its own for
    // each point.
    ETALON_TRY(keys, reader_.Parse(text_));
    const auto take = [&keys = keys](const char* key, std::size_t index) {
        return std::move(*keys.get(key)->as_array()->get(index)->as_table());
    };
    toml::table own = take("member", member);
    toml::table around = scenes_.empty() ? toml::table() : take("scene", scene);
    for (const char* const key :
         {"quantity", "measure", "unit", "reference", "published_unit", "scene", "member"}) {
        keys.erase(key);
    }
    ETALON_TRY_STEP(AddLikeKeys(root_, family_.file, keys));
    ETALON_TRY_STEP(AddLikeKeys(root_, family_.file, around));
    std::vector<toml::value<std::string>> held;
    for (toml::table* table : {&keys, &around, &own}) {
        if (toml::node* at = table->get("at")) {
            if (!at->is_string()) {
                return reader_.Fail(*at, "'at' must be a text in quotes");
            }
            held.push_back(std::move(*at->as_string()));
        }
    }
    for (toml::table* table : {&keys, &around, &own}) {
        for (const std::string_view key : kOwn) {
            table->erase(key);
        }
        for (const std::string_view key : kJudgedKeys) {
            table->erase(key);
        }
    }
    Lay(std::move(around), keys);
    Lay(std::move(own), keys);
    for (const char* const key : {"source", "call"}) {
        if (!keys.contains(key)) {
            return reader_.Fail(*members_[member].table, "member '" + members_[member].name +
                                                             "' has no '" + key +
                                                             "', and neither has the family");
        }
    }
    ETALON_TRY(read, ReadCaseKeys(reader_, keys, Purpose::kMeasure));
    ETALON_TRY_STEP(CheckRecipe(keys));
    read.path = family_.address;
    read.file = family_.file;
    read.root = root_;
    ETALON_TRY_STEP(CheckFiles(read));
    for (const Setting& setting : settings) {
        read.define[setting.name] = setting.text;
    }
    for (const toml::value<std::string>& at : held) {
        ETALON_TRY_STEP(HoldInputs(at, read));
    }
    ETALON_TRY_STEP(Count(read, keys.contains("accept"), *members_[member].table));
    return std::move(read);
}

Status<> FamilyReader::CheckRecipe(const toml::table& keys) const {
    const toml::node* recipes = keys.get("recipes");
    if (recipes == nullptr) {
        return Ok();
    }
    if (recipes->as_array()->size() > 1) {
        return reader_.Fail(*recipes, "'recipes': a chart has one");
    }
    for (const toml::node& recipe : *recipes->as_array()) {
        if (const auto read = ParseRecipe(recipe.as_string()->get()); !read) {
            return reader_.Fail(recipe, read.error().message);
        }
    }
    return Ok();
}

Status<> FamilyReader::HoldInputs(const toml::value<std::string>& at, Case& held) const {
    std::vector<Column> columns;
    for (const Input& input : held.domains.front().inputs) {
        const auto own = ColumnsOf(input.name, input.type);
        columns.insert(columns.end(), own->begin(), own->end());
    }
    const auto given = ReadGiven(columns, at.get(), "'at'");
    if (!given) {
        return reader_.Fail(at, given.error().message);
    }
    std::size_t first = 0;
    for (const Input& input : held.domains.front().inputs) {
        const std::size_t size = ColumnsOf(input.name, input.type)->size();
        std::vector<double> value;
        for (std::size_t k = first; k < first + size; ++k) {
            if ((*given)[k]) {
                value.push_back(WordValue(columns[k].scalar, *(*given)[k]));
            }
        }
        first += size;
        if (value.empty()) {
            continue;
        }
        if (value.size() != size) {
            return reader_.Fail(at, "'at': of '" + input.name + "' not all components are given");
        }
        for (Domain& domain : held.domains) {
            for (Input& other : domain.inputs) {
                if (other.name == input.name) {
                    Input single;
                    single.name = other.name;
                    single.type = other.type;
                    single.values = {value};
                    single.line = other.line;
                    other = single;
                }
            }
        }
    }
    return Ok();
}

Status<> FamilyReader::Count(const Case& read, bool is_judged, const toml::table& member) {
    const bool has_truth = !read.expectations.empty();
    const bool is_search = std::any_of(
        read.expectations.begin(), read.expectations.end(),
        [](const Expectation& one) { return one.accept.shares && one.accept.shares->beyond; });
    if (is_search && read.expectations.size() > 1) {
        return reader_.Fail(member, "a search has one oracle: that of the way to the hit");
    }
    for (const Expectation& one : read.expectations) {
        if (!one.spec.empty()) {
            return Error{one.place.Text() + "'spec': errors are measured against an oracle"};
        }
    }
    if (cases_ == 0) {
        recipes_ = read.recipes;
    }
    if (read.recipes != recipes_) {
        return reader_.Fail(member, "'recipes': all members have the same in all scenes");
    }
    const std::pair<bool, bool*> facts[] = {{has_truth, &family_.has_truth},
                                            {is_judged, &family_.is_judged},
                                            {is_search, &family_.is_search}};
    constexpr const char* kNames[] = {"an oracle", "an 'accept'", "a 'beyond' in 'accept'"};
    for (std::size_t i = 0; i < std::size(facts); ++i) {
        if (cases_ > 0 && *facts[i].second != facts[i].first) {
            return reader_.Fail(member, "all members have " + std::string(kNames[i]) +
                                            " in all scenes, or none has");
        }
        *facts[i].second = facts[i].first;
    }
    ++cases_;
    return Ok();
}

}  // namespace etalon
