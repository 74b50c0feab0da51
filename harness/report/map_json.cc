#include "report/json_value.h"
#include "report/map_record.h"

namespace etalon {
namespace {

using nlohmann::ordered_json;

ordered_json NumbersJson(const std::vector<double>& numbers) {
    ordered_json json = ordered_json::array();
    for (const double number : numbers) {
        json.push_back(NumberJson(number));
    }
    return json;
}

ordered_json NumbersOrNull(const std::vector<double>& numbers) {
    return numbers.empty() ? ordered_json(nullptr) : NumbersJson(numbers);
}

ordered_json AxisJson(const MapAxis& axis) {
    return {{"name", axis.name},
            {"scale", axis.is_log ? "log" : "linear"},
            {"edges", NumbersJson(axis.edges)},
            {"values", NumbersJson(axis.values)}};
}

ordered_json DeviceJson(const MappedDevice& device) {
    ordered_json marks = ordered_json::array();
    for (const MapMark mark : device.mark) {
        marks.push_back(static_cast<int>(mark));
    }
    return {{"device", device.device},
            {"recipe", device.recipe},
            {"driver", device.driver},
            {"reason", device.reason},
            {"error", NumbersJson(device.error)},
            {"mark", std::move(marks)},
            {"worst", device.worst ? ObservationJson(*device.worst) : ordered_json(nullptr)}};
}

ordered_json PredictionJson(const PredictionSeen& prediction) {
    ordered_json cells = ordered_json::array();
    for (const MapForecast cell : prediction.cells) {
        cells.push_back(static_cast<int>(cell));
    }
    ordered_json agreement = ordered_json::array();
    for (const MapAgreement& one : prediction.agreement) {
        agreement.push_back({{"device", one.device},
                             {"safe", one.safe},
                             {"safe_held", one.safe_held},
                             {"fails", one.fails},
                             {"failed", one.failed}});
    }
    return {{"fails", prediction.fails},
            {"safe", prediction.safe},
            {"because", prediction.because},
            {"cells", std::move(cells)},
            {"agreement", std::move(agreement)}};
}

}  // namespace

std::string MapJson(const MapRecord& map) {
    ordered_json marks = ordered_json::array();
    for (const char* const name : kMapMarkNames) {
        marks.push_back(name);
    }
    ordered_json devices = ordered_json::array();
    for (const MappedDevice& device : map.devices) {
        devices.push_back(DeviceJson(device));
    }
    const ordered_json json = {
        {"case", map.case_path},
        {"description", map.description},
        {"output", map.output},
        {"measure", map.measure},
        {"tolerance", map.tolerance},
        {"x", AxisJson(map.x)},
        {"y", AxisJson(map.y)},
        {"fixed", map.fixed},
        {"search", map.search},
        {"marks", std::move(marks)},
        {"devices", std::move(devices)},
        {"condition", NumbersOrNull(map.condition)},
        {"disagreement", NumbersOrNull(map.disagreement)},
        {"prediction", map.prediction ? PredictionJson(*map.prediction) : ordered_json(nullptr)},
        {"repeat", map.repeat}};
    return DumpJson(json);
}

}  // namespace etalon
