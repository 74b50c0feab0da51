#include "report/json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/records.h"

namespace etalon {
namespace {

using nlohmann::json;

RunRecord SomeRun() {
    RunRecord run;
    run.version = "1.2.3";
    run.devices = {Llvmpipe(), Silent()};
    run.absent = {{"egl:zink", "is not installed"}};
    run.records = {Passed(), Refused(), Without(Verdict::kTimeout, "no answer within 10 s")};
    run.seconds = 1.5;
    return run;
}

TEST(RunJson, ReadsBack) {
    const json read = json::parse(RunJson(SomeRun()));
    EXPECT_EQ(read["version"], "1.2.3");
    EXPECT_EQ(read["processor"], ProcessorName());
    EXPECT_EQ(read["seconds"], 1.5);
    EXPECT_EQ(read["absent"],
              json::parse(R"([{"name": "egl:zink", "reason": "is not installed"}])"));
    ASSERT_EQ(read["devices"].size(), 2u);
    EXPECT_EQ(read["devices"][0]["name"], "osmesa:llvmpipe");
    EXPECT_EQ(read["devices"][0]["fingerprint"], Fingerprint(Llvmpipe()));
    ASSERT_EQ(read["records"].size(), 3u);
    EXPECT_EQ(read["records"][0], json::parse(R"({
        "case": "optics/fresnel", "device": "osmesa:llvmpipe", "recipe": "glsl", "family": "",
        "covers": ["F4", "D14"], "verdict": "pass", "reason": "", "seed": 7, "rows": 100, "all_rows": 100, "judged": 300, "refused": 0,
        "failed": [], "repeat": "etalon run optics/fresnel --at 'n1=0x1.8p+0,steps=3'",
        "known_cause": "", "figures": [], "flake": "", "seconds": 0.125,
        "specification": null, "culprits": {}, "worst_parts": {},
        "worst": {"output": "result.x", "rule": "ulp 16 or absolute 1e-09",
                  "inputs": {"n1": {"decimal": "1.5", "hex": "0x1.8p+0"},
                             "steps": {"decimal": "3", "hex": "3"}},
                  "actual": {"decimal": "0.1", "hex": "0x1.99999ap-4"},
                  "expected": {"decimal": "0.10000001", "hex": "0x1.99999cp-4"},
                  "error": 7.45e-9, "ulp_error": 4.0, "used": 0.25}})"));
    EXPECT_EQ(read["records"][1]["failed"], json::parse(R"(["result.x", "law 'energy'"])"));
    EXPECT_EQ(
        read["records"][1]["figures"],
        json::parse(R"([{"expected": "ulp 4 within 0.01", "seen": "inf", "agrees": false}])"));
    EXPECT_EQ(read["records"][2]["verdict"], "timeout");
    EXPECT_EQ(read["records"][2]["worst"], nullptr);
}

TEST(RunJson, TellsOfTheBudgetAndTheSpecification) {
    RunRecord run;
    run.records = {Outside()};
    run.records[0].culprits = {{"driver", 2}};
    const json read = json::parse(RunJson(run))["records"][0];
    EXPECT_EQ(read["verdict"], "nonconforming");
    EXPECT_EQ(read["culprits"], json::parse(R"({"driver": 2})"));
    EXPECT_EQ(read["worst_parts"]["driver"]["ulp"], 12);
    EXPECT_EQ(read["worst_parts"]["driver"]["absolute"], 1e-7);
    EXPECT_EQ(read["worst_parts"]["driver"]["output"], "result.x");
    EXPECT_EQ(read["worst_parts"]["driver"]["inputs"]["n1"]["decimal"], "1.5");
    EXPECT_FALSE(read["worst_parts"].contains("rounding"));
    const json& held = read["specification"];
    EXPECT_EQ(held["profile"], "vulkan-1.3");
    EXPECT_EQ(held["held"], 300);
    EXPECT_EQ(held["unbounded"], 20);
    EXPECT_EQ(held["void_bounds"], 0);
    EXPECT_EQ(held["outside"], 3);
    EXPECT_EQ(held["outside_in"], json::parse(R"(["result.x"])"));
    EXPECT_EQ(held["worst_outside"]["allowed"], json::parse(R"({
        "low": {"decimal": "0.1", "hex": "0x1.99999ap-4"},
        "high": {"decimal": "0.11", "hex": "0x1.c28f5cp-4"}, "excess_ulp": 12.0})"));
    EXPECT_EQ(held["worst_outside"]["budget"], json::parse(R"({
        "culprit": "driver", "law": false, "method": {"ulp": 0.25, "absolute": 1e-9},
        "rounding": {"ulp": 0.0, "absolute": 0.0}, "driver": {"ulp": 12.0, "absolute": 1e-7}})"));
}

TEST(RunJson, HasNullForWhatThereIsNot) {
    RunRecord run;
    run.records = {Outside()};
    run.records[0].worst_outside->expected.reset();
    run.records[0].worst_outside->budget->method.reset();
    run.records[0].worst_outside->allowed->bounded = false;
    const json outside = json::parse(RunJson(run))["records"][0]["specification"]["worst_outside"];
    EXPECT_EQ(outside["expected"], nullptr);
    EXPECT_EQ(outside["budget"]["method"], nullptr);
    EXPECT_EQ(outside["allowed"], "unbounded");
}

TEST(RunJson, CountsWhatIsOff) {
    RunRecord run = SomeRun();
    ShareCount search;
    search.output = "result";
    search.search = true;
    search.rows = 1000;
    search.wrong = 4;
    search.wrong_allowed = 0.01;
    search.hits = 900;
    search.missed = 3;
    search.missed_allowed = 0.5;
    search.worst_right = 0.25;
    search.undecided = 2;
    run.records[0].shares = {search, {.output = "layer", .rows = 7}};
    const json read = json::parse(RunJson(run));
    EXPECT_EQ(read["records"][0]["shares"], json::parse(R"([
        {"output": "result", "rows": 1000, "undecided": 2, "wrong": 4, "wrong_allowed": 0.01,
         "hits": 900, "missed": 3, "missed_allowed": 0.5, "worst_right": 0.25},
        {"output": "layer", "rows": 7, "undecided": 0, "wrong": 0, "wrong_allowed": 0.0}])"));
    EXPECT_FALSE(read["records"][1].contains("shares"));
}

TEST(RunJson, WritesNumbersThatJsonDoesNotKnowAsText) {
    RunRecord run = SomeRun();
    run.records[1].worst->error = std::nan("");
    run.records[1].worst->used = -std::numeric_limits<double>::infinity();
    const json worst = json::parse(RunJson(run))["records"][1]["worst"];
    EXPECT_EQ(worst["ulp_error"], "inf");
    EXPECT_EQ(worst["error"], "nan");
    EXPECT_EQ(worst["used"], "-inf");
}

TEST(RunJson, SurvivesTextThatIsNoUtf8) {
    RunRecord run = SomeRun();
    run.records[2].reason = "driver says \xff\xfe\x80 and \xc3";
    run.devices[0].description = "\xf0\x9f\x94";
    const json read = json::parse(RunJson(run));
    EXPECT_EQ(read["records"][2]["reason"], "driver says \ufffd\ufffd\ufffd and \ufffd");
    run.records[2].reason = "quotes \" and \\ and \n and \x01 and \xc3\xa9";
    EXPECT_EQ(json::parse(RunJson(run))["records"][2]["reason"], run.records[2].reason);
}

TEST(RunJson, KeepsTheInputsInOrder) {
    RunRecord run = SomeRun();
    run.records[0].worst->inputs = {{"z", {"1", "1"}}, {"a", {"2", "2"}}, {"v.x", {"3", "3"}}};
    const auto read = nlohmann::ordered_json::parse(RunJson(run));
    std::string names;
    for (const auto& [name, value] : read["records"][0]["worst"]["inputs"].items()) {
        names += name + " ";
    }
    EXPECT_EQ(names, "z a v.x ");
}

TEST(RunJson, EndsWithALine) {
    EXPECT_TRUE(RunJson({}).ends_with("}\n"));
    EXPECT_EQ(json::parse(RunJson({}))["records"], json::array());
}

TEST(DevicesJson, IsTheListOfDevices) {
    const json read = json::parse(DevicesJson(SomeRun()));
    ASSERT_TRUE(read.is_array());
    EXPECT_EQ(read, json::parse(RunJson(SomeRun()))["devices"]);
    EXPECT_EQ(read[0], json::parse(R"json({
        "name": "osmesa:llvmpipe", "description": "llvmpipe (LLVM 15.0.6, 256 bits)",
        "driver": "Mesa", "version": "22.3.6", "api": "OpenGL 4.5 core", "glsl_version": 450,
        "compiler": "LLVM 15.0.6, 256 bits", "features": ["glsl", "compute"],
        "float_controls": ["RoundingModeRTE"], "fingerprint": ")json" +
                                   Fingerprint(Llvmpipe()) + "\"}"));
}

}  // namespace
}  // namespace etalon
