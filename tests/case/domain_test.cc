#include "case/domain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "numeric/sampling.h"
#include "numeric/ulp.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Input Values(const std::string& name, const std::vector<double>& values,
             const std::string& type = "float") {
    Input input;
    input.name = name;
    input.type = type;
    for (const double value : values) {
        input.values.push_back({value});
    }
    input.line = 7;
    return input;
}

Input Range(const std::string& name, double low, double high, std::uint64_t count,
            const std::string& sample = "") {
    Input input;
    input.name = name;
    input.range = std::pair(low, high);
    input.count = count;
    input.sample = sample;
    input.line = 8;
    return input;
}

Input Computed(const std::string& name, const std::string& text,
               const std::string& type = "float") {
    Input input;
    input.name = name;
    input.type = type;
    input.expr = *Expression::Parse(text);
    input.line = 9;
    return input;
}

Input Direction(const std::string& name, std::uint64_t count, const std::string& against = "") {
    Input input;
    input.name = name;
    input.type = "vec3";
    input.sample = against.empty() ? "sphere" : "hemisphere";
    input.against = against;
    input.count = count;
    return input;
}

Domain Of(std::vector<Input> inputs, bool zip = false, const std::string& where = "") {
    Domain domain;
    domain.inputs = std::move(inputs);
    domain.zip = zip;
    domain.file = "cases/x.toml";
    domain.line = 5;
    if (!where.empty()) {
        domain.where = *Expression::Parse(where);
    }
    return domain;
}

Table Expanded(const std::vector<Domain>& domains, std::uint64_t seed = 1) {
    auto table = Expand(domains, seed);
    EXPECT_TRUE(table) << table.error().message;
    return table ? *table : Table{};
}

std::string Complaint(const std::vector<Domain>& domains) {
    const auto table = Expand(domains, 1);
    return table ? "" : table.error().message;
}

std::vector<double> Column(const Table& table, std::size_t column) {
    return Numbers(table, 0, table.rows)[column];
}

TEST(ColumnsOf, NamesComponents) {
    const auto names = [](const std::string& type) {
        std::vector<std::string> result;
        const auto columns = ColumnsOf("m", type);
        for (const etalon::Column& column : columns.value()) {
            result.push_back(column.name);
        }
        return result;
    };
    EXPECT_THAT(names("float"), ElementsAre("m"));
    EXPECT_THAT(names("ivec2"), ElementsAre("m.x", "m.y"));
    EXPECT_THAT(names("mat2"), ElementsAre("m[0].x", "m[0].y", "m[1].x", "m[1].y"));
    EXPECT_THAT(names("mat2x3"),
                ElementsAre("m[0].x", "m[0].y", "m[0].z", "m[1].x", "m[1].y", "m[1].z"));
    const auto bools = ColumnsOf("b", "bvec3");
    EXPECT_EQ(bools.value()[2].scalar, Scalar::kBool);
    for (const char* type : {"double", "vec5", "sampler2D", "mat2x", "mat5", "vec", "", "vec23"}) {
        EXPECT_FALSE(ColumnsOf("m", type)) << type;
    }
}

TEST(Expand, NestsTheLoopsInOrder) {
    const Table table = Expanded({Of({Values("a", {1, 2}), Values("b", {3, 4, 5})})});
    EXPECT_EQ(table.rows, 6u);
    EXPECT_THAT(Column(table, 0), ElementsAre(1, 1, 1, 2, 2, 2));
    EXPECT_THAT(Column(table, 1), ElementsAre(3, 4, 5, 3, 4, 5));
    EXPECT_EQ(table.variables[1].name, "b");
    EXPECT_EQ(table.variables[1].first_column, 1u);
}

