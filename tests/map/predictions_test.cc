// Every map against its prediction: all cases that have a [map] with one, on Vulkan's llvmpipe.
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>

#include "case/case.h"
#include "map/map.h"

namespace etalon {
namespace {

constexpr const char* kDevice = "vulkan:llvmpipe";

bool HasDevice() {
    static const bool has = [] {
        DeviceChoice choice;
        choice.patterns = {kDevice};
        return OpenDevices(choice).ok();
    }();
    return has;
}

std::vector<std::string> PredictedCases(const std::filesystem::path& root) {
    std::vector<std::string> paths;
    const auto all = ListCases(root);
    if (!all) {
        return paths;
    }
    for (const std::string& path : *all) {
        const auto source = ReadCase(root, path);
        // One that cannot be read fails its test.
        if (!source || (source->map && (source->map->fails || source->map->safe))) {
            paths.push_back(path);
        }
    }
    return paths;
}

Result<MapRecord> Map(const std::filesystem::path& root, const std::string& path) {
    MapChoice choice;
    choice.root = root;
    choice.pattern = path;
    choice.devices.patterns = {kDevice};
    return MakeMap(choice);
}

TEST(PredictedCasesTest, AreFound) {
    EXPECT_FALSE(PredictedCases({}).empty());
}

class PredictionsTest : public testing::TestWithParam<std::string> {};

TEST_P(PredictionsTest, Holds) {
    if (!HasDevice()) {
        GTEST_SKIP() << "there is no " << kDevice << " here";
    }
    const auto map = Map({}, GetParam());
    ASSERT_TRUE(map) << map.error().message;
    ASSERT_TRUE(map->prediction);
    ASSERT_EQ(map->prediction->agreement.size(), 1u);
    EXPECT_TRUE(map->prediction->agreement[0].Holds()) << ContradictionText(*map);
    EXPECT_TRUE(map->Good());
}

std::string NameOf(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::replace_if(
        name.begin(), name.end(),
        [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Cases, PredictionsTest, testing::ValuesIn(PredictedCases({})), NameOf);

// Theory that is wrong is found out: on either side.
class WrongPredictionsTest : public testing::TestWithParam<const char*> {};

TEST_P(WrongPredictionsTest, IsFoundOut) {
    if (!HasDevice()) {
        GTEST_SKIP() << "there is no " << kDevice << " here";
    }
    const auto map = Map("tests/map/wrong", GetParam());
    ASSERT_TRUE(map) << map.error().message;
    EXPECT_TRUE(map->prediction->contradiction);
    EXPECT_FALSE(map->Good());
}

INSTANTIATE_TEST_SUITE_P(Wrong, WrongPredictionsTest, testing::Values("fails", "safe"));

}  // namespace
}  // namespace etalon
