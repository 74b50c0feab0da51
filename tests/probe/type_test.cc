#include "probe/type.h"

#include <gmock/gmock.h>

#include "probe/types.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> Paths(const Type& type) {
    std::vector<std::string> paths;
    for (const Leaf& leaf : Leaves(type)) {
        paths.push_back(leaf.path + ":" + std::string(ScalarName(leaf.scalar)));
    }
    return paths;
}

TEST(BasicType, KnowsEveryNameAndGivesItBack) {
    for (const char* name : {"float", "int", "uint", "bool", "vec2", "vec3", "vec4", "ivec2",
                             "ivec4", "uvec3", "bvec4", "mat2x3", "mat4x2", "mat3x3"}) {
        const auto type = BasicType(name);
        ASSERT_TRUE(type) << name;
        EXPECT_EQ(TypeText(*type), name);
    }
    EXPECT_EQ(TypeText(*BasicType("mat3")), "mat3x3");
    EXPECT_EQ(*BasicType("mat4"), *BasicType("mat4x4"));
}

TEST(BasicType, RefusesTheRest) {
    for (const char* name :
         {"", "vec", "vec1", "vec5", "vec33", "Vec3", "dvec3", "double", "imat2", "mat", "mat5",
          "mat2x", "mat2x5", "mat2y3", "mat22", "void", "float[2]", "sampler2D", " float"}) {
        const auto type = BasicType(name);
        ASSERT_FALSE(type) << name;
        EXPECT_EQ(type.error().message,
                  "'" + std::string(name) + "' is not a scalar, vector or matrix type");
    }
}

TEST(Leaves, StandInTheOrderOfTheWords) {
    EXPECT_THAT(Paths(Type{}), IsEmpty());
    EXPECT_THAT(Paths(*BasicType("uint")), ElementsAre(":uint"));
    EXPECT_THAT(Paths(*BasicType("bvec2")), ElementsAre(".x:bool", ".y:bool"));
    EXPECT_THAT(Paths(*BasicType("vec4")),
                ElementsAre(".x:float", ".y:float", ".z:float", ".w:float"));
    // Column by column.
    EXPECT_THAT(Paths(*BasicType("mat2x3")),
                ElementsAre("[0].x:float", "[0].y:float", "[0].z:float", "[1].x:float",
                            "[1].y:float", "[1].z:float"));
    EXPECT_THAT(Paths(HitType()),
                ElementsAre(".position.x:float", ".position.y:float", ".position.z:float",
                            ".depth[0]:float", ".depth[1]:float", ".inside:bool"));
    EXPECT_THAT(Paths(ArrayOf(*BasicType("ivec2"), 2)),
                ElementsAre("[0].x:int", "[0].y:int", "[1].x:int", "[1].y:int"));
}

TEST(TypeText, PutsTheOutermostLengthFirst) {
    EXPECT_EQ(TypeText(Type{}), "void");
    EXPECT_EQ(TypeText(HitType()), "Hit");
    EXPECT_EQ(TypeText(ArrayOf(ArrayOf(*BasicType("vec2"), 3), 2)), "vec2[2][3]");
}

TEST(Type, IsEqualWhereAllOfItIs) {
    EXPECT_EQ(HitType(), HitType());
    Type other = HitType();
    other.members[1].type[0].length = 3;
    EXPECT_NE(HitType(), other);
    EXPECT_NE(*BasicType("vec3"), *BasicType("ivec3"));
}

}  // namespace
}  // namespace etalon
