#include "oracle/fresnel.h"

#include "interface.h"

namespace etalon::oracle {
namespace {

constexpr std::size_t kRows = 40000;

Interface At(const Row& row) {
    return {row[0], row[1], row[2]};
}

TEST(Fresnel, ReflectanceKeepsItsBound) {
    ExpectBound("fresnel.reflectance", RandomIncidence(kRows, 1),
                [](const Row& row) -> std::vector<Big> { return {At(row).Reflected()}; });
}

TEST(Fresnel, TransmittanceKeepsItsBound) {
    ExpectBound("fresnel.transmittance", RandomIncidence(kRows, 2),
                [](const Row& row) -> std::vector<Big> { return {At(row).Transmitted()}; });
}

TEST(Fresnel, PolarisedReflectanceKeepsItsBound) {
    ExpectBound("fresnel.reflectance_sp", RandomIncidence(kRows, 3),
                [](const Row& row) -> std::vector<Big> {
                    return {At(row).ReflectedS(), At(row).ReflectedP()};
                });
}

TEST(Fresnel, SchlickKeepsItsBound) {
    ExpectBound("fresnel.schlick", RandomIncidence(kRows, 4),
                [](const Row& row) -> std::vector<Big> {
                    const Interface at = At(row);
                    if (at.total) {
                        return {1};
                    }
                    const Big rest = Big(1) - (at.n2 < at.n1 ? at.cos_t : at.cos_i);
                    const Big amplitude = (at.n1 - at.n2) / (at.n1 + at.n2);
                    const Big normal = amplitude * amplitude;
                    return {normal + (Big(1) - normal) * rest * rest * rest * rest * rest};
                });
}

TEST(Fresnel, BrewsterCosineKeepsItsBound) {
    ExpectBound("fresnel.brewster_cosine", RandomIncidence(kRows, 5),
                [](const Row& row) -> std::vector<Big> {
                    const Interface at = At(row);
                    return {at.n1 / Sqrt(at.n1 * at.n1 + at.n2 * at.n2)};
                });
}

TEST(Fresnel, KnowsTheSpecialValues) {
    const Function& reflectance = *FindFunction("fresnel.reflectance");
    const double n1[] = {1, 1, 1.5, 1.5, 1.5, 2};
    const double n2[] = {1.5, 1.5, 1.5, 1.5, 1, 1};
    const double cos_i[] = {1, 0, 0, 0.5, 0.25, 0};
    const double expected[] = {0.04, 1, 0, 0, 1, 1};
    const double* inputs[] = {n1, n2, cos_i};
    double result[6];
    double* results[] = {result};
    reflectance.evaluate(inputs, results, 6);
    for (int k = 0; k < 6; ++k) {
        EXPECT_NEAR(result[k], expected[k], 1e-15) << k;
    }
}

// The method of the published shader loses all digits of a grazing transmittance. Were it the
// oracle, the bound would have to notice.
TEST(Fresnel, AnOracleThatCancelsIsNoticed) {
    Function wrong = *FindFunction("fresnel.transmittance");
    wrong.evaluate = [](const double* const* in, double* const* out, std::size_t rows) {
        for (std::size_t row = 0; row < rows; ++row) {
            const double n1 = in[0][row];
            const double n2 = in[1][row];
            const double c = in[2][row];
            const double square = 1 - (n1 / n2) * (n1 / n2) * (1 - c * c);
            const double cos_t = square < 0 ? 0 : std::sqrt(square);
            const double s = (n1 * c - n2 * cos_t) / (n1 * c + n2 * cos_t);
            const double p = (n1 * cos_t - n2 * c) / (n1 * cos_t + n2 * c);
            out[0][row] = square < 0 ? 0 : 1 - 0.5 * (s * s + p * p);
        }
    };
    const Worst worst =
        Compare(wrong, RandomIncidence(kRows, 2),
                [](const Row& row) -> std::vector<Big> { return {At(row).Transmitted()}; });
    EXPECT_GT(worst.used, 1000);
}

}  // namespace
}  // namespace etalon::oracle
