// What a chart of a family found, as plain data: accuracy beside cost, for each point on each
// device in each scene and in all scenes together.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/record.h"

namespace etalon {

// Errors are in the chart's measure. The worst, the percentile and the root mean square of a search
// are over its right hits: hits of the truth that it finds within the family's `beyond`; those that
// it misses and those that are other hits are told by their shares, as numeric/acceptance.h has
// them. A row's error is the greatest of its components'. NaN where no row has an error.
struct ChartAccuracy {
    std::uint64_t rows = 0;
    std::uint64_t judged = 0;     // without the undecided
    std::uint64_t undecided = 0;  // rows at which the oracle does not know the truth
    double worst = 0;
    double p999 = 0;  // the least error that 99.9 % of the rows do not exceed; below 1000 rows the
                      // worst
    double rms = 0;
    double bits = 0;  // -log2 of the worst absolute error over the greatest |truth|; infinite where
                      // all is exact
    std::uint64_t not_finite = 0;  // rows with NaN or an infinity where the truth is finite
    double missed = 0;             // of a search: share of the hits
    double wrong = 0;              // of a search: share of the judged rows
    std::uint64_t refused = 0;     // values that the family's `accept` refuses; none of a search
    // The first wrong hit of a search, else the first missed one, else the row of the worst error;
    // absent where no row has one.
    std::optional<Observation> shown;
    std::string repeat;  // the command that runs this input again
};

// Of one call. Ratios are to the chart's reference on the same device in the same scene; absent
// where that has no time. The spread is the point's own.
struct ChartCost {
    struct Ratio {
        double value = 0;
        double low = 0;
        double high = 0;
    };
    double nanoseconds = 0;
    double low = 0;
    double high = 0;
    std::optional<Ratio> ratio;
    std::uint64_t rounds = 0;
    std::string clock;
};

// Operations executed by one call, by class.
struct ChartCounts {
    double arithmetic = 0;
    double division = 0;
    double special = 0;
    double comparison = 0;
    double integer = 0;
    double fetch = 0;
    double other = 0;
    double total = 0;
};

struct ChartSetting {
    std::string name;
    std::string text;
    std::optional<double> number;  // where it is one
};

// A member at one combination of its settings, on one device, in one scene or in "all".
struct ChartPoint {
    std::string member;
    std::string description;
    std::vector<ChartSetting> settings;
    std::string label;
    std::string scene;
    std::string device;
    std::string recipe;
    std::string reason;    // why numbers are missing; empty where none are
    bool failed = false;   // the device crashed, hung, or refused the program
    bool refused = false;  // the family's `accept` does: never on the front, and holds no bound
    std::optional<ChartAccuracy> accuracy;
    std::optional<ChartCost> cost;
    std::optional<ChartCounts> mean;   // over the rows
    std::optional<ChartCounts> worst;  // of the row with most in total
    std::optional<double> published;
    std::optional<double> published_ratio;  // to the reference's
    bool front = false;
};

// The cheapest point that holds a bound, among those of a device in a scene.
struct ChartBound {
    std::string device;
    std::string scene;
    double bound = 0;
    std::string text;                  // "1/255"
    std::string by;                    // which error holds it: "worst" or "p999"
    std::optional<std::size_t> point;  // among the chart's
};

struct ChartScene {
    std::string name;
    std::string description;
};

struct ChartRecord {
    std::string family;
    std::string quantity;
    std::string description;
    std::string measure;  // "absolute", "relative", "ulp"
    std::string unit;     // of absolute errors
    bool search = false;
    std::string reference;  // the label of the point that ratios are to
    std::string published_unit;
    std::string cost_by;  // what front and bounds take for the cost: "time", or "operations" where
                          // no times were taken
    std::string at;       // the one input at which it was made; empty: the whole domain
    std::vector<ChartScene> scenes;
    std::vector<DeviceInfo> devices;
    std::vector<ChartPoint> points;  // by device, then scene ("all" last), then as in the family
    std::vector<ChartBound> bounds;
};

// What front and bounds take for the cost of a point; NaN where it has none.
double CostOf(const ChartRecord& chart, const ChartPoint& point);

// A line for each point, by ascending cost, and the bounds, for all scenes together; and before
// them for each scene, where that is asked for.
std::string ChartText(const ChartRecord& chart, bool with_scenes);
std::string ChartJson(const ChartRecord& chart);

}  // namespace etalon
