// `etalon chart`: accuracy and cost of each point of a family, on each device.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "base/result.h"
#include "chart/family.h"
#include "report/chart_record.h"
#include "run/devices.h"

namespace etalon {

struct ChartChoice {
    FamilyPlace place;
    std::string name;                  // of the family, as repeat commands write it
    std::string options;               // for these: " --root DIR", or empty
    std::vector<std::string> scenes;   // names or patterns; empty: all
    std::vector<std::string> members;  // names or labels, or patterns of them; empty: all
    std::string recipe;                // empty: the family's, else the device's own
    std::string at;                    // one input, "x=1,v.x=0.5", in place of the domain
    double seconds = 1;                // of timing, for each point on each device
    bool times = true;                 // else accuracy and counts alone, the same each time
    bool first_device_only = false;    // of those that the choice names
    DeviceChoice devices;
};

// What a point costs is the mean over the scenes, whether it is time or counts; its errors and
// shares in all scenes are those of all rows together, the worst being the worst of any. A search
// is refused in all scenes where it is in one. The reference is timed, whichever members are
// chosen.
//
// Fails for what the user got wrong: whatever a device makes of a point is in its record. Notes
// tell what went wrong once and not again.
Result<ChartRecord> MakeChart(const ChartChoice& choice, std::ostream& notes);

}  // namespace etalon
