#include "chart/chart.h"

#include <algorithm>

#include "base/file.h"
#include "case/suggestion.h"
#include "chart/accuracy.h"
#include "chart/bounds.h"
#include "chart/measure.h"

namespace etalon {
namespace {

// The indices of what the patterns name. `names(i)` are the names of thing i; `what` is its word.
template <typename Names>
Result<std::vector<std::size_t>> Choose(std::size_t count, const std::vector<std::string>& patterns,
                                        const std::string& what, const Names& names) {
    std::vector<std::size_t> chosen;
    std::vector<bool> is_used(patterns.size(), false);
    std::vector<std::string> known;
    for (std::size_t i = 0; i < count; ++i) {
        bool is_chosen = patterns.empty();
        for (const std::string& name : names(i)) {
            known.push_back(name);
            for (std::size_t k = 0; k < patterns.size(); ++k) {
                if (patterns[k] == name || GlobMatches(patterns[k], name)) {
                    is_chosen = is_used[k] = true;
                }
            }
        }
        if (is_chosen) {
            chosen.push_back(i);
        }
    }
    const auto unused = std::find(is_used.begin(), is_used.end(), false);
    if (unused != is_used.end()) {
        const std::string& pattern = patterns[static_cast<std::size_t>(unused - is_used.begin())];
        const std::vector<std::string_view> views(known.begin(), known.end());
        return Error{"--" + what + " '" + pattern + "': the family has no such " + what +
                     Suggestion(pattern, views)};
    }
    return chosen;
}

ChartCounts CountsOf(const OperationCounts& counts) {
    return {counts.arithmetic, counts.division, counts.special, counts.comparison,
            counts.integer,    counts.fetch,    counts.other,   counts.Total()};
}

ChartCost CostOfTime(const TimeEstimate& time, const Found* reference) {
    ChartCost cost;
    cost.nanoseconds = 1e9 * time.seconds;
    cost.low = 1e9 * time.low;
    cost.high = 1e9 * time.high;
    cost.rounds = time.rounds;
    cost.clock = time.clock;
    if (reference != nullptr && reference->time && reference->time->seconds > 0) {
        const double unit = reference->time->seconds;
        cost.ratio = {time.seconds / unit, time.low / unit, time.high / unit};
    }
    return cost;
}

class Maker {
  public:
    Maker(const ChartChoice& choice, Family family) : choice_(choice), family_(std::move(family)) {}

    Result<ChartRecord> Make(std::ostream& notes) {
        ETALON_TRY_STEP(ChooseAll());
        ETALON_TRY(devices, OpenDevices(choice_.devices));
        if (choice_.first_device_only) {
            devices.runners.resize(1);
        }
        ETALON_TRY(found, MeasureFamily(family_, plan_, devices.runners, notes));
        ChartRecord chart = Head();
        for (std::size_t d = 0; d < devices.runners.size(); ++d) {
            chart.devices.push_back(devices.runners[d]->info());
            std::vector<Found> all;
            for (const std::vector<Found>& of_scenes : found[d]) {
                all.push_back(Together(of_scenes));
            }
            for (std::size_t s = 0; s < plan_.scenes.size(); ++s) {
                std::vector<Found> of_points;
                for (std::vector<Found>& of_scenes : found[d]) {
                    of_points.push_back(std::move(of_scenes[s]));
                }
                AddPoints(chart.devices.back().name, family_.scenes[plan_.scenes[s]].name,
                          std::move(of_points), chart);
            }
            AddPoints(chart.devices.back().name, "all", std::move(all), chart);
        }
        AddFrontAndBounds(chart);
        return chart;
    }

