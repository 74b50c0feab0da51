// Measures the points of a family on devices, scene by scene.
#pragma once

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "chart/accuracy.h"
#include "chart/family.h"
#include "cost/cost.h"
#include "run/runner.h"

namespace etalon {

// What a point showed on one device, in one scene or in several.
struct Found {
    std::string recipe;
    std::string reason;   // why something is absent, or empty
    bool failed = false;  // the device crashed, hung, or refused the program
    std::optional<Errors> errors;
    std::optional<TimeEstimate> time;
    std::optional<CountedCall> counts;

    void AddReason(const std::string& text);
};

// What to measure, by index into the family.
struct MeasurePlan {
    std::vector<std::size_t> points;
    std::vector<std::size_t> scenes;
    std::string recipe;  // empty: the family's, else the device's own
    std::string at;      // one input in place of the domain; empty: the domain
    double seconds = 0;  // of timing, for each point and device; 0: no times
};

// By device, then as the plan has points and scenes: found[device][point][scene]. A call whose
// images or sources are wrong is the error; what a device makes of it is found.
using FoundOnDevices = std::vector<std::vector<std::vector<Found>>>;
Result<FoundOnDevices> MeasureFamily(const Family& family, const MeasurePlan& plan,
                                     const std::vector<std::unique_ptr<Runner>>& runners,
                                     std::ostream& notes);

// A point's scenes together: times and counts are the mean over the scenes, the worst count the
// worst of any. What one scene lacks is lacking.
Found Together(const std::vector<Found>& of_scenes);

}  // namespace etalon
