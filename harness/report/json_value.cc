#include "report/json_value.h"

#include <cmath>

namespace etalon {

using nlohmann::ordered_json;

ordered_json NumberJson(double value) {
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

std::string DumpJson(const ordered_json& json) {
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace etalon