TEST(Expand, PutsValuesSideBySide) {
    const Table table =
        Expanded({Of({Values("a", {1, 2, 3}), Values("b", {4, 5, 6}), Values("c", {7})}, true)});
    EXPECT_THAT(Column(table, 0), ElementsAre(1, 2, 3));
    EXPECT_THAT(Column(table, 1), ElementsAre(4, 5, 6));
    EXPECT_THAT(Column(table, 2), ElementsAre(7, 7, 7));
    EXPECT_EQ(Complaint({Of({Values("a", {1, 2, 3}), Values("b", {4, 5})}, true)}),
              "cases/x.toml:7: input 'b': 2 values stand beside 3 of 'a'");
}

TEST(Expand, DrawsExactlyTheCountSideBySide) {
    const Table table =
        Expanded({Of({Range("a", 0, 1, 100), Range("b", -1, 1, 100), Direction("v", 100)}, true)});
    EXPECT_EQ(table.rows, 100u);
    const auto a = Column(table, 0);
    const auto b = Column(table, 1);
    EXPECT_EQ(std::count(a.begin(), a.end(), 1.0), 1);
    EXPECT_FALSE(std::is_sorted(a.begin(), a.end()));
    double product = 0;  // of signs about the medians: none where the two are independent
    for (std::size_t k = 0; k < 100; ++k) {
        product += (a[k] > 1e-19 ? 1 : -1) * (b[k] > 0 ? 1 : -1);
    }
    EXPECT_LT(std::fabs(product), 35);
}

TEST(Expand, AddsTheLandmarksOfARange) {
    const float small = std::numeric_limits<float>::denorm_min();
    const float normal = std::numeric_limits<float>::min();
    const float below = std::nextafter(normal, 0.0f);
    const float one_down = std::nextafter(1.0f, 0.0f);
    auto bits = Range("a", 0, 1, 1);
    const auto values = Column(Expanded({Of({bits})}), 0);
    ASSERT_EQ(values.size(), 7u);
    for (const double landmark :
         {0.0, double{small}, double{below}, double{normal}, double{one_down}, 1.0}) {
        EXPECT_THAT(values, testing::Contains(landmark));
    }
    EXPECT_FALSE(std::signbit(values[0]));
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
    const auto linear = Column(Expanded({Of({Range("a", 2, 3, 2, "linear")})}), 0);
    ASSERT_EQ(linear.size(), 4u);
    EXPECT_EQ(linear[0], 2);
    EXPECT_EQ(linear[3], 3);
    EXPECT_TRUE(linear[1] >= 2 && linear[1] <= 2.5 && linear[2] >= 2.5 && linear[2] <= 3);
}

TEST(Expand, IsDecidedByTheSeed) {
    const std::vector<Domain> domains = {
        Of({Range("a", 0, 1, 50), Direction("v", 5), Direction("n", 3, "v")})};
    EXPECT_EQ(Expanded(domains, 3).words, Expanded(domains, 3).words);
    EXPECT_NE(Expanded(domains, 3).words, Expanded(domains, 4).words);
}

TEST(Expand, SurroundsEdgesInEveryCombination) {
    Input edged = Range("c", 0, 1, 0);
    edged.edges = {*Expression::Parse("a / b"), *Expression::Parse("sqrt(-a)")};
    // Named before the inputs that its edges depend on: it is resolved after them.
    const Table table = Expanded({Of({edged, Values("a", {1, 3}), Values("b", {2})})});
    const auto edge_rows = [&](double a) {
        std::vector<float> rows;
        for (std::uint64_t row = 0; row < table.rows; ++row) {
            const float c = FromBits(table.At(row, 0));
            if (FromBits(table.At(row, 1)) == a && std::fabs(c - 0.5f) < 0.1f) {
                rows.push_back(c);
            }
        }
        return rows;
    };
    const float down = std::nextafter(0.5f, 0.0f);
    const float up = std::nextafter(0.5f, 1.0f);
    EXPECT_THAT(edge_rows(1),
                ElementsAre(std::nextafter(down, 0.0f), down, 0.5f, up, std::nextafter(up, 1.0f)));
    EXPECT_THAT(edge_rows(3), ElementsAre()) << "1.5 lies outside the range";
}

