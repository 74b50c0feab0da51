#include "run/read_catalogue.h"

#include <algorithm>

#include "base/file.h"
#include "case/toml_reader.h"

namespace etalon {

Result<std::vector<CatalogueEntry>> ReadCatalogue(const std::filesystem::path& root) {
    const std::filesystem::path file = root / "shaders/catalogue.toml";
    ETALON_TRY(text, ReadTextFile(file));
    const TomlReader reader(file.string());
    ETALON_TRY(table, reader.Parse(text));
    std::vector<CatalogueEntry> entries;
    for (const auto& [id, node] : TomlReader::InOrder(table)) {
        ETALON_TRY(keys, reader.Table(*node, "'" + id + "'"));
        ETALON_TRY_STEP(reader.OnlyKeys(*keys, {"name", "source", "seen", "reason"}));
        ETALON_TRY(name, reader.TextAt(*keys, "name", std::nullopt));
        ETALON_TRY(source, reader.TextAt(*keys, "source", std::nullopt));
        std::string reason;
        if (const toml::node* seen = keys->get("seen")) {
            ETALON_TRY(how, reader.Text(*seen, "'seen'"));
            if (how != "by reading") {
                return reader.Fail(*seen, "'seen' must be \"by reading\"");
            }
            ETALON_TRY(given, reader.TextAt(*keys, "reason", std::nullopt));
            reason = given;
        } else if (const toml::node* idle = keys->get("reason")) {
            return reader.Fail(*idle, "'reason' belongs to seen = \"by reading\"");
        }
        entries.push_back({id, name, source, reason});
    }
    return entries;
}

Status<> CheckCovers(const Case& source, const std::vector<CatalogueEntry>& entries) {
    for (const std::string& id : source.covers) {
        if (std::none_of(entries.begin(), entries.end(),
                         [&id](const CatalogueEntry& entry) { return entry.id == id; })) {
            return Error{source.covers_place.Text() + "'covers': the catalogue has no " + id};
        }
    }
    return Ok();
}

}  // namespace etalon
