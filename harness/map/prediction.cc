#include "map/prediction.h"

#include <algorithm>
#include <cmath>

#include "base/file.h"
#include "map/cells.h"
#include "run/observe.h"

namespace etalon {
namespace {

// Where the expression is certainly true.
Result<std::vector<bool>> TrueAt(const MapPrediction& prediction, const Table& table) {
    Expression expression = prediction.expression;
    const auto components = expression.Bind(Symbols(table.variables));
    if (!components) {
        return Error{prediction.place.Text() + components.error().message};
    }
    const auto numbers = Numbers(table, 0, table.rows);
    std::vector<const double*> pointers;
    for (const std::vector<double>& column : numbers) {
        pointers.push_back(column.data());
    }
    std::vector<Expression::Value> values;
    expression.Evaluate(pointers, table.rows, values);
    std::vector<bool> is_true(table.rows);
    for (std::uint64_t row = 0; row < table.rows; ++row) {
        is_true[row] = std::fabs(values[row].value) > values[row].error;
    }
    return is_true;
}

std::string InputsText(const Table& table, std::uint64_t cell) {
    std::string text;
    for (const auto& [name, value] : InputsAt(table, cell)) {
        text += (text.empty() ? "" : ",") + name + "=" + value.hex;
    }
    return text;
}

std::string_view NameOf(MapMark mark) {
    return kMapMarkNames[static_cast<std::size_t>(mark)];
}

}  // namespace

Result<std::optional<PredictionSeen>> Predict(const MapPlan& plan, bool whole) {
    const std::optional<CaseMap>& map = plan.prepared.source.map;
    if (!map || (!map->fails && !map->safe)) {
        return std::optional<PredictionSeen>();
    }
    const Table& table = plan.prepared.table;
    PredictionSeen seen;
    seen.because = map->because;
    seen.cells.assign(table.rows, MapForecast::kOpen);
    const std::vector<bool> undecided = UndecidedCells(plan);
    struct Side {
        const char* key;
        const std::optional<MapPrediction>& prediction;
        MapForecast forecast;
        std::string& text;
    };
    const Side sides[] = {{"safe", map->safe, MapForecast::kSafe, seen.safe},
                          {"fails", map->fails, MapForecast::kFails, seen.fails}};
    for (const Side& side : sides) {
        if (!side.prediction) {
            continue;
        }
        side.text = side.prediction->expression.text();
        ETALON_TRY(is_true, TrueAt(*side.prediction, table));
        bool covers = false;
        for (std::uint64_t cell = 0; cell < table.rows; ++cell) {
            if (undecided[cell] || !is_true[cell]) {
                continue;
            }
            if (seen.cells[cell] != MapForecast::kOpen) {
                return Error{side.prediction->place.Text() +
                             "'fails' and 'safe' are both true at " + InputsText(table, cell)};
            }
            seen.cells[cell] = side.forecast;
            covers = true;
        }
        if (whole && !covers) {
            return Error{side.prediction->place.Text() + "'" + side.key +
                         "' is true in no cell of the map"};
        }
    }
    return std::optional(seen);
}

void Hold(const MapPlan& plan, const MappedDevice& device, const std::string& repeat,
          PredictionSeen& prediction) {
    MapAgreement agreement;
    agreement.device = device.device;
    for (std::uint64_t cell = 0; cell < prediction.cells.size(); ++cell) {
        const MapMark mark = device.mark[cell];
        bool agrees = true;
        if (prediction.cells[cell] == MapForecast::kSafe) {
            agrees = mark == MapMark::kHolds;
            ++agreement.safe;
            agreement.safe_held += agrees ? 1 : 0;
        } else if (prediction.cells[cell] == MapForecast::kFails) {
            agrees = mark != MapMark::kHolds;
            ++agreement.fails;
            agreement.failed += agrees ? 1 : 0;
        }
        if (!agrees && !prediction.contradiction) {
            MapContradiction contradiction;
            contradiction.device = device.device;
            contradiction.recipe = device.recipe;
            contradiction.what = mark == MapMark::kHolds
                                     ? "predicted to fail, and it holds"
                                     : "predicted to hold, and it is " + std::string(NameOf(mark));
            contradiction.inputs = InputsAt(plan.prepared.table, cell);
            contradiction.repeat =
                repeat + " --at " + ShellWord(InputsText(plan.prepared.table, cell));
            prediction.contradiction = contradiction;
        }
    }
    prediction.agreement.push_back(agreement);
}

}  // namespace etalon