TEST(Expand, ComputesAndRounds) {
    const Table table =
        Expanded({Of({Computed("n2", "n1 * (1 + 2^-22)"), Values("n1", {1.5}),
                      Computed("k", "n1 + 1", "int"), Computed("v", "vec2(n2, n1)", "vec2")})});
    EXPECT_EQ(table.At(0, 0), ToBits(1.5f * (1 + 0x1p-22f)));
    EXPECT_EQ(Column(table, 2)[0], 2);  // 2.5 to even
    EXPECT_THAT(table.At(0, 3), table.At(0, 0));
    EXPECT_THAT(Complaint({Of({Values("a", {1e10}), Computed("k", "a", "int")})}),
                HasSubstr("is not an int"));
}

TEST(Expand, FiltersRows) {
    const Table table = Expanded(
        {Of({Values("a", {1, 2, 3}), Values("b", {1, 2, 3})}, false, "a < b && a + b != 4")});
    EXPECT_THAT(Column(table, 0), ElementsAre(1, 2));
    EXPECT_THAT(Column(table, 1), ElementsAre(2, 3));
    EXPECT_EQ(Complaint({Of({Values("a", {1})}, false, "a > 1")}),
              "cases/x.toml:5: the domain is empty: 'where' refuses every row");
    EXPECT_THAT(Complaint({Of({Values("a", {1})}, false, "a > zz")}), HasSubstr("'where'"));
}

TEST(Expand, OpposesHemispheres) {
    const Table table = Expanded({Of({Direction("v", 10), Direction("n", 4, "v")})});
    EXPECT_EQ(table.rows, 16u * 8u);
    bool normal_incidence = false;
    for (std::uint64_t row = 0; row < table.rows; ++row) {
        const auto numbers = Numbers(table, row, 1);
        double dot = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            dot += numbers[c][0] * numbers[3 + c][0];
        }
        EXPECT_LE(dot, 1e-17);
        normal_incidence = normal_incidence || dot < -0.999999;
    }
    EXPECT_TRUE(normal_incidence);
    std::set<std::vector<double>> axes;
    for (std::uint64_t row = 0; row < table.rows; ++row) {
        const auto n = Numbers(table, row, 1);
        if (std::fabs(n[0][0]) + std::fabs(n[1][0]) + std::fabs(n[2][0]) == 1) {
            axes.insert({n[0][0], n[1][0], n[2][0]});
        }
    }
    EXPECT_EQ(axes.size(), 6u);
}

TEST(Expand, TakesIntegersAndBools) {
    EXPECT_THAT(Column(Expanded({Of({Values("k", {-1, 5}, "int")})}), 0), ElementsAre(-1, 5));
    EXPECT_THAT(Column(Expanded({Of({Values("b", {0, 1}, "bool")})}), 0), ElementsAre(0, 1));
    Input range = Range("k", -2, 2, 100);
    range.type = "int";
    EXPECT_THAT(Column(Expanded({Of({range})}), 0), ElementsAre(-2, -1, 0, 1, 2));
    range.range = std::pair(0.0, 4294967295.0);
    range.type = "uint";
    range.count = 10;
    const auto many = Column(Expanded({Of({range})}), 0);
    EXPECT_EQ(many.size(), 10u);
    EXPECT_EQ(many.front(), 0);
    EXPECT_EQ(many.back(), 4294967295.0);
    EXPECT_EQ(Complaint({Of({Values("k", {1.5}, "int")})}),
              "cases/x.toml:7: input 'k': 1.5 is not an int");
    EXPECT_EQ(Complaint({Of({Values("k", {1e39})})}),
              "cases/x.toml:7: input 'k': 1e+39 does not fit a float");
}

TEST(Expand, DrawsMatricesByComponent) {
    Input matrix = Range("m", -1, 1, 100);
    matrix.type = "mat3";
    const Table table = Expanded({Of({matrix})});
    EXPECT_EQ(table.rows, 100u);
    EXPECT_EQ(table.columns.size(), 9u);
    EXPECT_NE(Column(table, 0), Column(table, 1));
    for (const double value : Column(table, 4)) {
        EXPECT_LE(std::fabs(value), 1);
    }
}

