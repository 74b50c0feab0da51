#include "run/observe.h"

#include <bit>
#include <cmath>
#include <optional>

#include "judge/judge.h"

namespace etalon {
namespace {

void Take(const Judgement& judgement, Observation& observation) {
    observation.error = judgement.error;
    observation.ulp_error = judgement.ulp_error;
    observation.used = judgement.used;
}

std::optional<Value> TruthAt(const JudgedColumn& column, std::uint64_t row) {
    if (!column.HasTruth()) {
        return std::nullopt;
    }
    const double truth = column.truth.values[row];
    return Value{Shortest(truth), HexFloat(truth)};
}

std::string RelationText(Relation relation) {
    switch (relation) {
        case Relation::kEqual:
            return "==";
        case Relation::kLessEqual:
            return "<=";
        case Relation::kGreaterEqual:
            return ">=";
        case Relation::kLess:
            return "<";
        case Relation::kGreater:
            return ">";
    }
    return "";
}

}  // namespace

Value ValueOf(Scalar scalar, std::uint32_t word) {
    const std::string decimal = WordText(scalar, word);
    return {decimal, scalar == Scalar::kFloat ? HexFloat(std::bit_cast<float>(word)) : decimal};
}

std::vector<std::pair<std::string, Value>> InputsAt(const Table& table, std::uint64_t row) {
    std::vector<std::pair<std::string, Value>> inputs;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        const Scalar scalar = table.columns[c].scalar;
        const std::uint32_t word = table.At(row, c);
        const bool is_nan = scalar == Scalar::kFloat && std::isnan(std::bit_cast<float>(word));
        const std::string exact = ExactText(scalar, word);
        inputs.emplace_back(table.columns[c].name,
                            is_nan ? Value{exact, exact} : ValueOf(scalar, word));
    }
    return inputs;
}

AllowedValue AllowedValueOf(const Allowed& allowed, Scalar scalar, std::uint32_t word) {
    AllowedValue value;
    value.bounded = allowed.kind != Allowed::Kind::kUnbounded;
    value.excess = Excess(allowed, word);
    if (allowed.kind == Allowed::Kind::kNumber) {
        value.low = ValueOf(Scalar::kFloat, std::bit_cast<std::uint32_t>(allowed.low));
        value.high = ValueOf(Scalar::kFloat, std::bit_cast<std::uint32_t>(allowed.high));
        const auto number = std::bit_cast<float>(word);
        if (value.excess > 0 && allowed.low <= number && number <= allowed.high) {
            value.quantum = ValueOf(Scalar::kFloat, std::bit_cast<std::uint32_t>(allowed.quantum));
        }
    } else if (allowed.kind == Allowed::Kind::kWord) {
        value.low = value.high = ValueOf(scalar, allowed.word);
    }
    return value;
}

std::string LawLabel(const Law& law) {
    return "law '" + law.name + "'";
}

Observation ObserveOutput(const JudgedColumn& column, std::uint32_t word, std::uint64_t row) {
    Observation observation;
    observation.output = column.name;
    const bool tells = column.scalar == Scalar::kFloat || column.accept.shares;
    observation.rule = tells ? column.accept.Text() : "equal";
    observation.actual = ValueOf(column.scalar, word);
    observation.expected = TruthAt(column, row);
    Take(JudgeValue(column.accept, column.scalar, word, column.truth, row), observation);
    return observation;
}

Observation ObserveAllowed(const JudgedColumn& column, const Allowed& allowed,
                           std::string_view profile, std::uint32_t word, std::uint64_t row) {
    Observation observation;
    observation.output = column.name;
    observation.rule = "spec " + std::string(profile);
    observation.actual = ValueOf(column.scalar, word);
    observation.expected = TruthAt(column, row);
    observation.allowed = AllowedValueOf(allowed, column.scalar, word);
    Take(JudgeAllowed(allowed, word), observation);
    return observation;
}

Observation ObserveLaw(const PreparedLaw& law, std::size_t pair, std::uint32_t left,
                       std::uint32_t right) {
    const Scalar scalar = law.scalars[pair];
    Observation observation;
    observation.output = LawLabel(law.law) + ", left side";
    observation.rule = law.law.left + " " + RelationText(law.law.relation) + " " + law.law.right +
                       ", within " + law.law.within.Text();
    observation.actual = ValueOf(scalar, left);
    observation.expected = ValueOf(scalar, right);
    Take(JudgeLaw(law.law, scalar, left, right), observation);
    return observation;
}

}  // namespace etalon
