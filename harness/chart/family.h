// A family: several functions for one quantity, to be set side by side.
//
// A TOML file, cases/TOPIC/NAME.family.toml or any file of a user's:
//
//   quantity, description   what all members compute
//   measure                 of errors: "absolute" (default), "relative" or "ulp"
//   unit                    of absolute errors
//   reference               the member to whose time the others' are set in ratio: its name, or the
//                           label of one of its points, or { member = "...", settings = { ... } };
//                           default: the first point
//   published_unit          of the figures under `published`
//   [[member]]              name, description, settings, published
//   [[scene]]               name, description: where all members are measured; without any there is
//                           one scene, which has no name
//
// and, at the top for all, in a scene and in a member, the keys of a case that say what is called
// with which inputs, and what is true: source, call, with, include, define, out, images, domain,
// combine, where, seed, recipes, oracle, accept; at the top and in a scene `like` too, which stands
// below the keys beside it. `at = "level=-0.25,v.x=0"` holds inputs of the domain at single values.
// A member's keys stand over a scene's, these over the family's: `define` and `images` name by
// name, `with` and `include` one list behind the other, each other key in place of the one below.
//
// `settings = { STEPS = [8, 16], BITS = [4] }`: each combination is a point of the chart, in which
// these are macros. Without an oracle a family has costs and no errors. `accept` says what a
// member must not do: a point at which it refuses a value is never on the front and holds no bound.
// With `beyond` in it the family is a search (numeric/acceptance.h), of which it says only which
// hits are other hits, and what share of hits may be missed or be others.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "case/case.h"

namespace etalon {

enum class ErrorMeasure : std::uint8_t { kAbsolute, kRelative, kUlp };
std::string_view MeasureName(ErrorMeasure measure);  // "absolute"

struct Setting {
    std::string name;
    std::string text;              // of the macro
    std::optional<double> number;  // where it is one
};

struct FamilyMember {
    std::string name;
    std::string description;
    std::optional<double> published;
};

struct FamilyScene {
    std::string name;
    std::string description;
};

// One member at one combination of its settings.
struct FamilyPoint {
    std::size_t member = 0;  // among Family::members
    std::vector<Setting> settings;
    std::string label;        // "linear + binary, LINEAR=24, BINARY=6"
    std::vector<Case> cases;  // one for each scene
};

struct Family {
    std::string address;  // "relief/search"; of a file outside cases/ its name
    std::filesystem::path file;
    std::filesystem::path root;  // what sources and images are relative to
    std::string quantity;
    std::string description;
    ErrorMeasure measure = ErrorMeasure::kAbsolute;
    std::string unit;
    std::string published_unit;
    std::vector<FamilyMember> members;
    std::vector<FamilyScene> scenes;  // at least one
    std::vector<FamilyPoint> points;  // by member, the last setting changing first
    std::size_t reference = 0;        // among the points
    bool has_truth = false;           // there is an oracle, for every point in every scene
    bool is_judged = false;           // `accept` is given, likewise
    bool is_search = false;
};

// Reads a family: each of its points is a case that could be prepared. Errors name file and line.
Result<Family> ReadFamily(const std::filesystem::path& root, const std::filesystem::path& file);

// The addresses of all families under root/cases, sorted. Fails where the folder is missing.
Result<std::vector<std::string>> ListFamilies(const std::filesystem::path& root);

// The `quantity` of a family's file, or nothing; no other key is looked at.
Result<std::string> ReadQuantity(const std::filesystem::path& file);

// Where a family is that is named by its address, or by a TOML file.
struct FamilyPlace {
    std::filesystem::path root;
    std::filesystem::path file;
};

// A name that ends in ".toml" is a file: below a folder `cases` its root is the folder that holds
// it, else the file's own folder. Any other name is an address below `root`/cases; an empty `root`
// is found at or above the current folder. A `root` that is given is the file's root, too.
Result<FamilyPlace> FindFamily(const std::filesystem::path& root, const std::string& name);

}  // namespace etalon
