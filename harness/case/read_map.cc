#include "case/read_map.h"

#include <algorithm>
#include <cmath>

#include "case/read_domain.h"
#include "case/suggestion.h"

namespace etalon {
namespace {

class MapReader {
  public:
    MapReader(const TomlReader& reader, const toml::table& table,
              const std::vector<Domain>& domains)
        : reader_(reader), table_(table), domains_(domains) {}

    Result<CaseMap> Read() {
        ETALON_TRY_STEP(reader_.OnlyKeys(table_, {"over", "ranges", "at", "size", "output", "spent",
                                                  "fails", "safe", "because"}));
        map_.place = reader_.PlaceOf(table_);
        ETALON_TRY_STEP(ReadRanges());
        ETALON_TRY_STEP(ReadOver());
        ETALON_TRY_STEP(ReadSize());
        ETALON_TRY_STEP(ReadTexts());
        ETALON_TRY_STEP(ReadPredictions());
        return std::move(map_);
    }

  private:
    // Ranges come first: an axis may have its range from there alone.
    Status<> ReadRanges() {
        const toml::node* node = table_.get("ranges");
        if (node == nullptr) {
            return Ok();
        }
        ETALON_TRY(ranges, reader_.Table(*node, "'ranges'"));
        for (const auto& [name, entry] : TomlReader::InOrder(*ranges)) {
            const std::string what = "'ranges': '" + name + "'";
            ETALON_TRY(table, reader_.Table(*entry, what));
            ETALON_TRY_STEP(reader_.OnlyKeys(*table, {"range", "sample"}));
            const toml::node* ends = table->get("range");
            if (ends == nullptr) {
                return reader_.Fail(*entry, what + ": 'range' is missing");
            }
            ETALON_TRY(list, reader_.List(*ends, what + ": 'range'"));
            if (list->size() != 2) {
                return reader_.Fail(*ends, what + ": 'range' must be [low, high]");
            }
            ETALON_TRY(low, reader_.Number((*list)[0], what + ": 'range'"));
            ETALON_TRY(high, reader_.Number((*list)[1], what + ": 'range'"));
            ETALON_TRY(sample, reader_.TextAt(*table, "sample", "linear"));
            if (sample != "linear" && sample != "log") {
                return reader_.Fail(*table->get("sample"),
                                    what + ": 'sample' must be linear or log");
            }
            const MapRange range = {low, high, sample == "log"};
            if (const std::string why = WhyNoRange(range); !why.empty()) {
                return reader_.Fail(*ends, what + ": " + why);
            }
            map_.ranges.emplace(name, range);
        }
        return Ok();
    }

    Status<> ReadOver() {
        const toml::node* node = table_.get("over");
        if (node == nullptr) {
            return reader_.Fail(table_, "'over' is missing: it names the two inputs of the map");
        }
        ETALON_TRY(over, reader_.Texts(*node, "'over'"));
        if (over.size() != 2) {
            return reader_.Fail(*node, "'over' must name two inputs");
        }
        for (const std::string& name : over) {
            if (const std::string why = WhyNoAxis(domains_, name); !why.empty()) {
                return reader_.Fail(*node, "'over': " + why);
            }
            if (!map_.ranges.contains(name) && !OwnMapRange(domains_, name)) {
                return reader_.Fail(
                    *node, "'over': '" + name + "' has no range in the domain; 'ranges' gives one");
            }
        }
        if (over[0] == over[1]) {
            return reader_.Fail(*node, "'over' names '" + over[0] + "' twice");
        }
        map_.x = over[0];
        map_.y = over[1];
        for (const auto& [name, range] : map_.ranges) {
            if (name != map_.x && name != map_.y) {
                return reader_.Fail(*table_.get("ranges"),
                                    "'ranges': '" + name + "' is not what the map is over");
            }
        }
        return Ok();
    }

