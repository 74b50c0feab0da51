#include "report/chart_record.h"
#include "report/json_value.h"

namespace etalon {
namespace {

using nlohmann::ordered_json;

ordered_json AccuracyJson(const ChartAccuracy& accuracy, bool is_search) {
    ordered_json json = {{"rows", accuracy.rows},
                         {"judged", accuracy.judged},
                         {"undecided", accuracy.undecided},
                         {"worst", NumberJson(accuracy.worst)},
                         {"p999", NumberJson(accuracy.p999)},
                         {"rms", NumberJson(accuracy.rms)},
                         {"bits", NumberJson(accuracy.bits)},
                         {"not_finite", accuracy.not_finite},
                         {"refused", accuracy.refused}};
    if (is_search) {
        json["missed"] = accuracy.missed;
        json["wrong"] = accuracy.wrong;
    }
    json["worst_inputs"] = ordered_json::array();
    if (const auto& shown = accuracy.shown) {
        for (const auto& [name, value] : shown->inputs) {
            json["worst_inputs"].push_back(ordered_json::array({name, ValueJson(value)}));
        }
        json["output"] = shown->output;
        json["actual"] = ValueJson(shown->actual);
        json["expected"] = ValueJson(*shown->expected);
    }
    json["repeat"] = accuracy.repeat;
    return json;
}

ordered_json CostJson(const ChartCost& cost) {
    ordered_json json = {{"nanoseconds", NumberJson(cost.nanoseconds)},
                         {"low", NumberJson(cost.low)},
                         {"high", NumberJson(cost.high)}};
    if (cost.ratio) {
        json["ratio"] = NumberJson(cost.ratio->value);
        json["ratio_low"] = NumberJson(cost.ratio->low);
        json["ratio_high"] = NumberJson(cost.ratio->high);
    }
    json["rounds"] = cost.rounds;
    json["clock"] = cost.clock;
    return json;
}

ordered_json CountsJson(const ChartCounts& counts) {
    return {{"arithmetic", counts.arithmetic}, {"division", counts.division},
            {"special", counts.special},       {"comparison", counts.comparison},
            {"integer", counts.integer},       {"fetch", counts.fetch},
            {"other", counts.other},           {"total", counts.total}};
}

ordered_json SettingsJson(const std::vector<ChartSetting>& settings) {
    ordered_json json = ordered_json::object();
    for (const ChartSetting& setting : settings) {
        if (!setting.number) {
            json[setting.name] = setting.text;
        } else if (setting.text.find_first_of(".e") == std::string::npos) {
            json[setting.name] = static_cast<std::int64_t>(*setting.number);
        } else {
            json[setting.name] = NumberJson(*setting.number);
        }
    }
    return json;
}

ordered_json PointJson(const ChartPoint& point, bool is_search) {
    ordered_json json = {{"member", point.member},
                         {"description", point.description},
                         {"settings", SettingsJson(point.settings)},
                         {"label", point.label},
                         {"scene", point.scene},
                         {"device", point.device},
                         {"recipe", point.recipe},
                         {"reason", point.reason},
                         {"failed", point.failed},
                         {"refused", point.refused}};
    json["accuracy"] =
        point.accuracy ? AccuracyJson(*point.accuracy, is_search) : ordered_json(nullptr);
    json["cost"] = point.cost ? CostJson(*point.cost) : ordered_json(nullptr);
    json["counts"] = nullptr;
    if (point.mean && point.worst) {
        json["counts"] = {{"mean", CountsJson(*point.mean)}, {"worst", CountsJson(*point.worst)}};
    }
    if (point.published) {
        json["published"] = NumberJson(*point.published);
    }
    if (point.published_ratio) {
        json["published_ratio"] = NumberJson(*point.published_ratio);
    }
    json["front"] = point.front;
    return json;
}

}  // namespace

ordered_json ChartObject(const ChartRecord& chart) {
    ordered_json json = {{"family", chart.family},
                         {"quantity", chart.quantity},
                         {"description", chart.description},
                         {"measure", chart.measure},
                         {"unit", chart.unit},
                         {"search", chart.search},
                         {"reference", chart.reference},
                         {"published_unit", chart.published_unit},
                         {"cost_by", chart.cost_by},
                         {"at", chart.at}};
    for (const char* const key : {"scenes", "devices", "points", "bounds"}) {
        json[key] = ordered_json::array();
    }
    for (const ChartScene& scene : chart.scenes) {
        json["scenes"].push_back({{"name", scene.name}, {"description", scene.description}});
    }
    for (const DeviceInfo& device : chart.devices) {
        json["devices"].push_back(DeviceJson(device));
    }
    for (const ChartPoint& point : chart.points) {
        json["points"].push_back(PointJson(point, chart.search));
    }
    for (const ChartBound& bound : chart.bounds) {
        ordered_json one = {{"device", bound.device},
                            {"scene", bound.scene},
                            {"bound", bound.bound},
                            {"text", bound.text},
                            {"by", bound.by}};
        one["point"] = bound.point ? ordered_json(*bound.point) : ordered_json(nullptr);
        json["bounds"].push_back(std::move(one));
    }
    return json;
}

std::string ChartJson(const ChartRecord& chart) {
    return DumpJson(ChartObject(chart));
}

}  // namespace etalon
