// Records as runs leave them.
#pragma once

#include <limits>

#include "report/record.h"

namespace etalon {

inline DeviceInfo Llvmpipe() {
    DeviceInfo info;
    info.name = "osmesa:llvmpipe";
    info.description = "llvmpipe (LLVM 15.0.6, 256 bits)";
    info.driver = "Mesa";
    info.version = "22.3.6";
    info.api = "OpenGL 4.5 core";
    info.compiler = "LLVM 15.0.6, 256 bits";
    info.features = {"glsl", "compute"};
    info.float_controls = {"RoundingModeRTE"};
    info.glsl_version = 450;
    return info;
}

inline DeviceInfo Silent() {
    DeviceInfo info;
    info.name = "vulkan:silent@new";
    info.description = "Silent";
    info.driver = "silent";
    info.version = "1";
    info.api = "Vulkan 1.3.0";
    return info;
}

inline Record Passed() {
    Record record;
    record.case_path = "optics/fresnel";
    record.device = "osmesa:llvmpipe";
    record.recipe = "glsl";
    record.covers = {"F4", "D14"};
    record.seed = 7;
    record.rows = 100;
    record.all_rows = 100;
    record.judged = 300;
    Observation worst;
    worst.output = "result.x";
    worst.rule = "ulp 16 or absolute 1e-09";
    worst.inputs = {{"n1", {"1.5", "0x1.8p+0"}}, {"steps", {"3", "3"}}};
    worst.actual = {"0.1", "0x1.99999ap-4"};
    worst.expected = {"0.10000001", "0x1.99999cp-4"};
    worst.error = 7.45e-9;
    worst.ulp_error = 4;
    worst.used = 0.25;
    record.worst = worst;
    record.repeat = "etalon run optics/fresnel --at 'n1=0x1.8p+0,steps=3'";
    record.seconds = 0.125;
    return record;
}

inline Record Refused() {
    Record record = Passed();
    record.verdict = Verdict::kFail;
    record.refused = 2;
    record.failed = {"result.x", "law 'energy'"};
    record.worst->ulp_error = std::numeric_limits<double>::infinity();
    record.worst->error = std::numeric_limits<double>::infinity();
    record.worst->used = std::numeric_limits<double>::infinity();
    record.worst->actual = {"nan", "nan"};
    record.figures = {{"ulp 4 within 0.01", "inf", false}};
    return record;
}

// All within the tolerance; three values outside the specification.
inline Record Outside() {
    Record record = Passed();
    record.verdict = Verdict::kNonconforming;
    record.failed = record.outside_in = {"result.x"};
    record.profile = "vulkan-1.3";
    record.held = 300;
    record.unbounded = 20;
    record.outside = 3;
    record.parts = {{"method", "result.x", record.worst->inputs, {1e-9, 0.25}},
                    {"driver", "result.x", record.worst->inputs, {1e-7, 12}}};
    Observation outside = *record.worst;
    outside.rule = "spec vulkan-1.3";
    outside.actual = {"0.2", "0x1.99999ap-3"};
    outside.allowed = {true, {"0.1", "0x1.99999ap-4"}, {"0.11", "0x1.c28f5cp-4"}, 12, {}};
    outside.budget = {"driver", false, PartSeen{1e-9, 0.25}, {0, 0}, {1e-7, 12}};
    record.worst_outside = outside;
    return record;
}

inline Record Without(Verdict verdict, const std::string& reason) {
    Record record = Passed();
    record.verdict = verdict;
    record.worst.reset();
    record.judged = 0;
    record.reason = reason;
    return record;
}

}  // namespace etalon
