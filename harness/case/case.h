// A case: one TOML file that names a call, its inputs, the truth and what is accepted.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "case/case_map.h"
#include "case/domain.h"
#include "case/expression.h"
#include "case/figure.h"
#include "case/image_source.h"
#include "case/place.h"
#include "numeric/acceptance.h"

namespace etalon {

// What one output of the call (or one law) must meet.
struct Expectation {
    std::string output;               // "result" or the name of an out parameter
    std::optional<Expression> truth;  // over the inputs, bound to the first domain's in their
                                      // order; absent where `spec` judges without one
    Acceptance accept;
    std::string spec;  // "vulkan-1.3", or "device" for the device's own: what it allows is
                       // accepted, and `accept` judges nothing
    Place place;       // of the acceptance
};

enum class Relation : std::uint8_t { kEqual, kLessEqual, kGreaterEqual, kLess, kGreater };

// A property that needs no oracle: `left relation right`, both GLSL expressions over the inputs,
// both evaluated on the device. `within` is measured at the right side's value.
struct Law {
    std::string name;
    std::string left;
    std::string right;
    Relation relation = Relation::kEqual;
    Acceptance within;
    Place place;
};

// A failure that is known: where, and why. A case that passes where it is expected to fail is a
// failure too.
struct ExpectedFailure {
    std::string device;   // pattern with * and ?
    std::string recipe;   // pattern
    std::string law;      // pattern of the law's name; empty: whatever was refused
    std::string verdict;  // "fail", "nonconforming", "crash" or "timeout"
    std::string status;   // "bug" (of the driver), "method" (wrong mathematics), "rounding" (right
                          // mathematics that loses its digits), "unimplemented" or "undefined"
                          // (the specification leaves the value open)
    std::string cause;
    std::string link;
    std::optional<Figure> figure;  // of a "fail": no other failure is this one
};

struct Case {
    std::string path;  // "optics/fresnel/reflectance"
    std::string like;  // the path of the case whose keys it has where it has none; empty: of none
    std::filesystem::path file;
    std::filesystem::path
        root;  // the folder that `source` and `with` are relative to (it holds cases/)
    std::string description;
    std::string source;
    Place source_place;
    std::string call;
    Place call_place;
    std::string family;
    std::vector<std::string> covers;  // ids of what the case shows: "F4", "D14"
    Place covers_place;
    std::map<std::string, std::string> define;
    std::vector<std::string> include;
    std::vector<std::string> with;  // sources, or NAME=IMAGE
    Place with_place;
    std::vector<ImageSource> images;
    std::map<std::string, std::string> out;  // name -> GLSL type
    std::vector<std::string> recipes;        // empty: the default set
    std::vector<Expectation> expectations;
    std::vector<Law> laws;
    std::vector<ExpectedFailure> expected_failures;
    std::vector<Domain> domains;
    std::optional<CaseMap> map;
    std::uint64_t seed = 1;
};

// Reads one case. `path` is its address below cases/, without ".toml". Errors name file and line.
// The file is cases/PATH.toml below the root; its keys are described in case.cc.
Result<Case> ReadCase(const std::filesystem::path& root, const std::string& path);

// Makes it the case of a deep run: inputs that have a `full` count take it.
void TakeFullCounts(Case& deep);

// Fails where an acceptance could refuse nothing: at every row of the expanded domain each of 0,
// -truth, 2 truth and truth + 1 would pass; or where there is no truth at any row.
Status<> CheckAcceptance(const Case& checked, const Table& table);

// The addresses of all cases under root/cases, sorted; files NAME.part.toml and NAME.family.toml
// are none. Fails where the folder is missing.
Result<std::vector<std::string>> ListCases(const std::filesystem::path& root);

}  // namespace etalon
