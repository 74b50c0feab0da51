// The rows of the performance contract, on lavapipe. The program serves as its own worker.

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <iostream>
#include <thread>

#include "case/case.h"
#include "compile/compile.h"
#include "judge/judge.h"
#include "numeric/ulp.h"
#include "run/devices.h"
#include "run/fit.h"
#include "worker/serve.h"

namespace etalon {
namespace {

constexpr const char* kDevice = "vulkan:llvmpipe";

// Everything of one checked function of one float: device, oracle, judge.
struct Checked {
    std::unique_ptr<Runner> runner;
    Call call;
    Signature signature;
    Recipe recipe;
    Expression truth = Expression::Constant(0);
    Acceptance accept;
};

template <typename T>
T OrEnd(Result<T> result) {
    if (!result) {
        std::cerr << result.error().message << "\n";
        std::exit(2);
    }
    return std::move(*result);
}

Checked Open() {
    Checked checked;
    DeviceChoice choice;
    choice.patterns = {kDevice};
    checked.runner = std::move(OrEnd(OpenDevices(choice)).runners.front());
    checked.call.source = std::string(ETALON_ROOT) + "/shaders/optics/fresnel.glsl";
    checked.call.arguments = {{"cos_i", "float", true, false}};
    checked.call.wanted = {{"result", "fresnel_reflectance(1.0, 1.5, cos_i)", "CALL"}};
    checked.signature = OrEnd(Inspect(checked.call));
    checked.recipe = DefaultRecipe(checked.runner->info());
    checked.truth = OrEnd(Expression::Parse("fresnel.reflectance(1, 1.5, cos_i)"));
    const Symbol symbol{"cos_i", 1};
    OrEnd(checked.truth.Bind({&symbol, 1}));
    checked.accept.ulp = 16;
    return checked;
}

// Judges a part of a block: its truths in binary64, then the rule.
Summary JudgePart(const Checked& checked, std::span<const std::uint32_t> inputs,
                  std::span<const std::uint32_t> outputs) {
    Summary summary;
    constexpr std::size_t kBatch = 4096;
    std::vector<double> columns(kBatch);
    std::vector<float> values(kBatch);
    std::vector<double> truths;
    for (std::size_t at = 0; at < inputs.size(); at += kBatch) {
        const std::size_t count = std::min(kBatch, inputs.size() - at);
        for (std::size_t i = 0; i < count; ++i) {
            columns[i] = static_cast<double>(FromBits(inputs[at + i]));
            values[i] = FromBits(outputs[at + i]);
        }
        const double* column = columns.data();
        checked.truth.EvaluateFast({&column, 1}, count, truths);
        JudgeAll(checked.accept, std::span(values).first(count), truths,
                 checked.truth.relative_bound(), checked.truth.absolute_bound(), at, summary);
    }
    return summary;
}

// Every float of [0.25, 1), block after block: evaluated on the device, checked on all cores.
void CheckedValues(benchmark::State& state) {
    Checked checked = Open();
    const auto rows = static_cast<std::uint32_t>(state.range(0));
    std::vector<std::uint32_t> inputs(rows);
    std::uint32_t bits = ToBits(0.25f);
    std::uint64_t refused = 0;
    std::int64_t values = 0;
    const std::size_t parts = std::max(1u, std::thread::hardware_concurrency());
    for (auto _ : state) {
        for (std::uint32_t& input : inputs) {
            input = bits;
            bits = bits + 1 < ToBits(1.0f) ? bits + 1 : ToBits(0.25f);
        }
        const auto evaluated = checked.runner->Evaluate(
            checked.call, checked.signature, checked.recipe, {inputs, rows, 1},
            [&](std::uint64_t first, std::uint32_t count, std::span<const std::uint32_t> words) {
                std::vector<std::future<Summary>> judged;
                for (std::size_t part = 0; part < parts; ++part) {
                    const std::size_t from = count * part / parts;
                    const std::size_t to = count * (part + 1) / parts;
                    judged.push_back(std::async(std::launch::async, [&, from, to] {
                        return JudgePart(checked,
                                         std::span(inputs).subspan(first + from, to - from),
                                         words.subspan(from, to - from));
                    }));
                }
                for (std::future<Summary>& one : judged) {
                    refused += one.get().refused;
                }
            });
        if (!evaluated) {
            state.SkipWithError(evaluated.error().reason.c_str());
            return;
        }
        values += rows;
    }
    state.SetItemsProcessed(values);
    state.counters["refused"] = static_cast<double>(refused);
}
BENCHMARK(CheckedValues)
    ->Arg(1 << 18)
    ->Arg(1 << 20)
    ->Arg(1 << 22)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// The device's share of the above: no oracle, no judge.
void EvaluatedValues(benchmark::State& state) {
    Checked checked = Open();
    const auto rows = static_cast<std::uint32_t>(state.range(0));
    const std::vector<std::uint32_t> inputs(rows, ToBits(0.5f));
    for (auto _ : state) {
        benchmark::DoNotOptimize(checked.runner->Evaluate(
            checked.call, checked.signature, checked.recipe, {inputs, rows, 1},
            [](std::uint64_t, std::uint32_t, std::span<const std::uint32_t>) {}));
    }
    state.SetItemsProcessed(state.iterations() * rows);
}
BENCHMARK(EvaluatedValues)->Arg(1 << 20)->UseRealTime()->Unit(benchmark::kMillisecond);

void RunCommand(benchmark::State& state, const std::string& command) {
    for (auto _ : state) {
        if (std::system(command.c_str()) != 0) {
            state.SkipWithError("the command failed");
            return;
        }
    }
}

const std::string kProbe =
    std::string(ETALON_PROGRAM) + " probe " + ETALON_ROOT +
    "/shaders/optics/fresnel.glsl 'fresnel_reflectance(n1, n2, cos_i)' --device " + kDevice;

// From the shell to the answer: one call on lavapipe.
void ProbeOneCall(benchmark::State& state) {
    RunCommand(state, kProbe + " --at 'n1=1,n2=1.5,cos_i=0.5' > /dev/null");
}
BENCHMARK(ProbeOneCall)->UseRealTime()->Unit(benchmark::kMillisecond);

// A million rows of CSV in, a million out.
void ProbeMillionRows(benchmark::State& state) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / "etalon-benchmark-rows.csv";
    {
        std::ofstream rows(file);
        rows << "n1:float,n2:float,cos_i:float\n";
        for (int i = 0; i < 1'000'000; ++i) {
            rows << "1." << i % 997 << ",1." << i % 1009 << ",0." << i << "\n";
        }
    }
    RunCommand(state, kProbe + " --csv --inputs " + file.string() + " > /dev/null");
    std::filesystem::remove(file);
}
BENCHMARK(ProbeMillionRows)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace etalon

int main(int argc, char** argv) {
    if (argc > 1 && std::string_view(argv[1]) == "worker") {
        return etalon::ServeWorker(argc, argv);
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
