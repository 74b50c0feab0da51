#include "run/programs.h"

#include <gmock/gmock.h>

#include <set>
#include <thread>

#include "support/folder.h"

namespace etalon {
namespace {

class ProgramsTest : public testing::Test {
  protected:
    ProgramsTest() {
        call_.source = folder_.Write("f.glsl", "float f(float x) { return x; }\n");
        call_.arguments = {{"x", "float", true, false}};
        call_.wanted = {{"result", "f(x)", "CALL"}};
        signature_ = *Inspect(call_);
    }
    const Programs::Compiled& Get(const std::string& recipe, Target target = {},
                                  const std::vector<std::vector<std::uint32_t>>& baked = {}) {
        return programs_.Get(call_, signature_, *ParseRecipe(recipe), target, baked);
    }

    Folder folder_;
    Call call_;
    Signature signature_;
    Programs programs_;
};

TEST_F(ProgramsTest, CompilesOnceForAllThreads) {
    std::vector<const Programs::Compiled*> seen(8);
    std::vector<std::thread> threads;
    for (auto& place : seen) {
        threads.emplace_back([&] { place = &Get("spirv"); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_EQ(programs_.size(), 1u);
    ASSERT_TRUE(*seen[0]);
    EXPECT_FALSE((*seen[0])->spirv.empty());
    EXPECT_THAT(seen, testing::Each(seen[0]));
}

TEST_F(ProgramsTest, TellsApartWhateverAProgramDependsOn) {
    const Target gl{Target::Client::kOpenGl, 450};
    const Target old{Target::Client::kOpenGl, 330};
    std::set<const Programs::Compiled*> seen = {&Get("spirv"),
                                                &Get("spirv+O"),
                                                &Get("spirv", gl),
                                                &Get("glsl", gl),
                                                &Get("glsl", old),
                                                &Get("spirv+baked", {}, {{1}, {2}}),
                                                &Get("spirv+baked", {}, {{1}, {3}})};
    EXPECT_EQ(seen.size(), 7u);
    call_.defines["K"] = "1";
    seen.insert(&Get("spirv"));
    call_.wanted[0].text = "f(x) + 1.0";
    seen.insert(&Get("spirv"));
    EXPECT_EQ(seen.size(), 9u);
}

TEST_F(ProgramsTest, KeepsAFailure) {
    folder_.Write("f.glsl", "float f(float x) { return x }\n");
    EXPECT_FALSE(Get("spirv"));
    EXPECT_FALSE(Get("spirv"));
    EXPECT_EQ(programs_.size(), 1u);
}

}  // namespace
}  // namespace etalon
