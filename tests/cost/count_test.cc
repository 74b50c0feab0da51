// Counts against programs that were counted by hand.
#include <gmock/gmock.h>

#include "cost/cost.h"
#include "cost/subject.h"

namespace etalon {

void PrintTo(const OperationCounts& counts, std::ostream* out) {
    *out << "arithmetic " << counts.arithmetic << ", division " << counts.division << ", special "
         << counts.special << ", comparison " << counts.comparison << ", integer " << counts.integer
         << ", fetch " << counts.fetch << ", other " << counts.other;
}

namespace {

using testing::HasSubstr;

class CountTest : public testing::Test {
  protected:
    Result<CountedCall> Try(const SubjectText& text) {
        return CountOperations(SubjectOf(folder_, "f" + std::to_string(files_++), text));
    }
    CountedCall Count(const SubjectText& text) {
        const auto counted = Try(text);
        EXPECT_TRUE(counted) << counted.error().message;
        return counted ? *counted : CountedCall{};
    }
    OperationCounts Mean(const std::string& source, const std::string& call) {
        return Count({source, call}).mean;
    }

    // A function over one vec3, (1, 2, 2), a second one and a float.
    OperationCounts OfVectors(const std::string& body) {
        SubjectText text{"float f(vec3 v, vec3 w, float s) { return " + body + "; }\n",
                         "f(v, w, s)"};
        text.arguments = {
            {"v", "vec3", true, false}, {"w", "vec3", true, false}, {"s", "float", true, false}};
        for (const float value : {1.0f, 2.0f, 2.0f, 0.5f, 0.25f, 4.0f, 0.5f}) {
            text.columns.push_back({std::bit_cast<std::uint32_t>(value)});
        }
        return Count(text).mean;
    }

    // A function of an int at these values.
    CountedCall OfInts(const std::string& source, std::vector<std::uint32_t> values) {
        SubjectText text{source, "f(n)"};
        text.arguments = {{"n", "int", true, false}};
        text.columns = {std::move(values)};
        return Count(text);
    }

