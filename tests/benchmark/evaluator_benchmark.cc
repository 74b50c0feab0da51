// The evaluator against the same function compiled for the host: fresnel_transmittance, 1e6 inputs,
// one core.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "benchmark/fresnel_host.h"
#include "compile/compile.h"
#include "evaluate/big.h"
#include "evaluate/bound.h"
#include "evaluate/evaluate.h"
#include "spirv/read.h"

namespace etalon {
namespace {

constexpr std::uint32_t kRows = 1'000'000;

struct Inputs {
    std::vector<std::uint32_t> words = std::vector<std::uint32_t>(3 * kRows);

    Inputs() {
        std::mt19937 random(1);
        std::uniform_real_distribution<float> index(1.0f, 2.5f);
        std::uniform_real_distribution<float> cosine(0.0f, 1.0f);
        for (std::uint32_t row = 0; row < kRows; ++row) {
            words[row] = std::bit_cast<std::uint32_t>(index(random));
            words[kRows + row] = std::bit_cast<std::uint32_t>(index(random));
            words[2 * kRows + row] = std::bit_cast<std::uint32_t>(cosine(random));
        }
    }
    float At(std::uint32_t column, std::uint32_t row) const {
        return std::bit_cast<float>(words[column * kRows + row]);
    }
};

const Inputs& SomeInputs() {
    static const Inputs inputs;
    return inputs;
}

void Host(benchmark::State& state) {
    const Inputs& inputs = SomeInputs();
    std::vector<float> out(kRows);
    for (auto _ : state) {
        for (std::uint32_t row = 0; row < kRows; ++row) {
            out[row] =
                FresnelTransmittance(inputs.At(0, row), inputs.At(1, row), inputs.At(2, row));
        }
        benchmark::DoNotOptimize(out.data());
    }
    state.SetItemsProcessed(state.iterations() * kRows);
}
BENCHMARK(Host)->Unit(benchmark::kMillisecond);

std::shared_ptr<const evaluate::Plan> PlanOf(const std::string& recipe) {
    Call call;
    call.source = std::string(ETALON_ROOT) + "/shaders/optics/fresnel.glsl";
    call.arguments = {{"n1", "float", true, false},
                      {"n2", "float", true, false},
                      {"cos_i", "float", true, false}};
    call.wanted = {{"result", "fresnel_transmittance(n1, n2, cos_i)", "CALL"}};
    const auto signature = Inspect(call);
    const auto program = Compile(call, *signature, *ParseRecipe(recipe), Target{}, {});
    auto module = spirv::ReadModule(program->spirv);
    return *evaluate::MakePlan(std::move(*module));
}

template <typename Number>
void Evaluate(benchmark::State& state, const std::string& recipe) {
    const Inputs& inputs = SomeInputs();
    evaluate::Evaluator<Number> evaluator(PlanOf(recipe), {});
    std::vector<std::uint32_t> out(kRows);
    for (auto _ : state) {
        if (!evaluator.Run({kRows, inputs.words, out, {}})) {
            std::fputs("the evaluator failed\n", stderr);
            std::exit(2);
        }
    }
    // The optimiser is free to change what the source says.
    if (sizeof(Number) == sizeof(float) && recipe == "spirv") {
        for (std::uint32_t row = 0; row < kRows; ++row) {
            const float host =
                FresnelTransmittance(inputs.At(0, row), inputs.At(1, row), inputs.At(2, row));
            if (std::bit_cast<std::uint32_t>(host) != out[row]) {
                std::fprintf(stderr, "row %u: the host has another result\n", row);
                std::exit(2);
            }
        }
    }
    state.SetItemsProcessed(state.iterations() * kRows);
}
void Bounds(benchmark::State& state, const std::string& recipe) {
    const Inputs& inputs = SomeInputs();
    const auto plan = PlanOf(recipe);
    const evaluate::Profile& profile = *evaluate::FindProfile("vulkan-1.3");
    std::size_t unbounded = 0;
    for (auto _ : state) {
        const auto bounds = evaluate::BoundOutputs(plan, {}, profile, kRows, inputs.words, 1);
        unbounded = static_cast<std::size_t>(
            std::count_if(bounds.begin(), bounds.end(), [](const evaluate::Bound& bound) {
                return bound.kind == evaluate::Bound::Kind::kUnbounded;
            }));
    }
    state.SetItemsProcessed(state.iterations() * kRows);
    state.counters["unbounded"] = static_cast<double>(unbounded);
}

constexpr auto& kBinary32 = Evaluate<float>;
constexpr auto& kBinary64 = Evaluate<double>;
constexpr auto& kBig = Evaluate<evaluate::Big>;
BENCHMARK_CAPTURE(kBinary32, plain, "spirv")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(kBinary32, optimised, "spirv+O")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(kBinary64, plain, "spirv")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(kBinary64, optimised, "spirv+O")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Bounds, plain, "spirv")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Bounds, optimised, "spirv+O")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(kBig, plain, "spirv")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace etalon

BENCHMARK_MAIN();
