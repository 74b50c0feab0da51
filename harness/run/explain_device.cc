#include "run/explain_device.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/format.h"
#include "compile/spirv.h"
#include "evaluate/bound.h"
#include "numeric/ulp.h"
#include "report/text.h"
#include "run/case_run.h"
#include "run/explain_steps.h"
#include "run/fit.h"
#include "run/observe.h"
#include "spirv/read.h"
#include "spirv/watch.h"

namespace etalon {
namespace {

using evaluate::Origin;
using evaluate::TracedOperand;
using evaluate::TracedStep;

// The result if a product that goes in had not been rounded; nothing where none goes in, or the
// operation may not be contracted.
struct Contracted {
    std::uint32_t word = 0;
    std::size_t product = 0;  // step
};
std::vector<Contracted> Contractions(const StrictPath& path, const TracedStep& step,
                                     std::uint32_t leaf) {
    const bool is_sum = step.instruction->op == spv::Op::OpFAdd;
    if (!is_sum && step.instruction->op != spv::Op::OpFSub) {
        return {};
    }
    std::vector<Contracted> found;
    for (std::size_t k = 0; k < 2; ++k) {
        const Origin origin = step.operands[k][leaf].origin;
        if (origin.step == spirv::kNone) {
            continue;
        }
        const TracedStep& product = path.trace.steps[origin.step];
        const spv::Op op = product.instruction->op;
        if (op != spv::Op::OpFMul && op != spv::Op::OpVectorTimesScalar) {
            continue;
        }
        const float a = product.operands[0][origin.number].value;
        const float b = product.operands[1][op == spv::Op::OpFMul ? origin.number : 0].value;
        const float other = step.operands[1 - k][leaf].value;
        const float fused = is_sum   ? std::fma(a, b, other)
                            : k == 0 ? std::fma(a, b, -other)
                                     : std::fma(-a, b, other);
        found.push_back({std::bit_cast<std::uint32_t>(fused), origin.step});
    }
    return found;
}

// What a profile lets the operation alone yield, from these operands; nothing where it cannot be
// said in GLSL, or not be evaluated.
std::optional<evaluate::Bound> BoundAlone(const Subject& subject, const spirv::Module& module,
                                          const SourceTerms& terms, const TracedStep& step,
                                          std::uint32_t leaf, const evaluate::Profile& profile) {
    Call call = subject.call();
    call.arguments.clear();
    std::vector<std::string> names;
    std::vector<std::uint32_t> inputs;
    const std::vector<std::uint32_t> values = evaluate::OperandValues(module, *step.instruction);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string type = terms.TypeName(module.values[values[i]].type);
        if (type.empty()) {
            return std::nullopt;
        }
        names.push_back("operand_" + std::to_string(i));
        call.arguments.push_back({names.back(), type, true, false});
        for (const TracedOperand& number : step.operands[i]) {
            inputs.push_back(std::bit_cast<std::uint32_t>(number.value));
        }
        inputs.insert(inputs.end(), step.operand_words[i].begin(), step.operand_words[i].end());
    }
    call.wanted = {{"result", terms.Glsl(*step.instruction, names), "operation"}};
    const Result<Signature> signature = Inspect(call);
    if (!signature || signature->InputWords(call) != inputs.size()) {
        return std::nullopt;
    }
    const Result<Program, CompileFailure> program =
        Compile(call, *signature, Recipe{}, Target{}, {});
    if (!program || leaf >= program->output_words) {
        return std::nullopt;
    }
    Result<spirv::Module> alone = spirv::ReadModule(program->spirv);
    if (!alone) {
        return std::nullopt;
    }
    const auto plan = evaluate::MakePlan(std::move(*alone));
    if (!plan || (*plan)->images != 0) {
        return std::nullopt;
    }
    return evaluate::BoundOutputs(*plan, {}, profile, 1, inputs, program->output_words)[leaf];
}

// Whether it may yield that.
std::string WhetherAllowed(const Subject& subject, const StrictPath& path, const SourceTerms& terms,
                           const evaluate::Profile& profile, const TracedStep& step,
                           const Parting& parting) {
    const spirv::Module& module = path.plan->module;
    const std::string name(profile.name);
    if (parting.is_in_parts) {
        return "; not all operations were watched at once, so that others before it may have "
               "parted too";
    }
    for (const Contracted& one : Contractions(path, step, parting.leaf)) {
        if (IsSameFloat(one.word, parting.word)) {
            const bool is_free = !module.values[step.instruction->result].no_contraction;
            return format(": contracted with the product #{}, which is not rounded; {} {}",
                          one.product + 1, name,
                          is_free ? "allows that" : "forbids that, for the operation is precise");
        }
    }
    const auto bound = BoundAlone(subject, module, terms, step, parting.leaf, profile);
    if (!bound) {
        return "";
    }
    switch (bound->kind) {
        case evaluate::Bound::Kind::kNumber:
            return format("; {} {} it: {} to {}", name,
                          bound->Holds(parting.word) ? "allows" : "does not allow",
                          WordText(Scalar::kFloat, std::bit_cast<std::uint32_t>(bound->low)),
                          WordText(Scalar::kFloat, std::bit_cast<std::uint32_t>(bound->high)));
        case evaluate::Bound::Kind::kWord:
            return format("; {} {} it", name,
                          bound->Holds(parting.word) ? "allows" : "does not allow");
        case evaluate::Bound::Kind::kUnbounded:
            return format("; {} states no bound for it", name);
    }
    return "";
}

std::vector<std::uint32_t> RowWords(const Subject& subject) {
    const Rows rows = subject.rows();
    return {rows.words.begin(), rows.words.end()};
}

ExplainedParting Unwatched(const std::string& reason) {
    ExplainedParting parting;
    parting.text = "not watched: " + reason;
    return parting;
}

ExplainedParting WatchDevice(const Subject& subject, const StrictPath& path,
                             const SourceTerms& terms, Runner& runner, const Recipe& recipe,
                             std::span<const std::uint32_t> outputs) {
    const DeviceInfo& info = runner.info();
    if (!info.Has("spirv")) {
        return Unwatched("the device takes GLSL text only, and operations are watched in SPIR-V");
    }
    const std::vector<std::uint32_t> row = RowWords(subject);
    Recipe plain = recipe;
    plain.form = Form::kSpirv;
    plain.optimise = Recipe::Optimise::kNone;
    if (recipe.form == Form::kGlsl && !info.Has("compute")) {
        plain.stage = Stage::kFragment;
    }
    const Target target = TargetOf(info);
    const auto baked = recipe.baked ? std::vector<std::vector<std::uint32_t>>{row}
                                    : std::vector<std::vector<std::uint32_t>>{};
    const Result<Program, CompileFailure> program =
        Compile(subject.call(), subject.signature(), plain, target, baked);
    if (!program) {
        return Unwatched(program.error().reason);
    }
    const std::span<const std::uint32_t> inputs =
        recipe.baked ? std::span<const std::uint32_t>() : row;
    const Execute execute =
        [&](const Program& watched) -> Result<std::vector<std::uint32_t>, EvaluationFailure> {
        Program ready = watched;
        const auto failed = [](const Error& error) {
            return EvaluationFailure{EvaluationFailure::Kind::kUnsupported, error.message};
        };
        if (recipe.optimise != Recipe::Optimise::kNone) {
            auto better = OptimiseSpirv(watched.spirv, recipe.optimise, target);
            if (!better) {
                return failed(better.error());
            }
            ready.spirv = std::move(*better);
        }
        if (auto valid = ValidateSpirv(ready.spirv, target); !valid) {
            return failed(valid.error());
        }
        return runner.RunOnce("watched", ready, inputs);
    };
    if (recipe.form == Form::kGlsl) {
        const auto unwatched = execute(*program);
        if (!unwatched) {
            return Unwatched(unwatched.error().reason);
        }
        if (!std::equal(outputs.begin(), outputs.end(), unwatched->begin())) {
            return Unwatched(
                "the device returns " + WordText(subject.scalar, (*unwatched)[subject.column]) +
                " from SPIR-V, another value than from text, and operations are watched in "
                "SPIR-V");
        }
    }
    return PartingText(subject, path, terms, ProfileOf(info),
                       FindParting(*program, path.plan->module, path.trace, outputs, execute));
}

}  // namespace