TEST(Expand, TakesAnyBits) {
    Input any;
    any.name = "v";
    any.type = "vec3";
    any.sample = "any";
    any.count = 6;
    const Table product = Expanded({Of({any, Values("b", {1, 2})})});
    EXPECT_EQ(product.rows, 2u * (14 + 6));
    EXPECT_EQ(product.At(2 * 12, 0), 0x7f800001u) << "a signalling NaN keeps its bits";
    any.count = 50;
    Input other = any;
    other.name = "w";
    const Table zipped = Expanded({Of({any, other}, true)});
    EXPECT_EQ(zipped.rows, 50u);
    EXPECT_NE(zipped.words, Expanded({Of({any, other}, true)}, 2).words);
    int same = 0;
    for (std::uint64_t row = 0; row < zipped.rows; ++row) {
        same += zipped.At(row, 0) == zipped.At(row, 3) ? 1 : 0;
    }
    EXPECT_LT(same, 10);
}

TEST(Expand, JoinsDomains) {
    const Table table = Expanded(
        {Of({Values("a", {1, 2}), Values("b", {3})}), Of({Values("b", {4}), Values("a", {5})})});
    EXPECT_THAT(Column(table, 0), ElementsAre(1, 2, 5));
    EXPECT_THAT(Column(table, 1), ElementsAre(3, 3, 4));
    EXPECT_EQ(Complaint({Of({Values("a", {1})}), Of({Values("b", {1})})}),
              "cases/x.toml:5: this domain has not the same inputs as the first");
    EXPECT_NE(Complaint({Of({Values("a", {1})}), Of({Values("a", {1}, "int")})}), "");
}

TEST(Expand, RefusesWhatCannotBe) {
    EXPECT_EQ(Complaint({Of({Computed("a", "b + 1"), Computed("b", "a")})}),
              "cases/x.toml:9: input 'a': depends on itself by way of 'b'");
    EXPECT_EQ(Complaint({Of({Computed("a", "a + 1")})}),
              "cases/x.toml:9: input 'a': depends on itself");
    EXPECT_EQ(Complaint({Of({Computed("a", "zz")})}),
              "cases/x.toml:9: input 'a': 'zz' is no input");
    EXPECT_EQ(Complaint({Of({Range("a", 1, 0, 5)})}),
              "cases/x.toml:8: input 'a': the range [1, 0] is empty");
    EXPECT_THAT(Complaint({Of({Range("a", 0, 1, 5, "log")})}), HasSubstr("must not hold zero"));
    EXPECT_THAT(Complaint({Of({Range("a", 0, 1e40, 5)})}), HasSubstr("does not fit"));
    EXPECT_THAT(Complaint({Of({Range("a", 0, INFINITY, 5, "linear")})}), HasSubstr("does not fit"));
    EXPECT_EQ(Complaint({Of({Range("a", -INFINITY, INFINITY, 5)})}), "");
    EXPECT_THAT(Complaint({Of({Range("a", 0, std::nan(""), 5)})}), HasSubstr("is empty"));
    EXPECT_THAT(Complaint({Of({Range("a", 0, 1, 5000), Range("b", 0, 1, 5000)})}),
                HasSubstr("more than 2^24 rows"));
    Input edged = Range("a", 0, 1, 5);
    edged.edges = {*Expression::Parse("0.5")};
    EXPECT_THAT(Complaint({Of({edged}, true)}), HasSubstr("edges need every combination"));
    EXPECT_THAT(Complaint({Of({Values("a", {})})}), HasSubstr("the domain is empty"));
    EXPECT_THAT(Complaint({Of({Values("a", {1}), Computed("v", "a", "vec2")})}),
                HasSubstr("1 components, not 2"));
}

}  // namespace
}  // namespace etalon
