// What is to be mapped: a case over two of its inputs, cell by cell.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "case/case.h"
#include "report/map_record.h"
#include "run/prepared_case.h"

namespace etalon {

// What the user says beside the case; each stands in place of what its [map] says.
struct MapScope {
    std::string over = {};                 // "X,Y"
    std::vector<std::string> ranges = {};  // "X=1e-6:1:log"
    std::string at = {};                   // "n1=1,n2=1.5", input by input
    std::string size = {};                 // "96x64"
    std::string output = {};

    // True where the picture is the [map]'s own, cell by cell.
    bool IsOwn() const {
        return over.empty() && ranges.empty() && at.empty() && size.empty() && output.empty();
    }
};

// A GLSL condition that is evaluated beside the case.
struct SpentCall {
    Call call;
    Signature signature;
};

struct MapPlan {
    MapAxis x;
    MapAxis y;
    // The row of a cell is its index. Of the case's outputs and laws only those that are mapped.
    PreparedCase prepared;
    std::optional<SpentCall> spent;
    // The oracles of the mapped columns, each with the components that are mapped.
    struct Oracle {
        Expression expression;
        std::vector<unsigned> components;
    };
    std::vector<Oracle> oracles;
    Domain domain;               // each input's values: the axes' for all cells, one, or computed
    std::vector<bool> left_out;  // cells that the domain's `where` refuses
    std::string fixed;

    std::uint64_t cells() const { return x.values.size() * y.values.size(); }
};

// The edges of `count` cells from end to end, evenly in value or in its logarithm, and their
// centres as floats.
MapAxis MakeMapAxis(const std::string& name, const MapRange& range, std::uint32_t count);
// The same for whole numbers: the centres rounded, each once, hence as many cells at most; the
// edges halfway between them. The range must hold a whole number.
MapAxis MakeWholeMapAxis(const std::string& name, const MapRange& range, std::uint32_t count);

// Other inputs take what `at` gives, else their first value: the first listed, the low end of a
// range, the first of a sphere's axes, the direct opposite of `against`. Those with an `expr`
// follow. Of several domains it is the first in which both inputs have ranges, else the first.
//
// Fails, beside what is wrong with the scope, for a case without [map] where the scope names no
// inputs, and for one that judges by a specification.
Result<MapPlan> PlanMap(const Case& source, const MapScope& scope);

}  // namespace etalon
