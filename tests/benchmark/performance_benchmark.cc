// The rows of the performance contract, on lavapipe. The program serves as its own worker.

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <thread>

#include "case/case.h"
#include "compile/compile.h"
#include "numeric/ulp.h"
#include "run/devices.h"
#include "run/fit.h"
#include "run/sweep_check.h"
#include "worker/serve.h"

namespace etalon {
namespace {

constexpr const char* kDevice = "vulkan:llvmpipe";

// Everything of one checked function of one float: device, and what a sweep of it is.
struct Checked {
    std::unique_ptr<Runner> runner;
    Recipe recipe;
    SweepPlan plan;
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
    checked.recipe = DefaultRecipe(checked.runner->info());
    SweepPlan& plan = checked.plan;
    plan.call.source = std::string(ETALON_ROOT) + "/shaders/optics/fresnel.glsl";
    plan.call.arguments = {{"cos_i", "float", true, false}};
    plan.call.wanted = {{"result", "fresnel_reflectance(1.0, 1.5, cos_i)", "CALL"}};
    plan.signature = OrEnd(Inspect(plan.call));
    plan.settings.variables = {{"cos_i", "float"}};
    plan.settings.columns = {{"cos_i"}};
    plan.settings.words = {ToBits(0.25f)};
    plan.settings.rows = 1;
    SweepPlan::Oracle oracle;
    oracle.expression = OrEnd(Expression::Parse("fresnel.reflectance(1, 1.5, cos_i)"));
    OrEnd(oracle.expression.Bind(Symbols(plan.settings.variables)));
    JudgedColumn result;
    result.name = "result";
    result.accept.ulp = 16;
    oracle.outputs = {result};
    plan.oracles.push_back(std::move(oracle));
    return checked;
}

// Every float of [0.25, 1), block after block: evaluated on the device, checked on all cores as a
// sweep's are.
void CheckedValues(benchmark::State& state) {
    Checked checked = Open();
    const auto rows = static_cast<std::uint32_t>(state.range(0));
    const unsigned threads = std::max(1u, std::thread::hardware_concurrency());
    const std::int64_t begin = OrderedBits(0.25f);
    const std::int64_t end = OrderedBits(1.0f);
    std::int64_t first_float = begin;
    std::vector<std::uint32_t> inputs(rows);
    std::uint64_t refused = 0;
    std::int64_t values = 0;
    for (auto _ : state) {
        if (first_float + rows > end) {
            first_float = begin;
        }
        FillFloats(first_float, inputs);
        const auto evaluated = checked.runner->Evaluate(
            checked.plan.call, checked.plan.signature, checked.recipe, {inputs, rows, 1},
            [&](std::uint64_t first, std::uint32_t count, std::span<const std::uint32_t> words) {
                SweepBlock block;
                block.first_row = first;
                block.first_float = first_float + static_cast<std::int64_t>(first);
                block.rows = count;
                for (const SweptColumn& column : CheckBlock(checked.plan, block, words, threads)) {
                    refused += column.summary.refused;
                }
            });
        if (!evaluated) {
            state.SkipWithError(evaluated.error().reason.c_str());
            return;
        }
        first_float += rows;
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
            checked.plan.call, checked.plan.signature, checked.recipe, {inputs, rows, 1},
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
