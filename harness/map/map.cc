#include "map/map.h"

#include <algorithm>
#include <limits>
#include <list>

#include "base/file.h"
#include "base/progress.h"
#include "map/cells.h"
#include "map/condition.h"
#include "map/prediction.h"
#include "run/case_choice.h"
#include "run/fit.h"

namespace etalon {
namespace {

// Where the user names none, the first of these that is there.
constexpr const char* kUsualDevices[] = {"vulkan:llvmpipe", "osmesa:llvmpipe", "cpu"};

Result<DeviceSet> Open(const DeviceChoice& choice) {
    if (!choice.patterns.empty()) {
        return OpenDevices(choice);
    }
    for (const char* const name : kUsualDevices) {
        DeviceChoice one = choice;
        one.patterns = {name};
        if (auto devices = OpenDevices(one)) {
            return devices;
        }
    }
    return OpenDevices(choice);
}

bool NeedsFragmentStage(const MapPlan& plan) {
    const auto needs = [](const Signature& signature) {
        return signature.stage == Stage::kFragment;
    };
    return needs(plan.prepared.signature) || (plan.spent && needs(plan.spent->signature)) ||
           std::any_of(plan.prepared.laws.begin(), plan.prepared.laws.end(),
                       [&](const PreparedLaw& law) { return needs(law.signature); });
}

std::string RepeatCommand(const MapChoice& choice, const MapRecord& map) {
    std::string command = "etalon map " + ShellWord(map.case_path);
    const auto add = [&](const char* option, const std::string& value) {
        if (!value.empty()) {
            command += std::string(option) + ShellWord(value);
        }
    };
    add(" --over ", choice.scope.over);
    for (const std::string& range : choice.scope.ranges) {
        add(" --range ", range);
    }
    add(" --at ", choice.scope.at);
    add(" --size ", choice.scope.size);
    add(" --output ", choice.scope.output);
    command += choice.options;
    for (const MappedDevice& device : map.devices) {
        add(" --device ", device.device);
    }
    add(" --recipe ", choice.recipe);
    return command;
}

class Mapper {
  public:
    Mapper(const MapChoice& choice, const MapPlan& plan) : choice_(choice), plan_(plan) {
        const Case& source = plan.prepared.source;
        map_.case_path = source.path;
        map_.description = source.description;
        map_.output = OutputOf(plan);
        map_.measure = MeasureOf(plan);
        map_.tolerance = ToleranceOf(plan);
        map_.x = plan.x;
        map_.y = plan.y;
        map_.fixed = plan.fixed;
        map_.search = std::any_of(plan.prepared.judged.begin(), plan.prepared.judged.end(),
                                  [](const JudgedColumn& column) {
                                      return column.accept.shares && column.accept.shares->beyond;
                                  });
    }

    Result<MapRecord> Run(const std::optional<Recipe>& wanted) {
        ETALON_TRY(prediction, Predict(plan_, choice_.scope.IsOwn()));
        map_.prediction = prediction;
        map_.condition = ConditionNumbers(plan_);
        ETALON_TRY(devices, Open(choice_.devices));
        Progress progress(static_cast<std::int64_t>(devices.runners.size()));
        for (const auto& runner : devices.runners) {
            ETALON_TRY_STEP(Map(*runner, wanted));
            progress.Step(runner->info().name);
        }
        progress.Clear();
        if (std::all_of(map_.devices.begin(), map_.devices.end(),
                        [](const MappedDevice& device) { return device.mark.empty(); })) {
            const MappedDevice& first = map_.devices.front();
            return Error{first.device + " (" + first.recipe + "): " + first.reason};
        }
        if (results_.size() > 1) {
            std::vector<const MapResults*> all;
            for (const MapResults& results : results_) {
                all.push_back(&results);
            }
            map_.disagreement = Disagreement(plan_, all);
        }
        map_.repeat = RepeatCommand(choice_, map_);
        return std::move(map_);
    }

  private:
    Status<> Map(Runner& runner, const std::optional<Recipe>& wanted) {
        const DeviceInfo& info = runner.info();
        MappedDevice device;
        device.device = info.name;
        device.driver = info.description + ", " + info.driver + " " + info.version;
        Recipe recipe = wanted.value_or(DefaultRecipe(info));
        if (NeedsFragmentStage(plan_)) {
            recipe.stage = Stage::kFragment;
        }
        device.recipe = RecipeText(recipe);
        const Result<Recipe> fitted = FitRecipe(recipe, info);
        if (!fitted) {
            device.reason = fitted.error().message;
            map_.devices.push_back(std::move(device));
            return Ok();
        }
        device.recipe = RecipeText(*fitted);
        auto results = RunCells(plan_, runner, *fitted);
        if (results) {
            JudgeCells(plan_, *results, device);
            results_.push_back(std::move(*results));
        } else {
            using Kind = EvaluationFailure::Kind;
            device.reason = results.error().reason;
            if (results.error().kind == Kind::kInput) {
                return Error{device.reason};
            }
            if (results.error().kind != Kind::kUnsupported) {
                device.mark.assign(plan_.cells(), MapMark::kCrash);
                device.error.assign(plan_.cells(), std::numeric_limits<double>::infinity());
            }
        }
        if (map_.prediction && results) {
            Hold(plan_, device,
                 "etalon run " + ShellWord(map_.case_path) + choice_.options + " --device " +
                     ShellWord(device.device) + " --recipe " + device.recipe,
                 *map_.prediction);
        }
        map_.devices.push_back(std::move(device));
        return Ok();
    }

    const MapChoice& choice_;
    const MapPlan& plan_;
    MapRecord map_;
    std::list<MapResults> results_;
};

}  // namespace

Result<MapRecord> MakeMap(const MapChoice& choice) {
    ETALON_TRY(name, ChooseOneCase(choice.root, choice.pattern, "mapped"));
    ETALON_TRY(source, ReadCase(choice.root, name));
    std::optional<Recipe> wanted;
    if (!choice.recipe.empty()) {
        ETALON_TRY(recipe, ParseRecipe(choice.recipe));
        if (recipe.baked) {
            return Error{"--recipe " + choice.recipe + ": a map's inputs cannot be constants"};
        }
        wanted = recipe;
    }
    // What is wrong with the scope is told before a device is opened.
    ETALON_TRY(plan, PlanMap(source, choice.scope));
    return Mapper(choice, plan).Run(wanted);
}

}  // namespace etalon
