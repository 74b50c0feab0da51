#include "run/explain.h"

#include <algorithm>

#include "base/progress.h"
#include "case/case.h"
#include "compile/compile.h"
#include "run/case_choice.h"
#include "run/case_run.h"
#include "run/evaluation.h"
#include "run/explain_device.h"
#include "run/explain_steps.h"
#include "run/fit.h"
#include "run/observe.h"
#include "spirv/read.h"

namespace etalon {
namespace {

// At most so many rows are run to find the worst input on a device that interprets shaders.
constexpr std::uint64_t kSlowRows = 2048;

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
    const PreparedCase thin = Thin(prepared, kSlowRows);
    Evaluations evaluations(devices.programs);
    std::string reason = "no device has run it";
    Progress progress(static_cast<std::int64_t>(devices.runners.size()));
    for (const auto& runner : devices.runners) {
        for (const Recipe& recipe : RecipesFor(wanted, runner->info())) {
            const Result<Recipe> fitted = FitRecipe(recipe, runner->info());
            if (!fitted || fitted->baked) {
                continue;
            }
            const Record record =
                RunCase(runner->info().slow ? thin : prepared, *runner, *fitted, evaluations, {});
            if (!record.worst) {
                reason = record.device + ": " + record.reason;
            } else if (!worst || record.worst->used > worst->worst->used) {
                worst = record;
            }
        }
        progress.Step("the worst input on " + runner->info().name);
    }
    progress.Clear();
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

// What a case judges, by the names that --output takes.
std::string Names(const PreparedCase& prepared) {
    std::string names;
    const auto add = [&](const std::string& name) {
        names += (names.empty() ? "'" : ", '") + name + "'";
    };
    for (const JudgedColumn& column : prepared.judged) {
        add(column.name);
    }
    for (const PreparedLaw& law : prepared.laws) {
        add(law.law.name);
    }
    return names;
}

Result<Subject> SubjectOf(PreparedCase prepared, const std::string& output) {
    Subject subject;
    // A vector's name stands for its first component.
    const auto judged =
        std::find_if(prepared.judged.begin(), prepared.judged.end(), [&](const auto& column) {
            return column.name.substr(0, column.name.find_first_of(".[")) == output ||
                   column.name == output || output.empty();
        });
    const auto law = std::find_if(prepared.laws.begin(), prepared.laws.end(), [&](const auto& one) {
        return one.law.name == output || output.empty();
    });
    if (judged != prepared.judged.end()) {
        prepared.laws.clear();
        prepared.judged = {JudgedColumn(*judged)};
        subject.column = prepared.judged[0].column;
        subject.name = prepared.judged[0].name;
        subject.scalar = prepared.judged[0].scalar;
    } else if (law != prepared.laws.end()) {
        prepared.judged.clear();
        prepared.laws = {PreparedLaw(*law)};
        subject.column = prepared.laws[0].pairs[0].first;
        subject.scalar = prepared.laws[0].scalars[0];
        subject.name = "left side of " + LawLabel(prepared.laws[0].law);
    } else {
        return Error{"--output: the case judges no '" + output + "'; it judges " + Names(prepared)};
    }
    subject.prepared = std::move(prepared);
    return subject;
}

Result<StrictPath> TracePath(const Subject& subject) {
    const auto cannot = [&](const std::string& reason) {
        return Error{subject.prepared.source.path + ": cannot be explained: " + reason};
    };
    if (subject.signature().stage == Stage::kFragment) {
        return cannot(
            "it compiles in a fragment shader only, and the evaluator knows no others "
            "than compute shaders");
    }
    StrictPath path;
    Result<Program, CompileFailure> program =
        Compile(subject.call(), subject.signature(), Recipe{}, Target{}, {}, Lines::kKept);
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
    if (const JudgedColumn* column = subject.judged(); column != nullptr) {
        return column->own_spec                   ? "the device's own specification"
               : column->spec != nullptr          ? "spec " + std::string(column->spec->name)
               : subject.scalar == Scalar::kFloat ? column->accept.Text()
                                                  : "equal";
    }
    return subject.law()->law.left + " against " + subject.law()->law.right;
}

}  // namespace

Result<Explanation> Explain(const ExplainChoice& choice) {
    ETALON_TRY(name, ChooseOneCase(choice.root, choice.pattern, "explained"));
    ETALON_TRY(wanted, RecipesOf(choice));
    ETALON_TRY(source, ReadCase(choice.root, name));
    Explanation explanation;
    explanation.case_path = name;
    std::string at = choice.at;
    // What is wrong with the input or the output is told before a device is opened.
    ETALON_TRY(first, at.empty() ? Prepare(source) : PrepareAt(source, at));
    ETALON_TRY(narrow, SubjectOf(first, choice.output));
    ETALON_TRY(devices, OpenDevices(choice.devices));
    if (at.empty()) {
        ETALON_TRY(worst, FindWorst(narrow.prepared, devices, wanted));
        at = worst.at;
        explanation.chosen = worst.chosen;
    }
    ETALON_TRY(prepared, PrepareAt(source, at));
    ETALON_TRY(subject, SubjectOf(prepared, choice.output));
    ETALON_TRY(path, TracePath(subject));
    explanation.inputs = InputsAt(subject.prepared.table, 0);
    explanation.output = subject.name;
    explanation.rule = RuleOf(subject);
    if (subject.judged() != nullptr && !subject.judged()->truth.values.empty()) {
        const double truth = subject.judged()->truth.values[0];
        explanation.truth = Value{Shortest(truth), HexFloat(truth)};
    }
    explanation.strict = ValueOf(subject.scalar, path.trace.outputs[subject.column]);
    const SourceTerms terms(path.plan->module);
    ExplainSteps(path.plan->module, path.trace, terms, subject.call(), subject.column, explanation);

    Evaluations evaluations(devices.programs);
    Evaluation& evaluation =
        evaluations.Of(subject.call(), subject.signature(), Recipe{}, subject.rows());
    if (!evaluation.Get()) {
        return Error{name + ": cannot be explained: " + evaluation.Get().error().message};
    }
    const double method = evaluation.MethodAt(0, subject.column, subject.scalar);
    explanation.method = {Shortest(method), HexFloat(method)};
    Progress progress(static_cast<std::int64_t>(devices.runners.size()));
    for (const auto& runner : devices.runners) {
        for (const Recipe& recipe : RecipesFor(wanted, runner->info())) {
            explanation.devices.push_back(
                ExplainDevice(subject, path, terms, evaluations, *runner, recipe));
        }
        progress.Step("explained on " + runner->info().name);
    }
    progress.Clear();
    return explanation;
}

}  // namespace etalon
