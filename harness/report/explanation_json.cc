#include "report/explanation.h"
#include "report/json_value.h"

namespace etalon {
namespace {

using nlohmann::ordered_json;

ordered_json StepJson(const ExplainedStep& step) {
    ordered_json json = {{"number", step.number},
                         {"file", step.file},
                         {"line", step.line},
                         {"name", step.name},
                         {"operation", step.operation},
                         {"is_decision", step.is_decision},
                         {"decides_otherwise", step.decides_otherwise}};
    json["values"] = ordered_json::array();
    for (const ExplainedValue& value : step.values) {
        json["values"].push_back({{"part", value.part},
                                  {"binary32", ValueJson(value.strict)},
                                  {"exact", ValueJson(value.exact)},
                                  {"error_ulp", NumberJson(value.error_ulp)},
                                  {"amplification", NumberJson(value.amplification)},
                                  {"lost_bits", NumberJson(value.lost_bits)},
                                  {"reaches_output", value.reaches_output}});
    }
    return json;
}

ordered_json DeviceJson(const ExplainedDevice& device) {
    ordered_json json = {{"record", RecordJson(device.record)}};
    json["result"] =
        device.result.decimal.empty() ? ordered_json(nullptr) : ValueJson(device.result);
    const ExplainedParting& parting = device.parting;
    json["parting"] = {{"text", parting.text}};
    if (parting.happens) {
        json["parting"]["step"] = parting.step;
        json["parting"]["part"] = parting.part;
        json["parting"]["binary32"] = ValueJson(parting.strict);
        json["parting"]["device"] = ValueJson(parting.device);
    }
    return json;
}

}  // namespace

std::string ExplanationJson(const Explanation& explanation) {
    ordered_json inputs = ordered_json::object();
    for (const auto& [name, value] : explanation.inputs) {
        inputs[name] = ValueJson(value);
    }
    ordered_json json = {
        {"case", explanation.case_path},
        {"inputs", inputs},
        {"chosen", explanation.chosen},
        {"output", explanation.output},
        {"rule", explanation.rule},
        {"truth", explanation.truth ? ValueJson(*explanation.truth) : ordered_json(nullptr)},
        {"exact", ValueJson(explanation.method)},
        {"binary32", ValueJson(explanation.strict)},
        {"worst_step", explanation.worst_step},
        {"is_cut", explanation.is_cut}};
    json["devices"] = ordered_json::array();
    for (const ExplainedDevice& device : explanation.devices) {
        json["devices"].push_back(DeviceJson(device));
    }
    json["steps"] = ordered_json::array();
    for (const ExplainedStep& step : explanation.steps) {
        json["steps"].push_back(StepJson(step));
    }
    return DumpJson(json);
}

}  // namespace etalon
