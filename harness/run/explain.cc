#include "run/explain.h"

#include <algorithm>

#include "case/case.h"
#include "compile/compile.h"
#include "run/case_choice.h"
#include "run/case_run.h"
#include "run/evaluation.h"
#include "run/explain_device.h"
#include "run/explain_steps.h"
#include "run/fit.h"
#include "spirv/read.h"

namespace etalon {
namespace {

// At most so many rows are run to find the worst input on a device that interprets shaders.
constexpr std::uint64_t kSlowRows = 2048;

Result<std::string> ChooseCase(const ExplainChoice& choice) {
    ETALON_TRY(paths, ChooseCases(choice.root, {choice.pattern}));
    if (std::find(paths.begin(), paths.end(), choice.pattern) != paths.end()) {
        return choice.pattern;
    }
    if (paths.size() != 1) {
        return Error{"'" + choice.pattern + "' names " + std::to_string(paths.size()) +
                     " cases, and one is explained; `etalon list` shows them"};
    }
    return std::move(paths.front());
}

Result<std::vector<Recipe>> RecipesOf(const ExplainChoice& choice) {
    std::vector<Recipe> recipes;
    for (const std::string& text : choice.recipes) {
        ETALON_TRY(recipe, ParseRecipe(text));
        recipes.push_back(recipe);
    }
    return recipes;
}

std::vector<Recipe> RecipesFor(const std::vector<Recipe>& wanted, const DeviceInfo& device) {
    return wanted.empty() ? std::vector<Recipe>{DefaultRecipe(device)} : wanted;
}

struct WorstInput {
    std::string at;
    std::string chosen;
};

// The input at which a run of the case uses most of its tolerance.
Result<WorstInput> FindWorst(const PreparedCase& prepared, const DeviceSet& devices,
                             const std::vector<Recipe>& wanted) {
    std::optional<Record> worst;
    std::string reason = "no device has run it";
    for (const auto& runner : devices.runners) {
        for (const Recipe& recipe : RecipesFor(wanted, runner->info())) {
            const Result<Recipe> fitted = FitRecipe(recipe, runner->info());
            if (!fitted || fitted->baked) {
                continue;
            }
            const Record record = RunCase(
                runner->info().slow ? Thin(prepared, kSlowRows) : prepared, *runner, *fitted, {});
            if (!record.worst) {
                reason = record.device + ": " + record.reason;
            } else if (!worst || record.worst->used > worst->worst->used) {
                worst = record;
            }
        }
    }
    if (!worst) {
        return Error{prepared.source.path + ": has no worst input (" + reason +
                     "); --at gives one"};
    }
    WorstInput input;
    for (const auto& [name, value] : worst->worst->inputs) {
        input.at += (input.at.empty() ? "" : ",") + name + "=" + value.hex;
    }
    input.chosen = "the worst input on " + worst->device + " (" + worst->recipe + ")";
    return input;
}

std::string OutputNames(const std::vector<ProbeColumn>& outputs) {
    std::string names;
    for (const ProbeColumn& output : outputs) {
        names += (names.empty() ? "'" : ", '") + output.name + "'";
    }
    return names;
}

Result<Subject> SubjectOf(const PreparedCase& prepared, const std::string& output) {
    Subject subject;
    subject.prepared = &prepared;
    subject.call = &prepared.call;
    subject.signature = &prepared.signature;
    if (prepared.judged.empty()) {
        const PreparedLaw& law = prepared.laws.front();
        subject.call = &law.call;
        subject.signature = &law.signature;
        subject.law = &law;
    }
    const std::vector<ProbeColumn> outputs = OutputColumns(*subject.call, *subject.signature);
    if (!output.empty()) {
        // A vector's name stands for its first component.
        const auto named = std::find_if(outputs.begin(), outputs.end(), [&](const auto& column) {
            return column.name == output ||
                   (column.name.starts_with(output) &&
                    (column.name[output.size()] == '.' || column.name[output.size()] == '['));
        });
        if (named == outputs.end()) {
            return Error{"--output: the case has no output '" + output + "'; it has " +
                         OutputNames(outputs)};
        }
        subject.column = static_cast<std::size_t>(named - outputs.begin());
    } else {
        subject.column =
            subject.law != nullptr ? subject.law->pairs[0].first : prepared.judged[0].column;
    }
    subject.name = outputs[subject.column].name;
    subject.scalar = outputs[subject.column].scalar;
    for (const JudgedColumn& column : prepared.judged) {
        if (column.column == subject.column) {
            subject.judged = &column;
        }
    }
    for (std::size_t i = 0; subject.law != nullptr && i < subject.law->pairs.size(); ++i) {
        const auto& [left, right] = subject.law->pairs[i];
        if (left == subject.column || right == subject.column) {
            subject.pair = i;
            break;
        }
    }
    return subject;
}

Result<StrictPath> TracePath(const Subject& subject) {
    const auto cannot = [&](const std::string& reason) {
        return Error{subject.prepared->source.path + ": cannot be explained: " + reason};
    };
    if (subject.signature->stage == Stage::kFragment) {
        return cannot(
            "it compiles in a fragment shader only, and the evaluator knows no others "
            "than compute shaders");
    }
    StrictPath path;
    Result<Program, CompileFailure> program =
        Compile(*subject.call, *subject.signature, Recipe{}, Target{}, {}, Lines::kKept);
    if (!program) {
        return cannot(program.error().reason);
    }
    path.program = std::move(*program);
    Result<spirv::Module> module = spirv::ReadModule(path.program.spirv);
    if (!module) {
        return cannot(module.error().message);
    }
    auto plan = evaluate::MakePlan(std::move(*module));
    if (!plan) {
        return cannot(plan.error().message);
    }
    path.plan = std::move(*plan);
    std::vector<evaluate::Texture> images;
    for (const BoundImage& image : path.program.images) {
        images.push_back({image.image, image.sampling});
    }
    auto trace =
        evaluate::TraceRow(path.plan, images, subject.rows().words, path.program.output_words);
    if (!trace) {
        return cannot(trace.error().message);
    }
    path.trace = std::move(*trace);
    return path;
}

std::string RuleOf(const Subject& subject) {
    if (subject.judged != nullptr) {
        return subject.scalar == Scalar::kFloat ? subject.judged->accept.Text() : "equal";
    }
    if (subject.law != nullptr) {
        return "law '" + subject.law->law.name + "': " + subject.law->law.left + ", " +
               subject.law->law.right;
    }
    return "";
}

}  // namespace

Result<Explanation> Explain(const ExplainChoice& choice) {
    ETALON_TRY(name, ChooseCase(choice));
    ETALON_TRY(wanted, RecipesOf(choice));
    ETALON_TRY(source, ReadCase(choice.root, name));
    Explanation explanation;
    explanation.case_path = name;
    std::string at = choice.at;
    // What is wrong with the input or the output is told before a device is opened.
    std::optional<PreparedCase> whole;
    if (at.empty()) {
        ETALON_TRY(prepared, Prepare(source));
        ETALON_TRY_STEP(SubjectOf(prepared, choice.output));
        whole = std::move(prepared);
    } else {
        ETALON_TRY(prepared, PrepareAt(source, at));
        ETALON_TRY_STEP(SubjectOf(prepared, choice.output));
    }
    ETALON_TRY(devices, OpenDevices(choice.devices));
    if (whole) {
        ETALON_TRY(worst, FindWorst(*whole, devices, wanted));
        at = worst.at;
        explanation.chosen = worst.chosen;
    }
    ETALON_TRY(prepared, PrepareAt(source, at));
    ETALON_TRY(subject, SubjectOf(prepared, choice.output));
    ETALON_TRY(path, TracePath(subject));

    for (std::size_t c = 0; c < prepared.table.columns.size(); ++c) {
        const Column& column = prepared.table.columns[c];
        explanation.inputs.emplace_back(column.name,
                                        WordOf(column.scalar, prepared.table.At(0, c)));
    }
    explanation.output = subject.name;
    explanation.rule = RuleOf(subject);
    if (subject.judged != nullptr) {
        const double truth = subject.judged->truth.values[0];
        explanation.truth = Value{Shortest(truth), HexFloat(truth)};
    }
    explanation.strict = WordOf(subject.scalar, path.trace.outputs[subject.column]);
    const SourceTerms terms(path.plan->module);
    ExplainSteps(path.plan->module, path.trace, terms, *subject.call, subject.column, explanation);

    Evaluations evaluations(std::make_shared<Programs>());
    Evaluation& evaluation =
        evaluations.Of(*subject.call, *subject.signature, Recipe{}, subject.rows());
    if (!evaluation.Get()) {
        return Error{name + ": cannot be explained: " + evaluation.Get().error().message};
    }
    const double method = evaluation.MethodAt(0)[subject.column];
    explanation.method = {Shortest(method), HexFloat(method)};
    for (const auto& runner : devices.runners) {
        for (const Recipe& recipe : RecipesFor(wanted, runner->info())) {
            explanation.devices.push_back(
                ExplainDevice(subject, path, terms, evaluations, *runner, recipe));
        }
    }
    return explanation;
}

}  // namespace etalon
