// Plans of maps from the text of a case.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "case/case.h"
#include "map/map_plan.h"
#include "numeric/ulp.h"
#include "support/folder.h"

namespace etalon {

class PlannedTest : public testing::Test {
  protected:
    PlannedTest() {
        folder_.Write("f.glsl",
                      "float f(float a, float b) { return a + b; }\n"
                      "vec2 both(float a, float b) { return vec2(a, b); }\n"
                      "float three(vec3 v, float a, float b) { return v.x + a + b; }\n");
    }

    Result<MapPlan> Plan(const std::string& text, const MapScope& scope = {}) {
        folder_.Write("cases/c.toml", "source = \"f.glsl\"\n" + text);
        const auto source = ReadCase(folder_.path(), "c");
        if (!source) {
            return source.error();
        }
        return PlanMap(*source, scope);
    }
    std::string Why(const std::string& text, const MapScope& scope = {}) {
        const auto plan = Plan(text, scope);
        return plan ? "" : plan.error().message;
    }

    // A column of all cells.
    static std::vector<float> Cells(const MapPlan& plan, const std::string& name) {
        const Table& table = plan.prepared.table;
        std::vector<float> values;
        for (std::size_t column = 0; column < table.columns.size(); ++column) {
            for (std::uint64_t row = 0; table.columns[column].name == name && row < table.rows;
                 ++row) {
                values.push_back(FromBits(table.At(row, column)));
            }
        }
        return values;
    }

    static std::vector<std::uint32_t> Words(const std::vector<float>& values) {
        std::vector<std::uint32_t> words;
        for (const float value : values) {
            words.push_back(ToBits(value));
        }
        return words;
    }

    Folder folder_;
};

}  // namespace etalon