  private:
    Status<> ChooseAll() {
        if (!choice_.at.empty() && !family_.has_truth) {
            return Error{"--at: the family has no oracle, and no errors to look at"};
        }
        ETALON_TRY(points, Choose(family_.points.size(), choice_.members, "member",
                                  [this](std::size_t i) -> std::vector<std::string> {
                                      const FamilyPoint& point = family_.points[i];
                                      return {family_.members[point.member].name, point.label};
                                  }));
        ETALON_TRY(scenes, Choose(family_.scenes.size(), choice_.scenes, "scene",
                                  [this](std::size_t i) -> std::vector<std::string> {
                                      return {family_.scenes[i].name};
                                  }));
        plan_ = {points, scenes, choice_.recipe, choice_.at, choice_.times ? choice_.seconds : 0};
        const auto place =
            std::lower_bound(plan_.points.begin(), plan_.points.end(), family_.reference);
        if (choice_.times && (place == plan_.points.end() || *place != family_.reference)) {
            plan_.points.insert(place, family_.reference);
        }
        return Ok();
    }

    ChartRecord Head() const {
        ChartRecord chart;
        chart.family = family_.address;
        chart.quantity = family_.quantity;
        chart.description = family_.description;
        chart.measure = MeasureName(family_.measure);
        chart.unit = family_.unit;
        chart.search = family_.is_search;
        chart.reference = family_.points[family_.reference].label;
        chart.published_unit = family_.published_unit;
        chart.cost_by = choice_.times ? "time" : "operations";
        chart.at = choice_.at;
        for (const std::size_t scene : plan_.scenes) {
            chart.scenes.push_back({family_.scenes[scene].name, family_.scenes[scene].description});
        }
        return chart;
    }

    void AddPoints(const std::string& device, const std::string& scene, std::vector<Found> found,
                   ChartRecord& chart) const {
        const Found* reference = nullptr;
        for (std::size_t p = 0; p < found.size(); ++p) {
            reference = plan_.points[p] == family_.reference ? &found[p] : reference;
        }
        for (std::size_t p = 0; p < found.size(); ++p) {
            Found& one = found[p];
            ChartPoint point = Name(plan_.points[p]);
            point.scene = scene;
            point.device = device;
            point.recipe = one.recipe;
            point.reason = one.reason;
            point.failed = one.failed;
            if (one.errors) {
                point.refused = family_.is_search ? !one.errors->shares_held
                                                  : family_.is_judged && one.errors->refused > 0;
                point.accuracy = AccuracyOf(*one.errors);
                point.accuracy->refused =
                    family_.is_judged && !family_.is_search ? one.errors->refused : 0;
                point.accuracy->repeat = RepeatCommand(point, *one.errors);
            }
            if (one.time) {
                point.cost = CostOfTime(*one.time, reference);
            }
            if (one.counts) {
                point.mean = CountsOf(one.counts->mean);
                point.worst = CountsOf(one.counts->worst);
            }
            chart.points.push_back(std::move(point));
        }
    }

    ChartPoint Name(std::size_t index) const {
        const FamilyPoint& named = family_.points[index];
        const FamilyMember& member = family_.members[named.member];
        ChartPoint point;
        point.member = member.name;
        point.description = member.description;
        point.label = named.label;
        for (const Setting& setting : named.settings) {
            point.settings.push_back({setting.name, setting.text, setting.number});
        }
        point.published = member.published;
        const auto& reference = family_.members[family_.points[family_.reference].member].published;
        if (member.published && reference) {
            point.published_ratio = *member.published / *reference;
        }
        return point;
    }

    // Empty where there is no input to run again.
    std::string RepeatCommand(const ChartPoint& point, const Errors& errors) const {
        if (!errors.shown) {
            return "";
        }
        std::string at;
        for (const auto& [name, value] : errors.shown->inputs) {
            at += (at.empty() ? "" : ",") + name + "=" + value.hex;
        }
        return "etalon chart " + ShellWord(choice_.name) + choice_.options + " --device " +
               ShellWord(point.device) + " --recipe " + point.recipe + " --member " +
               ShellWord(point.label) +
               (errors.shown_scene.empty() ? "" : " --scene " + ShellWord(errors.shown_scene)) +
               " --no-times --at " + ShellWord(at);
    }

    const ChartChoice& choice_;
    Family family_;
    MeasurePlan plan_;
};

}  // namespace

Result<ChartRecord> MakeChart(const ChartChoice& choice, std::ostream& notes) {
    ETALON_TRY(family, ReadFamily(choice.place.root, choice.place.file));
    return Maker(choice, std::move(family)).Make(notes);
}

}  // namespace etalon
