// The cases of a run, read and prepared on all cores.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "run/case_note.h"
#include "run/conformance.h"
#include "run/prepared_case.h"

namespace etalon {

struct ReadyCase {
    PreparedCase prepared;
    CaseNote note;  // of what it covers only where a catalogue is asked for
};

// In the order of the paths. Of several mistakes the first one, in that order, is the error.
// Where a catalogue is asked for, the ids that a case covers must be in it.
Result<std::vector<ReadyCase>> MakeReady(const RunChoice& choice,
                                         const std::vector<std::string>& paths,
                                         const std::vector<CatalogueEntry>& catalogue);

}  // namespace etalon
