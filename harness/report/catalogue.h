// The catalogue: what the sources describe, by id, and what a run has found of each.
#pragma once

#include <string>
#include <vector>

#include "report/record.h"

namespace etalon {

struct CatalogueEntry {
    std::string id;  // "F4"; a defect begins with D
    std::string name;
    std::string source;  // document and equation
    std::string reason;  // why no case can show it and only reading does; else empty
};

// Ids that no case of the run covers, though numbers can show them, in the catalogue's order.
std::vector<std::string> MissingIds(const std::vector<CatalogueEntry>& entries,
                                    const RunRecord& run);

// A table of the functions and one of the defects, a row for each id in the catalogue's order: its
// functions by file, cases, oracles, the worst error on each device; of a defect what the published
// form was expected to show and what it did, and how the hardened form does. Functions in
// shaders/published are published, all others hardened. `chosen_only` leaves out the ids that no
// case of the run covers, for a run of some cases.
std::string CatalogueMarkdown(const std::vector<CatalogueEntry>& entries, const RunRecord& run,
                              bool chosen_only);

}  // namespace etalon
