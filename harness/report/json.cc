#include "report/json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace etalon {
namespace {

using nlohmann::ordered_json;

ordered_json Number(double value) {
    if (std::isnan(value)) {
        return "nan";
    }
    if (std::isinf(value)) {
        return value > 0 ? "inf" : "-inf";
    }
    return value;
}

ordered_json ValueJson(const Value& value) {
    return {{"decimal", value.decimal}, {"hex", value.hex}};
}

ordered_json DeviceJson(const DeviceInfo& device) {
    return {{"name", device.name},
            {"description", device.description},
            {"driver", device.driver},
            {"version", device.version},
            {"api", device.api},
            {"glsl_version", device.glsl_version},
            {"compiler", device.compiler},
            {"features", device.features},
            {"float_controls", device.float_controls},
            {"fingerprint", Fingerprint(device)}};
}

ordered_json ObservationJson(const Observation& observation) {
    ordered_json inputs = ordered_json::object();
    for (const auto& [name, value] : observation.inputs) {
        inputs[name] = ValueJson(value);
    }
    return {{"output", observation.output},
            {"rule", observation.rule},
            {"inputs", inputs},
            {"actual", ValueJson(observation.actual)},
            {"expected", ValueJson(observation.expected)},
            {"error", Number(observation.error)},
            {"ulp_error", Number(observation.ulp_error)},
            {"used", Number(observation.used)}};
}

ordered_json ShareJson(const ShareCount& count) {
    ordered_json json = {{"output", count.output},
                         {"rows", count.rows},
                         {"undecided", count.undecided},
                         {"wrong", count.wrong},
                         {"wrong_allowed", count.wrong_allowed}};
    if (count.search) {
        json["hits"] = count.hits;
        json["missed"] = count.missed;
        json["missed_allowed"] = count.missed_allowed;
        json["worst_right"] = Number(count.worst_right);
    }
    return json;
}

ordered_json RecordJson(const Record& record) {
    ordered_json json = {{"case", record.case_path},
                         {"device", record.device},
                         {"recipe", record.recipe},
                         {"family", record.family},
                         {"covers", record.covers},
                         {"verdict", VerdictName(record.verdict)},
                         {"reason", record.reason},
                         {"seed", record.seed},
                         {"rows", record.rows},
                         {"all_rows", record.all_rows},
                         {"judged", record.judged},
                         {"refused", record.refused},
                         {"failed", record.failed},
                         {"repeat", record.repeat},
                         {"known_cause", record.known_cause},
                         {"flake", record.flake},
                         {"seconds", Number(record.seconds)}};
    json["figures"] = ordered_json::array();
    for (const FigureSeen& figure : record.figures) {
        json["figures"].push_back(
            {{"expected", figure.expected}, {"seen", figure.seen}, {"agrees", figure.agrees}});
    }
    if (!record.shares.empty()) {
        json["shares"] = ordered_json::array();
        for (const ShareCount& count : record.shares) {
            json["shares"].push_back(ShareJson(count));
        }
    }
    json["worst"] = record.worst ? ObservationJson(*record.worst) : ordered_json(nullptr);
    return json;
}

// Paths and drivers' words may hold bytes that are not UTF-8; they are replaced, not thrown over.
std::string Dump(const ordered_json& json) {
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string DevicesJson(const RunRecord& run) {
    ordered_json devices = ordered_json::array();
    for (const DeviceInfo& device : run.devices) {
        devices.push_back(DeviceJson(device));
    }
    return Dump(devices);
}

std::string RunJson(const RunRecord& run) {
    ordered_json json = {{"version", run.version},          {"processor", ProcessorName()},
                         {"seconds", run.seconds},          {"devices", ordered_json::array()},
                         {"absent", ordered_json::array()}, {"records", ordered_json::array()}};
    for (const DeviceInfo& device : run.devices) {
        json["devices"].push_back(DeviceJson(device));
    }
    for (const DeviceNote& note : run.absent) {
        json["absent"].push_back({{"name", note.name}, {"reason", note.reason}});
    }
    for (const Record& record : run.records) {
        json["records"].push_back(RecordJson(record));
    }
    return Dump(json);
}

}  // namespace etalon
