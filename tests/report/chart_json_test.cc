#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "report/chart_record.h"

namespace etalon {
namespace {

using nlohmann::json;
using testing::ElementsAre;

std::vector<std::string> KeysOf(const json& object) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items()) {
        keys.push_back(key);
    }
    return keys;
}

ChartRecord ChartOfTwo() {
    ChartRecord chart;
    chart.family = "optics/x";
    chart.search = true;
    chart.cost_by = "time";
    chart.scenes = {{"sine", "waves"}};
    chart.devices.emplace_back().name = "vulkan:d";
    ChartPoint point;
    point.member = "linear";
    point.label = "linear, STEPS=8, MODE=fast";
    point.settings = {{"STEPS", "8", 8.0}, {"MODE", "fast", std::nullopt}, {"BIAS", "0.5", 0.5}};
    point.scene = "all";
    point.device = "vulkan:d";
    chart.points.push_back(point);
    ChartAccuracy accuracy;
    accuracy.worst = std::numeric_limits<double>::infinity();
    accuracy.missed = 0.25;
    accuracy.repeat = "etalon chart optics/x";
    Observation& shown = accuracy.shown.emplace();
    shown.output = "result";
    shown.inputs = {{"x", {"0.5", "0x1p-1"}}};
    shown.actual = {"1", "0x1p+0"};
    shown.expected = Value{"2", "0x1p+1"};
    point.accuracy = accuracy;
    ChartCost cost;
    cost.nanoseconds = 3;
    cost.ratio = ChartCost::Ratio{1, 0.9, 1.1};
    cost.clock = "host clock";
    point.cost = cost;
    point.mean.emplace().fetch = 4;
    point.worst = point.mean;
    point.published = 22.8;
    point.published_ratio = 1.5;
    point.front = true;
    chart.points.push_back(point);
    chart.bounds = {{"vulkan:d", "all", 0.25, "1/4", "p999", 1},
                    {"vulkan:d", "all", 0.25, "1/4", "worst", std::nullopt}};
    return chart;
}

TEST(ChartJsonTest, HasItsShape) {
    const json chart = json::parse(ChartJson(ChartOfTwo()));
    EXPECT_EQ(chart["family"], "optics/x");
    EXPECT_EQ(chart["scenes"], json::parse(R"([{"name":"sine","description":"waves"}])"));
    EXPECT_EQ(chart["devices"][0]["name"], "vulkan:d");
    EXPECT_TRUE(chart["devices"][0].contains("fingerprint"));
    const json& empty = chart["points"][0];
    EXPECT_TRUE(empty["accuracy"].is_null());
    EXPECT_TRUE(empty["cost"].is_null());
    EXPECT_TRUE(empty["counts"].is_null());
    EXPECT_FALSE(empty.contains("published"));
    EXPECT_EQ(empty["settings"], json::parse(R"({"BIAS":0.5,"MODE":"fast","STEPS":8})"));
    EXPECT_TRUE(empty["settings"]["STEPS"].is_number_integer());
    const json& point = chart["points"][1];
    EXPECT_EQ(point["accuracy"]["worst"], "inf");
    EXPECT_EQ(point["accuracy"]["missed"], 0.25);
    EXPECT_EQ(point["accuracy"]["worst_inputs"],
              json::parse(R"([["x",{"decimal":"0.5","hex":"0x1p-1"}]])"));
    EXPECT_EQ(point["accuracy"]["expected"]["decimal"], "2");
    EXPECT_EQ(point["accuracy"]["repeat"], "etalon chart optics/x");
    EXPECT_THAT(KeysOf(point["cost"]), ElementsAre("clock", "high", "low", "nanoseconds", "ratio",
                                                   "ratio_high", "ratio_low", "rounds"));
    EXPECT_THAT(KeysOf(point["counts"]["mean"]),
                ElementsAre("arithmetic", "comparison", "division", "fetch", "integer", "other",
                            "special", "total"));
    EXPECT_EQ(point["counts"]["worst"]["fetch"], 4);
    EXPECT_EQ(point["published_ratio"], 1.5);
    EXPECT_EQ(point["front"], true);
    EXPECT_EQ(chart["bounds"][0]["point"], 1);
    EXPECT_EQ(chart["bounds"][0]["text"], "1/4");
    EXPECT_TRUE(chart["bounds"][1]["point"].is_null());
}

TEST(ChartJsonTest, OnlyASearchHasShares) {
    ChartRecord chart = ChartOfTwo();
    chart.search = false;
    EXPECT_FALSE(json::parse(ChartJson(chart))["points"][1]["accuracy"].contains("missed"));
}

}  // namespace
}  // namespace etalon
