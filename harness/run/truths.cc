#include "run/truths.h"

#include <algorithm>

#include "numeric/ulp.h"

namespace etalon {
namespace {

// Inputs as binary64, by columns.
std::vector<std::vector<double>> Doubles(const Table& table, bool flush) {
    std::vector<std::vector<double>> columns(table.columns.size());
    for (std::size_t c = 0; c < columns.size(); ++c) {
        columns[c].resize(table.rows);
        for (std::uint64_t row = 0; row < table.rows; ++row) {
            const double value = WordValue(table.columns[c].scalar, table.At(row, c));
            columns[c][row] =
                flush && table.columns[c].scalar == Scalar::kFloat ? FlushBinary32(value) : value;
        }
    }
    return columns;
}

std::vector<std::uint64_t> SubnormalRows(const Table& table) {
    std::vector<std::uint64_t> rows;
    for (std::uint64_t row = 0; row < table.rows; ++row) {
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            if (table.columns[c].scalar == Scalar::kFloat && IsSubnormal(table.At(row, c))) {
                rows.push_back(row);
                break;
            }
        }
    }
    return rows;
}

// Values of an expression at all rows, by columns, with their errors.
void EvaluateAt(const Expression& expression, const Table& table, bool flush,
                std::vector<double>& values, std::vector<double>& errors) {
    const std::vector<std::vector<double>> columns = Doubles(table, flush);
    std::vector<const double*> pointers;
    pointers.reserve(columns.size());
    for (const std::vector<double>& column : columns) {
        pointers.push_back(column.data());
    }
    if (expression.IsFast()) {
        expression.EvaluateFast(pointers, table.rows, values);
        errors.resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            errors[i] =
                TruthError(values[i], expression.relative_bound(), expression.absolute_bound());
        }
        return;
    }
    std::vector<Expression::Value> results;
    expression.Evaluate(pointers, table.rows, results);
    values.resize(results.size());
    errors.resize(results.size());
    for (std::size_t i = 0; i < results.size(); ++i) {
        values[i] = results[i].value;
        errors[i] = results[i].error;
    }
}

}  // namespace

bool IsSubnormal(std::uint32_t word) {
    return (word & 0x7f800000u) == 0 && (word & 0x007fffffu) != 0;
}

Table RowsOf(const Table& table, const std::vector<std::uint64_t>& rows) {
    Table some = table;
    some.rows = rows.size();
    some.words.resize(rows.size() * table.columns.size());
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            some.words[c * rows.size() + i] = table.At(rows[i], c);
        }
    }
    return some;
}

std::vector<Truth> TruthsOf(const Expression& oracle, const Table& table) {
    const std::vector<std::uint64_t> subnormal = SubnormalRows(table);
    std::vector<double> values;
    std::vector<double> errors;
    EvaluateAt(oracle, table, false, values, errors);
    std::vector<double> other_values;
    std::vector<double> other_errors;
    if (!subnormal.empty()) {
        EvaluateAt(oracle, RowsOf(table, subnormal), true, other_values, other_errors);
    }
    const std::size_t components = values.size() / table.rows;
    std::vector<Truth> truths(components);
    for (std::size_t k = 0; k < components; ++k) {
        const auto part = [&](const std::vector<double>& all) {
            const auto from = all.begin() + static_cast<std::ptrdiff_t>(k * table.rows);
            return std::vector<double>(from, from + static_cast<std::ptrdiff_t>(table.rows));
        };
        truths[k].values = part(values);
        truths[k].errors = part(errors);
        for (std::size_t i = 0; i < subnormal.size(); ++i) {
            const std::size_t at = k * subnormal.size() + i;
            truths[k].alternatives.push_back({subnormal[i], other_values[at], other_errors[at]});
        }
    }
    return truths;
}

}  // namespace etalon
