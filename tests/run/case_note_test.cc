#include "run/case_note.h"

#include <gmock/gmock.h>

#include "support/folder.h"

namespace etalon {
namespace {

using testing::ElementsAre;

class CaseNoteTest : public testing::Test {
  protected:
    CaseNoteTest() {
        folder_.Write("shaders/ray.glsl", R"(
// not_this(int x) { }
#include "deep/bend.glsl"
#define macro(x) { x }
struct Hit { vec2 uv; };
uniform sampler2D map;
float height(vec2 uv);
Hit
first_hit(vec2 from, /* of (this */ vec2 to)
{
    if (from.x > 0.0) { return Hit(bend(to)); }
    return Hit(to);
}
float second(float x) { return x; }
)");
        folder_.Write("shaders/deep/bend.glsl", "vec2 bend(vec2 v) { return v; }\n");
        folder_.Write("cases/scene.glsl",
                      "#include \"ray.glsl\"\nfloat height(vec2 uv) { return 0.0; }\n"
                      "float depth(vec2 v) { return second(first_hit(v, v).uv.x); }\n");
    }
    CaseNote Note(const std::string& text) {
        folder_.Write("cases/a/c.toml", text + "[domain]\nx = { values = [1.0] }\n");
        const auto read = ReadCase(folder_.path(), "a/c");
        EXPECT_TRUE(read) << read.error().message;
        return NoteOf(*read);
    }
    std::vector<std::string> Functions(const std::string& text) {
        std::vector<std::string> functions;
        for (const FunctionNote& function : Note(text).functions) {
            functions.push_back(function.file + " " + function.name);
        }
        return functions;
    }

    Folder folder_;
};

constexpr const char* kLaw = "[[law]]\nname = \"l\"\nholds = \"second(x) == bend(vec2(x)).x\"\n";

TEST_F(CaseNoteTest, NamesWhatTheCallNames) {
    const std::string oracle = "oracle = \"x + 1\"\naccept = { ulp = 1 }\n";
    EXPECT_THAT(Functions("source = \"shaders/ray.glsl\"\n"
                          "call = \"first_hit(vec2(x), vec2(sin(x))).uv.x\"\n" +
                          oracle),
                ElementsAre("shaders/ray.glsl first_hit"));
    EXPECT_THAT(Functions("source = \"shaders/ray.glsl\"\ncall = \"bend (vec2(x)).x\"\n" + oracle),
                ElementsAre("shaders/deep/bend.glsl bend"));
}

TEST_F(CaseNoteTest, NamesWhatASceneCalls) {
    EXPECT_THAT(Functions("source = \"shaders/ray.glsl\"\nwith = [\"cases/scene.glsl\"]\n"
                          "include = [\"shaders\"]\ncall = \"depth(vec2(x))\"\n"
                          "oracle = \"x\"\naccept = { ulp = 1 }\n"),
                ElementsAre("shaders/ray.glsl second", "shaders/ray.glsl first_hit"));
}

TEST_F(CaseNoteTest, NamesWhatLawsName) {
    const CaseNote note = Note(
        "source = \"shaders/ray.glsl\"\ncall = \"first_hit(vec2(x))\"\n"
        "covers = [\"F1\"]\n" +
        std::string(kLaw));
    EXPECT_EQ(note.path, "a/c");
    EXPECT_THAT(note.covers, ElementsAre("F1"));
    EXPECT_EQ(note.laws, 1u);
    EXPECT_TRUE(note.oracles.empty());
    ASSERT_EQ(note.functions.size(), 2u);
    EXPECT_EQ(note.functions[0].name, "second");
    EXPECT_EQ(note.functions[1].name, "bend");
}

}  // namespace
}  // namespace etalon