    Status<> ReadSize() {
        const toml::node* node = table_.get("size");
        if (node == nullptr) {
            return Ok();
        }
        ETALON_TRY(list, reader_.List(*node, "'size'"));
        std::vector<std::uint64_t> counts;
        for (const toml::node& entry : *list) {
            ETALON_TRY(count, reader_.Count(entry, "'size'"));
            counts.push_back(count);
        }
        if (counts.size() != 2 || std::min(counts[0], counts[1]) < 1 ||
            std::max(counts[0], counts[1]) > kMostMapCells) {
            return reader_.Fail(*node, "'size' must be [width, height], each from 1 to " +
                                           std::to_string(kMostMapCells));
        }
        map_.width = static_cast<std::uint32_t>(counts[0]);
        map_.height = static_cast<std::uint32_t>(counts[1]);
        return Ok();
    }

    Status<> ReadTexts() {
        struct Entry {
            const char* key;
            std::string* text;
            Place* place;
        };
        const Entry entries[] = {{"at", &map_.at, &map_.at_place},
                                 {"output", &map_.output, &map_.output_place},
                                 {"spent", &map_.spent, &map_.spent_place},
                                 {"because", &map_.because, nullptr}};
        for (const Entry& entry : entries) {
            const toml::node* node = table_.get(entry.key);
            if (node == nullptr) {
                continue;
            }
            ETALON_TRY(text, reader_.Text(*node, "'" + std::string(entry.key) + "'"));
            if (text.empty()) {
                return reader_.Fail(*node, "'" + std::string(entry.key) + "' is empty");
            }
            *entry.text = text;
            if (entry.place != nullptr) {
                *entry.place = reader_.PlaceOf(*node);
            }
        }
        return Ok();
    }

    Status<> ReadPredictions() {
        const std::pair<const char*, std::optional<MapPrediction>*> predictions[] = {
            {"fails", &map_.fails}, {"safe", &map_.safe}};
        const std::vector<Symbol> symbols = SymbolsOf(domains_.front());
        for (const auto& [key, prediction] : predictions) {
            const toml::node* node = table_.get(key);
            if (node == nullptr) {
                continue;
            }
            ETALON_TRY(expression, reader_.Formula(*node, "'" + std::string(key) + "'"));
            ETALON_TRY_STEP(CheckExpression(reader_, *node, expression, symbols, 1));
            *prediction = MapPrediction{expression, reader_.PlaceOf(*node)};
        }
        const bool predicts = map_.fails || map_.safe;
        if (predicts && map_.because.empty()) {
            return reader_.Fail(table_, "'because' is missing: the theory that predicts this");
        }
        if (!predicts && !map_.because.empty()) {
            return reader_.Fail(*table_.get("because"),
                                "'because' belongs to 'fails' or 'safe', and neither is there");
        }
        return Ok();
    }

    const TomlReader& reader_;
    const toml::table& table_;
    const std::vector<Domain>& domains_;
    CaseMap map_;
};

}  // namespace

std::optional<MapRange> OwnMapRange(const std::vector<Domain>& domains, const std::string& name) {
    for (const Domain& domain : domains) {
        for (const Input& input : domain.inputs) {
            if (input.name == name && input.range) {
                return MapRange{input.range->first, input.range->second, input.sample == "log"};
            }
        }
    }
    return std::nullopt;
}

std::string WhyNoAxis(const std::vector<Domain>& domains, const std::string& name) {
    std::vector<std::string_view> names;
    for (const Input& input : domains.front().inputs) {
        if (input.name == name) {
            return input.type == "float" || IsWhole(input.type)
                       ? ""
                       : "'" + name + "' is of type " + input.type +
                             ", and a map is over floats or integers";
        }
        names.push_back(input.name);
    }
    return "the case has no input '" + name + "'" + Suggestion(name, names);
}

bool IsWhole(const std::string& type) {
    return type == "int" || type == "uint";
}

std::string WhyNoRange(const MapRange& range) {
    const auto low = static_cast<float>(range.low);
    const auto high = static_cast<float>(range.high);
    if (!std::isfinite(low) || !std::isfinite(high)) {
        return "the ends of the range must be finite floats";
    }
    if (!(low < high)) {
        return "the range's ends are not in order";
    }
    if (range.is_log && !(low > 0)) {
        return "a logarithmic range must be positive";
    }
    return "";
}

Result<CaseMap> ReadMap(const TomlReader& reader, const toml::table& table,
                        const std::vector<Domain>& domains) {
    return MapReader(reader, table, domains).Read();
}

}  // namespace etalon
