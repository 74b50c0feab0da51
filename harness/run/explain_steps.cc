#include "run/explain_steps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <sstream>

#include "base/file.h"
#include "base/format.h"
#include "numeric/ulp.h"
#include "probe/generate.h"
#include "run/observe.h"
#include "spirv/watch.h"

namespace etalon {
namespace {

using evaluate::Origin;
using evaluate::Trace;
using evaluate::TracedNumber;

double ErrorOf(const TracedNumber& number) {
    return UlpError(number.value, number.exact.ToDouble());
}

// The traced numbers that the output is made of.
std::vector<std::vector<bool>> Reaching(const Trace& trace, std::size_t column) {
    std::vector<std::vector<bool>> reached;
    for (const evaluate::TracedStep& step : trace.steps) {
        reached.emplace_back(step.numbers.size(), false);
    }
    std::vector<Origin> open = {trace.origins[column]};
    while (!open.empty()) {
        const Origin origin = open.back();
        open.pop_back();
        if (origin.step == spirv::kNone || reached[origin.step][origin.number]) {
            continue;
        }
        reached[origin.step][origin.number] = true;
        const std::vector<Origin>& from = trace.steps[origin.step].numbers[origin.number].from;
        open.insert(open.end(), from.begin(), from.end());
    }
    return reached;
}

// By how much the error has grown, in bits; an error of half an ulp is that of a single rounding.
double LostBits(const Trace& trace, const TracedNumber& number) {
    constexpr double kRounding = 0.5;
    double before = kRounding;
    for (const Origin& origin : number.from) {
        before = std::max(before, ErrorOf(trace.steps[origin.step].numbers[origin.number]));
    }
    const double after = ErrorOf(number);
    return std::isinf(before) || !(after > before) ? 0 : std::log2(after / before);
}

// In the table ten digits tell it from binary32.
Value ExactValue(double value) {
    return {std::isnan(value) ? "nan" : format("{:.10g}", value), HexFloat(value)};
}

// Lines of the user's files, read once.
class SourceLines {
  public:
    explicit SourceLines(const Call& call) : call_(call) {}

    void Find(const spirv::Line& line, ExplainedStep& step) {
        if (line.file == kGenerated) {
            return;
        }
        step.file = line.file;
        step.line = line.line;
        for (const Wanted& wanted : call_.wanted) {
            if (wanted.origin == line.file) {
                // "cases/x.toml:2: call"
                const std::size_t colon = wanted.origin.rfind(':', wanted.origin.rfind(": ") - 1);
                step.file = wanted.origin.substr(0, colon);
                step.line = static_cast<std::uint32_t>(
                    std::strtoul(wanted.origin.c_str() + colon + 1, nullptr, 10));
                step.text = wanted.text;
                return;
            }
        }
        const std::vector<std::string>& lines = Lines(line.file);
        if (line.line >= 1 && line.line <= lines.size()) {
            step.text = Trimmed(lines[line.line - 1]);
        }
    }

  private:
    static std::string Trimmed(const std::string& text) {
        constexpr std::size_t kMost = 100;
        const std::size_t first = text.find_first_not_of(" \t");
        if (first == std::string::npos) {
            return "";
        }
        const std::string inner = text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
        return inner.size() > kMost ? inner.substr(0, kMost) + "..." : inner;
    }

    const std::vector<std::string>& Lines(const std::string& file) {
        const auto [entry, is_new] = files_.try_emplace(file);
        if (is_new) {
            // What cannot be read again has no text here; its numbers stand.
            if (const Result<std::string> text = ReadTextFile(file)) {
                std::istringstream stream(*text);
                for (std::string line; std::getline(stream, line);) {
                    entry->second.push_back(line);
                }
            }
        }
        return entry->second;
    }

    const Call& call_;
    std::map<std::string, std::vector<std::string>> files_;
};

}  // namespace

Scalar LeafScalar(const spirv::Module& module, std::uint32_t type, std::uint32_t leaf) {
    const spirv::Type& scalar = module.types[spirv::Leaves(module, type)[leaf].type];
    switch (scalar.kind) {
        case spirv::Type::Kind::kBool:
            return Scalar::kBool;
        case spirv::Type::Kind::kInt:
            return scalar.is_signed ? Scalar::kInt : Scalar::kUint;
        default:
            return Scalar::kFloat;
    }
}

void ExplainSteps(const spirv::Module& module, const Trace& trace, const SourceTerms& terms,
                  const Call& call, std::size_t column, Explanation& explanation) {
    const bool is_number = trace.origins[column].step != spirv::kNone;
    const std::vector<std::vector<bool>> reaching = Reaching(trace, column);
    SourceLines sources(call);
    double most = 1;  // less than a bit is no loss to speak of
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
        const evaluate::TracedStep& traced = trace.steps[i];
        ExplainedStep step;
        step.number = static_cast<std::uint32_t>(i + 1);
        if (traced.instruction->line != spirv::kNone) {
            sources.Find(module.lines[traced.instruction->line], step);
        }
        step.name = terms.Name(traced);
        step.operation = terms.Operation(trace, traced);
        std::uint32_t leaf = 0;
        for (const TracedNumber& number : traced.numbers) {
            ExplainedValue value;
            value.part = terms.LeafName(traced.instruction->type, leaf);
            value.strict = ValueOf(Scalar::kFloat, std::bit_cast<std::uint32_t>(number.value));
            value.exact = ExactValue(number.exact.ToDouble());
            value.error_ulp = ErrorOf(number);
            value.amplification = number.amplification;
            value.lost_bits = LostBits(trace, number);
            value.reaches_output = !is_number || reaching[i][leaf];
            if (value.reaches_output && value.lost_bits > most) {
                most = value.lost_bits;
                explanation.worst_step = step.number;
                explanation.worst_value = leaf;
            }
            step.values.push_back(std::move(value));
            ++leaf;
        }
        step.is_decision = traced.numbers.empty();
        for (const evaluate::TracedWord& word : traced.words) {
            const Scalar scalar = LeafScalar(module, traced.instruction->type, leaf);
            ExplainedValue value;
            value.part = terms.LeafName(traced.instruction->type, leaf);
            value.strict = ValueOf(scalar, word.value);
            value.exact = ValueOf(scalar, word.exact);
            step.decides_otherwise = step.decides_otherwise || word.value != word.exact;
            // Beside floats they are the exponents of frexp; the table tells numbers.
            if (step.is_decision) {
                step.values.push_back(std::move(value));
            }
            ++leaf;
        }
        explanation.steps.push_back(std::move(step));
    }
    explanation.is_cut = trace.is_cut;
}

}  // namespace etalon