ExplainedParting PartingText(const Subject& subject, const StrictPath& path,
                             const SourceTerms& terms, const evaluate::Profile& profile,
                             const Parting& parting) {
    ExplainedParting explained;
    switch (parting.kind) {
        case Parting::Kind::kFailed:
            return Unwatched(parting.reason);
        case Parting::Kind::kUnseen:
            explained.text =
                format("{}; {} of {} instructions were watched in parts, and none is seen to part",
                       parting.reason.empty()
                           ? "returns something else while all operations are watched"
                           : "all operations cannot be watched at once (" + parting.reason + ")",
                       parting.tried, parting.instructions);
            return explained;
        case Parting::Kind::kNowhere:
            explained.text = path.trace.is_cut
                                 ? "every operation that is traced yields what binary32 does"
                                 : "every operation yields what binary32 does";
            return explained;
        case Parting::Kind::kWay:
            explained.happens = true;
            explained.step = static_cast<std::uint32_t>(parting.step + 1);
            explained.text =
                format("takes another way before #{}: {}", explained.step,
                       parting.is_in_parts ? "not all operations before it were watched at once"
                                           : "everything until there yields what binary32 does");
            return explained;
        case Parting::Kind::kOperation:
            break;
    }
    const TracedStep& step = path.trace.steps[parting.step];
    const spirv::Module& module = path.plan->module;
    const Scalar scalar = LeafScalar(module, step.instruction->type, parting.leaf);
    const bool is_float = parting.leaf < step.numbers.size();
    const std::uint32_t strict =
        is_float ? std::bit_cast<std::uint32_t>(step.numbers[parting.leaf].value)
                 : step.words[parting.leaf - step.numbers.size()].value;
    explained.happens = true;
    explained.step = static_cast<std::uint32_t>(parting.step + 1);
    explained.part = terms.LeafName(step.instruction->type, parting.leaf);
    explained.strict = ValueOf(scalar, strict);
    explained.device = ValueOf(scalar, parting.word);
    std::string distance;
    if (is_float) {
        distance =
            format(", {} ulp off", ShortNumber(UlpError(std::bit_cast<float>(parting.word),
                                                        double{std::bit_cast<float>(strict)})));
    }
    explained.text =
        format("parts at #{}{}: {} = {} where binary32 has {}{}{}", explained.step, explained.part,
               explained.device.decimal, explained.device.hex, explained.strict.hex, distance,
               WhetherAllowed(subject, path, terms, profile, step, parting));
    return explained;
}

ExplainedDevice ExplainDevice(const Subject& subject, const StrictPath& path,
                              const SourceTerms& terms, Evaluations& evaluations, Runner& runner,
                              const Recipe& recipe) {
    ExplainedDevice device;
    Record& record = device.record;
    const Result<Recipe> fitted = FitRecipe(recipe, runner.info());
    if (!fitted) {
        record.case_path = subject.prepared.source.path;
        record.device = runner.info().name;
        record.recipe = RecipeText(recipe);
        record.verdict = Verdict::kSkip;
        record.reason = fitted.error().message;
        return device;
    }
    record = RunCase(subject.prepared, runner, *fitted, evaluations, {});
    std::vector<std::uint32_t> outputs;
    const auto evaluated =
        runner.Evaluate(subject.call(), subject.signature(), *fitted, subject.rows(),
                        [&](std::uint64_t, std::uint32_t, std::span<const std::uint32_t> words) {
                            outputs.assign(words.begin(), words.end());
                        });
    if (!evaluated) {
        return device;
    }
    device.result = ValueOf(subject.scalar, outputs[subject.column]);
    device.parting = WatchDevice(subject, path, terms, runner, *fitted, outputs);
    return device;
}

}  // namespace etalon
