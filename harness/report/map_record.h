// What a map found: how a case behaves over two of its inputs, as plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/record.h"

namespace etalon {

// What became of a cell. Everything from kRefused to kSpent is not accepted.
enum class MapMark : std::uint8_t {
    kHolds,
    kRefused,  // a number beyond the tolerance, or a broken law
    kMissed,   // of a search: there is a hit, and none was found
    kWrong,    // of a search: another hit than the first, or one where there is none
    kNan,
    kInfinity,
    kSpent,      // not accepted, a number, and the iteration budget was used up
    kUndecided,  // no truth there, or no input of the case
    kCrash,      // the device gave no results: it crashed, hung, or rejected the program
};
inline constexpr const char* kMapMarkNames[] = {"holds",    "refused", "missed",    "wrong", "nan",
                                                "infinity", "spent",   "undecided", "crash"};
inline constexpr std::size_t kMapMarks = 9;

// What is predicted of a cell.
enum class MapForecast : std::uint8_t { kOpen, kSafe, kFails };

struct MapAxis {
    std::string name;
    bool is_log = false;
    bool is_whole = false;       // of an integer: cells reach halfway to the next value
    std::vector<double> edges;   // of the cells, ascending, one more than there are cells
    std::vector<double> values;  // at which the cells were evaluated; exact
};

// Cell (ix, iy) of all that follows stands at iy * x.values.size() + ix.
struct MappedDevice {
    std::string device;
    std::string recipe;
    std::string driver;         // with its version
    std::string reason;         // why there are no results; empty where there are
    std::vector<double> error;  // in the map's measure; infinite for NaN, NaN where undecided.
                                // Empty on a device that cannot run the program
    std::vector<MapMark> mark;  // as many
    std::optional<Observation> worst;  // by share of the tolerance
};

struct MapAgreement {
    std::string device;
    std::uint64_t safe = 0;  // cells
    std::uint64_t safe_held = 0;
    std::uint64_t fails = 0;
    std::uint64_t failed = 0;

    bool Holds() const { return safe == safe_held && fails == failed; }
};

struct MapContradiction {
    std::string device;
    std::string recipe;
    std::string what;  // "predicted to fail, and it holds"
    std::vector<std::pair<std::string, Value>> inputs;
    std::string repeat;
};

struct PredictionSeen {
    std::string fails;  // expressions; empty where not given
    std::string safe;
    std::string because;
    std::vector<MapForecast> cells;
    std::vector<MapAgreement> agreement;            // a row for each device with results
    std::optional<MapContradiction> contradiction;  // the first
};

struct MapRecord {
    std::string case_path;
    std::string description;
    std::string output;     // "result", "result.x, result.y", "law 'energy'"
    std::string measure;    // "ulp", "absolute", "relative": of the errors
    std::string tolerance;  // "ulp 4"
    MapAxis x;
    MapAxis y;
    std::string fixed;    // the other inputs: "n1=1.6"
    bool search = false;  // whether cells can be missed or wrong
    std::vector<MappedDevice> devices;
    // Of the oracle in those of the two inputs that are floats, the sum of |x df/dx| / |f|: how
    // much larger the relative error of the result is than theirs. Empty where there is none.
    std::vector<double> condition;
    // The greatest distance of two devices' results, in ulp. Empty where fewer than two have any.
    std::vector<double> disagreement;
    std::optional<PredictionSeen> prediction;
    std::string repeat;

    bool Good() const;  // no crash, and nothing contradicts the prediction
};

std::string MapText(const MapRecord& map);
std::string MapJson(const MapRecord& map);
// "NAME on DEVICE (RECIPE): at INPUTS: predicted to hold, ..." and the command that repeats it.
std::string ContradictionText(const MapRecord& map);

}  // namespace etalon
