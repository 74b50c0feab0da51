#include "report/finding.h"

#include <algorithm>
#include <set>

#include "base/format.h"
#include "report/record.h"
#include "report/text.h"

namespace etalon {
namespace {

std::string Joined(const std::vector<std::string>& texts) {
    std::string joined;
    for (const std::string& text : texts) {
        joined += (joined.empty() ? "" : ", ") + text;
    }
    return joined;
}

std::string Text(const FindingValue& value) {
    const std::string bits = format(" ({:#010x})", value.word);
    return (value.name.empty() ? "" : value.name + " = ") + value.decimal +
           (value.hex == value.decimal ? "" : " = " + value.hex) + bits;
}

// Longer input lists are the reproducer's.
std::string InputsText(const Finding& finding) {
    constexpr std::size_t kMost = 9;
    std::string text;
    for (std::size_t i = 0; i < std::min(finding.inputs.size(), kMost); ++i) {
        text += (i == 0 ? "" : ", ") + Text(finding.inputs[i]);
    }
    return text + (finding.inputs.size() > kMost ? ", ..." : "");
}

// What a device was held to, over all records.
std::string HeldText(const RunRecord& run, const std::string& device) {
    std::set<std::string> cases;
    std::set<std::string> outside_cases;
    std::set<std::string> profiles;
    std::uint64_t held = 0;
    std::uint64_t unbounded = 0;
    std::uint64_t outside = 0;
    for (const Record& record : run.records) {
        if (record.device != device || record.held == 0) {
            continue;
        }
        cases.insert(record.case_path);
        profiles.insert(record.profile);
        held += record.held;
        unbounded += record.unbounded;
        outside += record.outside;
        if (record.outside > 0) {
            outside_cases.insert(record.case_path);
        }
    }
    if (cases.empty()) {
        return "held to nothing";
    }
    return format("held to {}, cases {}, values {}: outside {}, in cases {}; without a bound {}",
                  Joined({profiles.begin(), profiles.end()}), cases.size(), held, outside,
                  outside_cases.size(), unbounded);
}

std::string Entry(const Finding& finding, const std::string& reproducers) {
    std::string text =
        format("### `{}` on {}\n\n- case: {}, recipe {}\n- worst input: {}\n- {}: {}\n",
               finding.call, Joined(finding.devices), finding.case_path, finding.recipe,
               InputsText(finding), finding.output, Text(finding.actual));
    text += format("- {} allows: {}\n", finding.profile,
                   finding.low.word == finding.high.word
                       ? Text(finding.low)
                       : Text(finding.low) + " to " + Text(finding.high));
    text +=
        format("- strict binary32: {}\n- outside by: {} ulp; {} of {} values are outside\n",
               Text(finding.strict), ShortNumber(finding.excess), finding.outside, finding.held);
    if (!finding.cause.empty()) {
        text += "- cause: " + finding.cause + "\n";
    }
    if (!finding.doubt.empty()) {
        text += "- does not stand: " + finding.doubt + "\n";
    } else {
        text += format("- reproducer: [{0}]({1}/{0})\n", finding.reproducer, reproducers);
    }
    return text + "\n";
}

}  // namespace

std::string FindingsMarkdown(const RunRecord& run, const std::string& reproducers) {
    std::string text =
        "# Findings\n\nWritten by `etalon run --findings`: results that the device's specification "
        "does not allow, of each case and implementation the one furthest outside. A finding "
        "stands where the strict evaluation in binary32 is itself allowed and a file of its own "
        "shows the result by other tools: `ci/reproduce.sh` runs these.\n\n## Devices\n\n";
    for (const DeviceInfo& device : run.devices) {
        text +=
            format("- {}: {}, {} {}, fingerprint {}; {}\n", device.name, device.description,
                   device.driver, device.version, Fingerprint(device), HeldText(run, device.name));
    }
    std::string standing;
    std::string doubtful;
    for (const Finding& finding : run.findings) {
        (finding.doubt.empty() ? standing : doubtful) += Entry(finding, reproducers);
    }
    text += "\n## What stands\n\n" + (standing.empty() ? "Nothing.\n\n" : standing);
    text += "## What does not stand\n\n" + (doubtful.empty() ? "Nothing.\n" : doubtful);
    while (text.ends_with("\n\n")) {
        text.pop_back();
    }
    return text;
}

}  // namespace etalon
