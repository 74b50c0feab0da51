// What the JSON reports share.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "report/chart_record.h"
#include "report/record.h"

namespace etalon {

// JSON has no NaN and no infinities: "nan", "inf", "-inf".
nlohmann::ordered_json NumberJson(double value);
nlohmann::ordered_json ValueJson(const Value& value);

nlohmann::ordered_json ObservationJson(const Observation& observation);
// All that a device tells, and its fingerprint.
nlohmann::ordered_json DeviceJson(const DeviceInfo& device);

// All of a record.
nlohmann::ordered_json RecordJson(const Record& record);

// All of a chart.
nlohmann::ordered_json ChartObject(const ChartRecord& chart);

// Paths and drivers' words may hold bytes that are not UTF-8; they are replaced, not thrown over.
std::string DumpJson(const nlohmann::ordered_json& json);

}  // namespace etalon