    Folder folder_;
    int files_ = 0;
};

constexpr const char* kLoop =
    "float f(int n)\n{\n"
    "    float sum = 0.5;\n"
    "    for (int i = 0; i < n; ++i) {\n"
    "        sum = sqrt(sum * 3.0 + 1.0);\n"
    "    }\n"
    "    return sum;\n}\n";

TEST_F(CountTest, CountsByClass) {
    EXPECT_EQ(Mean("float f(float x) { return x * x + 2.0; }", "f(x)"),
              (OperationCounts{.arithmetic = 2}));
    EXPECT_EQ(Mean("float f(float x) { return x / (x + 2.0); }", "f(x)"),
              (OperationCounts{.arithmetic = 1, .division = 1}));
    EXPECT_EQ(Mean("float f(float x) { return sqrt(x) + exp2(x) + pow(x, 1.5) + sin(x); }", "f(x)"),
              (OperationCounts{.arithmetic = 3, .special = 4}));
    EXPECT_EQ(Mean("float f(float x) { return clamp(x, 0.1, 0.4) + max(x, 0.2); }", "f(x)"),
              (OperationCounts{.arithmetic = 1, .comparison = 3}));
    EXPECT_EQ(Mean("float f(float x) { return float(int(x) * 3 & 5); }", "f(x)"),
              (OperationCounts{.integer = 2, .other = 2}));
    EXPECT_EQ(Mean("float f(float x) { return smoothstep(0.1, 0.4, x); }", "f(x)"),
              (OperationCounts{.arithmetic = 6, .division = 1, .comparison = 2}));
}

TEST_F(CountTest, CountsEachComponent) {
    EXPECT_EQ(OfVectors("dot(v, w)"), (OperationCounts{.arithmetic = 5}));
    EXPECT_EQ(OfVectors("length(v)"), (OperationCounts{.arithmetic = 5, .special = 1}));
    EXPECT_EQ(OfVectors("distance(v, w)"), (OperationCounts{.arithmetic = 8, .special = 1}));
    // Of the vector all three components, of their sum two.
    const auto summed = [&](const std::string& vector) {
        return OfVectors("dot(" + vector + ", vec3(1.0, 2.0, 3.0))");
    };
    EXPECT_EQ(summed("v * w"), (OperationCounts{.arithmetic = 3 + 5}));
    EXPECT_EQ(summed("v * s"), (OperationCounts{.arithmetic = 3 + 5}));
    EXPECT_EQ(summed("v / w"), (OperationCounts{.arithmetic = 5, .division = 3}));
    EXPECT_EQ(summed("normalize(v)"), (OperationCounts{.arithmetic = 5 + 3 + 5, .special = 1}));
    EXPECT_EQ(summed("mix(v, w, s)"), (OperationCounts{.arithmetic = 12 + 5}));
    EXPECT_EQ(summed("cross(v, w)"), (OperationCounts{.arithmetic = 9 + 5}));
    EXPECT_EQ(summed("reflect(v, w)"), (OperationCounts{.arithmetic = 12 + 5}));
    EXPECT_EQ(summed("refract(v, w, s)"),
              (OperationCounts{.arithmetic = 5 + 5 + 2 + 9 + 5, .special = 1, .comparison = 1}));
    EXPECT_EQ(summed("mat3(v, w, v) * w"), (OperationCounts{.arithmetic = 15 + 5}));
}

TEST_F(CountTest, CountsLoopsByRow) {
    const CountedCall counted = OfInts(kLoop, {0, 10, 1});
    // For each turn a product, a sum, a root, a comparison and a step of i; and the last
    // comparison.
    EXPECT_EQ(counted.worst,
              (OperationCounts{.arithmetic = 20, .special = 10, .comparison = 11, .integer = 10}));
    EXPECT_EQ(counted.worst_row, 1u);
    EXPECT_EQ(counted.mean.special, 11.0 / 3);
    EXPECT_EQ(counted.mean.comparison, (1 + 11 + 2) / 3.0);
}

TEST_F(CountTest, CountsOnlyTheWayTaken) {
    const std::string source =
        "float f(int n)\n{\n"
        "    float sum = 1.0;\n"
        "    if (n > 2) {\n"
        "        for (int i = 0; i < 4; ++i) {\n            sum = exp(sum);\n        }\n"
        "    }\n"
        "    return sum;\n}\n";
    const CountedCall counted = OfInts(source, {1, 2, 3, 2});
    EXPECT_EQ(counted.worst_row, 2u);
    EXPECT_EQ(counted.worst.special, 4);
    EXPECT_EQ(counted.mean.special, 1);
}

TEST_F(CountTest, CountsFetches) {
    const auto image = std::make_shared<Image>(Image{1, 2, {0, 1, 2, 3, 4, 5, 6, 7}});
    SubjectText text{
        "uniform sampler2D height;\n"
        "float f(int n)\n{\n"
        "    float sum = 0.0;\n"
        "    for (int i = 0; i < n; ++i) {\n"
        "        sum += textureLod(height, vec2(0.5, sum), 0.0).x;\n"
        "    }\n"
        "    return sum + texelFetch(height, ivec2(0, n & 1), 0).y;\n}\n",
        "f(n)"};
    text.arguments = {{"n", "int", true, false}};
    text.columns = {{3, 0}};
    text.images = {{"height", image}};
    const CountedCall counted = Count(text);
    EXPECT_EQ(counted.worst.fetch, 4);
    EXPECT_EQ(counted.mean.fetch, 2.5);
    EXPECT_EQ(counted.worst,
              (OperationCounts{.arithmetic = 4, .comparison = 4, .integer = 4, .fetch = 4}));
}

TEST_F(CountTest, LeavesOutWhatNothingDependsOn) {
    const std::string source =
        "struct Hit { float way; float extra; };\n"
        "Hit f(float x) { return Hit(x * 2.0, exp(x) * sin(x)); }\n";
    EXPECT_EQ(Mean(source, "f(x).way"), (OperationCounts{.arithmetic = 1}));
    // The structure as a whole is wanted: both.
    EXPECT_EQ(Mean(source, "f(x)"), (OperationCounts{.arithmetic = 2, .special = 2}));
    // Computed once.
    EXPECT_EQ(Mean("float f(float x) { return sqrt(x) * sqrt(x); }", "f(x)"),
              (OperationCounts{.arithmetic = 1, .special = 1}));
}

TEST_F(CountTest, CountsWhateverTheTypesOfTheResults) {
    EXPECT_EQ(Mean("bool f(float x) { return x > 0.3; }", "f(x)"),
              (OperationCounts{.comparison = 1}));
    EXPECT_EQ(Mean("int f(float x) { return int(x * 9.0); }", "f(x)"),
              (OperationCounts{.arithmetic = 1, .other = 1}));
    EXPECT_EQ(OfInts("int f(int n) { return n * 3; }", {4}).mean, (OperationCounts{.integer = 1}));
    SubjectText text{"void f(float x, out float y, out vec2 z) { y = x + 1.0; z = vec2(x) * y; }",
                     "f(x, y, z)"};
    text.arguments.push_back({"y", "float", false, true});
    text.arguments.push_back({"z", "vec2", false, true});
    EXPECT_EQ(Count(text).mean.arithmetic, 3);
    EXPECT_EQ(Mean("float f(float x) { return x; }", "f(x)"), OperationCounts{});
    EXPECT_EQ(Mean("float f(float x) { return 0.0; }", "f(x)"), OperationCounts{});
}

TEST_F(CountTest, TellsProgramsApart) {
    const std::string more =
        std::string(kLoop).replace(std::string(kLoop).find("+ 1.0"), 5, "+ 1.0 - sum");
    EXPECT_EQ(OfInts(more, {10}).mean.arithmetic, OfInts(kLoop, {10}).mean.arithmetic + 10);
    EXPECT_NE(OfInts(kLoop, {10}).mean, OfInts(kLoop, {11}).mean);
}

TEST_F(CountTest, IsTheSameForManyRows) {
    std::vector<std::uint32_t> values;
    double sum = 0;
    for (std::uint32_t i = 0; i < 40'000; ++i) {
        values.push_back(i * 7 % 13);
        sum += values.back();
    }
    const CountedCall counted = OfInts(kLoop, values);
    EXPECT_EQ(counted.mean.special, sum / 40'000);
    EXPECT_EQ(counted.worst.special, 12);
    EXPECT_EQ(values[counted.worst_row], 12u);
    EXPECT_EQ(counted.worst_row, 11u) << "the first of them: 11 * 7 = 5 * 13 + 12";
}

TEST_F(CountTest, SaysWhyNot) {
    const auto counted = Try({"float f(float x) { return dFdx(x); }", "f(x)"});
    ASSERT_FALSE(counted);
    EXPECT_THAT(counted.error().message, HasSubstr("derivatives"));
    const auto endless =
        Try({"float f(float x) { while (x > -1.0) { x += 1.0; } return x; }", "f(x)"});
    ASSERT_FALSE(endless);
    EXPECT_THAT(endless.error().message, HasSubstr("does not end"));
}

}  // namespace
}  // namespace etalon
