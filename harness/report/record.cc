#include "report/record.h"

#include <fstream>

#include "base/format.h"
#include "base/hash.h"

namespace etalon {

std::string_view VerdictName(Verdict verdict) {
    switch (verdict) {
        case Verdict::kPass:
            return "pass";
        case Verdict::kFail:
            return "fail";
        case Verdict::kNonconforming:
            return "nonconforming";
        case Verdict::kSkip:
            return "skip";
        case Verdict::kCrash:
            return "crash";
        case Verdict::kTimeout:
            return "timeout";
    }
    return "";
}

std::string ProcessorName() {
    std::ifstream info("/proc/cpuinfo");
    std::string line;
    while (std::getline(info, line)) {
        if (line.starts_with("model name")) {
            const std::size_t colon = line.find(": ");
            return colon == std::string::npos ? line : line.substr(colon + 2);
        }
    }
    return "unknown processor";
}

std::string Fingerprint(const DeviceInfo& device) {
    std::string all = device.description + "|" + device.driver + "|" + device.version + "|" +
                      device.api + "|" + device.compiler + "|" + ProcessorName();
    for (const auto* list : {&device.features, &device.float_controls}) {
        for (const std::string& word : *list) {
            all += "|" + word;
        }
    }
    Hash hash;
    hash.Add(all);
    return format("{:012x}", hash.value() >> 16);
}

}  // namespace etalon
