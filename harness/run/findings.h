// Finds, among the records of a run, results that a specification does not allow, and makes each
// into a file that other tools can run.
#pragma once

#include <map>
#include <string>

#include "report/record.h"
#include "run/devices.h"
#include "run/evaluation.h"
#include "run/prepared_case.h"

namespace etalon {

struct FoundOutside {
    std::vector<Finding> findings;                   // in the order of the devices and cases
    std::map<std::string, std::string> reproducers;  // text by file name
};

// `cases` are the run's own, by address. Of each case and implementation (devices of one
// fingerprint are one) the record whose value lies furthest outside is looked at once more, at that
// input alone. In doubt is what the strict evaluation does not confirm, and what no file can show:
// laws, images, devices that are neither Vulkan nor OpenGL.
FoundOutside FindOutside(const RunRecord& run, const std::map<std::string, const Case*>& cases,
                         const std::shared_ptr<Programs>& programs);

}  // namespace etalon
