#include "report/json.h"

#include "report/json_value.h"

namespace etalon {
namespace {

using nlohmann::ordered_json;

ordered_json InputsJson(const std::vector<std::pair<std::string, Value>>& inputs) {
    ordered_json json = ordered_json::object();
    for (const auto& [name, value] : inputs) {
        json[name] = ValueJson(value);
    }
    return json;
}

ordered_json PartJson(const PartSeen& part) {
    return {{"ulp", NumberJson(part.ulp)}, {"absolute", NumberJson(part.absolute)}};
}

ordered_json BudgetJson(const Budget& budget) {
    ordered_json json = {{"culprit", budget.culprit}, {"law", budget.is_law}};
    json["method"] = budget.method ? PartJson(*budget.method) : ordered_json(nullptr);
    json["rounding"] = PartJson(budget.rounding);
    json["driver"] = PartJson(budget.driver);
    return json;
}

ordered_json AllowedJson(const AllowedValue& allowed) {
    if (!allowed.bounded) {
        return "unbounded";
    }
    ordered_json json = {{"low", ValueJson(allowed.low)},
                         {"high", ValueJson(allowed.high)},
                         {"excess_ulp", NumberJson(allowed.excess)}};
    if (allowed.quantum) {
        json["multiples_of"] = ValueJson(*allowed.quantum);
    }
    return json;
}

}  // namespace

ordered_json ObservationJson(const Observation& observation) {
    ordered_json json = {{"output", observation.output},
                         {"rule", observation.rule},
                         {"inputs", InputsJson(observation.inputs)},
                         {"actual", ValueJson(observation.actual)},
                         {"expected", observation.expected ? ValueJson(*observation.expected)
                                                           : ordered_json(nullptr)},
                         {"error", NumberJson(observation.error)},
                         {"ulp_error", NumberJson(observation.ulp_error)},
                         {"used", NumberJson(observation.used)}};
    if (observation.budget) {
        json["budget"] = BudgetJson(*observation.budget);
    }
    if (observation.allowed) {
        json["allowed"] = AllowedJson(*observation.allowed);
    }
    return json;
}

namespace {

// What the record was held to, and what its errors are made of.
ordered_json SpecificationJson(const Record& record) {
    ordered_json json = {{"profile", record.profile},
                         {"unevaluated", record.unevaluated},
                         {"held", record.held},
                         {"unbounded", record.unbounded},
                         {"void_bounds", record.void_bounds},
                         {"outside", record.outside},
                         {"outside_in", record.outside_in},
                         {"unjudged", record.unjudged}};
    json["worst_outside"] =
        record.worst_outside ? ObservationJson(*record.worst_outside) : ordered_json(nullptr);
    return json;
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
        json["worst_right"] = NumberJson(count.worst_right);
    }
    return json;
}

ordered_json FindingValueJson(const FindingValue& value) {
    ordered_json json = {{"decimal", value.decimal}, {"hex", value.hex}, {"word", value.word}};
    if (!value.name.empty()) {
        json["name"] = value.name;
    }
    return json;
}

ordered_json FindingJson(const Finding& finding) {
    ordered_json json = {{"devices", finding.devices},
                         {"case", finding.case_path},
                         {"call", finding.call},
                         {"recipe", finding.recipe},
                         {"profile", finding.profile},
                         {"output", finding.output},
                         {"inputs", ordered_json::array()},
                         {"actual", FindingValueJson(finding.actual)},
                         {"strict", FindingValueJson(finding.strict)},
                         {"low", FindingValueJson(finding.low)},
                         {"high", FindingValueJson(finding.high)},
                         {"excess_ulp", NumberJson(finding.excess)},
                         {"outside", finding.outside},
                         {"held", finding.held},
                         {"cause", finding.cause},
                         {"reproducer", finding.reproducer},
                         {"doubt", finding.doubt}};
    for (const FindingValue& input : finding.inputs) {
        json["inputs"].push_back(FindingValueJson(input));
    }
    return json;
}

}  // namespace

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
                         {"seconds", NumberJson(record.seconds)}};
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
    json["specification"] =
        record.profile.empty() ? ordered_json(nullptr) : SpecificationJson(record);
    json["culprits"] = ordered_json::object();
    for (const auto& [culprit, values] : record.culprits) {
        json["culprits"][culprit] = values;
    }
    json["worst_parts"] = ordered_json::object();
    for (const WorstPart& worst : record.parts) {
        json["worst_parts"][worst.part] = PartJson(worst.seen);
        json["worst_parts"][worst.part]["output"] = worst.output;
        json["worst_parts"][worst.part]["inputs"] = InputsJson(worst.inputs);
    }
    json["worst"] = record.worst ? ObservationJson(*record.worst) : ordered_json(nullptr);
    return json;
}

std::string DevicesJson(const RunRecord& run) {
    ordered_json devices = ordered_json::array();
    for (const DeviceInfo& device : run.devices) {
        devices.push_back(DeviceJson(device));
    }
    return DumpJson(devices);
}

std::string RunJson(const RunRecord& run) {
    ordered_json json = {{"version", run.version},           {"processor", ProcessorName()},
                         {"seconds", run.seconds},           {"devices", ordered_json::array()},
                         {"absent", ordered_json::array()},  {"records", ordered_json::array()},
                         {"findings", ordered_json::array()}};
    for (const DeviceInfo& device : run.devices) {
        json["devices"].push_back(DeviceJson(device));
    }
    for (const DeviceNote& note : run.absent) {
        json["absent"].push_back({{"name", note.name}, {"reason", note.reason}});
    }
    for (const Record& record : run.records) {
        json["records"].push_back(RecordJson(record));
    }
    for (const Finding& finding : run.findings) {
        json["findings"].push_back(FindingJson(finding));
    }
    return DumpJson(json);
}

}  // namespace etalon
