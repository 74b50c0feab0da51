#include "base/format.h"
#include "report/json_value.h"
#include "report/sweep_record.h"

namespace etalon {
namespace {

using nlohmann::ordered_json;

ordered_json SeenJson(const std::optional<Observation>& seen, const SweepRecord& sweep) {
    if (!seen) {
        return nullptr;
    }
    ordered_json inputs = ordered_json::object();
    std::string at;
    for (const auto& [name, value] : seen->inputs) {
        inputs[name] = ValueJson(value);
        at += (at.empty() ? "" : ",") + name + "=" + value.hex;
    }
    return {{"inputs", inputs},
            {"actual", ValueJson(seen->actual)},
            {"expected", ValueJson(*seen->expected)},
            {"error", NumberJson(seen->error)},
            {"ulp_error", NumberJson(seen->ulp_error)},
            {"used", NumberJson(seen->used)},
            {"repeat", sweep.repeat + " --at " + at}};
}

ordered_json OutputJson(const SweptOutput& output, const SweepRecord& sweep) {
    ordered_json json = {{"output", output.name},
                         {"rule", output.rule},
                         {"judged", output.judged},
                         {"refused", output.refused},
                         {"worst_ulp", SeenJson(output.worst_ulp, sweep)},
                         {"worst_used", SeenJson(output.worst_used, sweep)},
                         {"first_refused", SeenJson(output.first_refused, sweep)}};
    json["histogram"] = ordered_json::array();
    for (std::size_t bin = 0; bin < output.histogram.size(); ++bin) {
        json["histogram"].push_back({{"up_to_ulp", NumberJson(output.histogram[bin].upper)},
                                     {"is_finite", bin + 1 < output.histogram.size()},
                                     {"count", output.histogram[bin].count}});
    }
    return json;
}

}  // namespace

std::string SweepKey(const SweepRecord& sweep) {
    return format("{} over {}={}..{}{} on {} ({}){}", sweep.case_path, sweep.input,
                  sweep.from.decimal, sweep.to.decimal,
                  sweep.fixed.empty() ? "" : " at " + sweep.fixed, sweep.device, sweep.recipe,
                  sweep.shard.empty() ? "" : ", " + sweep.shard);
}

std::string SweepJson(const SweepRecord& sweep) {
    ordered_json json = {{"case", sweep.case_path},       {"device", sweep.device},
                         {"driver", sweep.driver},        {"fingerprint", sweep.fingerprint},
                         {"recipe", sweep.recipe},        {"input", sweep.input},
                         {"from", ValueJson(sweep.from)}, {"to", ValueJson(sweep.to)},
                         {"fixed", sweep.fixed},          {"settings", sweep.settings},
                         {"floats", sweep.floats},        {"laws_not_held", sweep.laws},
                         {"shard", sweep.shard},          {"rows", sweep.rows},
                         {"all_rows", sweep.all_rows},    {"verdict", VerdictName(sweep.verdict)},
                         {"reason", sweep.reason}};
    json["outputs"] = ordered_json::array();
    for (const SweptOutput& output : sweep.outputs) {
        json["outputs"].push_back(OutputJson(output, sweep));
    }
    return DumpJson(json);
}

}  // namespace etalon
