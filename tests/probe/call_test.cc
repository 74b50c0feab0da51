#include "probe/call.h"

#include <gmock/gmock.h>

#include "probe/types.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> Names(const std::vector<ProbeColumn>& columns) {
    std::vector<std::string> names;
    for (const ProbeColumn& column : columns) {
        names.push_back(column.name + ":" + std::string(ScalarName(column.scalar)));
    }
    return names;
}

TEST(ProbeColumns, StandInTheOrderOfTheTable) {
    Call call;
    call.arguments = {
        {"v", "vec2", true, false}, {"state", "uint", true, true}, {"hit", "Hit", false, true}};
    call.wanted = {{"result", "f(v, state, hit)", "CALL"}};
    Signature signature;
    signature.arguments = {*BasicType("vec2"), *BasicType("uint"), HitType()};
    signature.wanted = {*BasicType("ivec2")};
    EXPECT_THAT(Names(InputColumns(call, signature)),
                ElementsAre("v.x:float", "v.y:float", "state:uint"));
    EXPECT_THAT(Names(OutputColumns(call, signature)),
                ElementsAre("result.x:int", "result.y:int", "state:uint", "hit.position.x:float",
                            "hit.position.y:float", "hit.position.z:float", "hit.depth[0]:float",
                            "hit.depth[1]:float", "hit.inside:bool"));
    EXPECT_EQ(signature.InputWords(call), 3u);
    EXPECT_EQ(signature.OutputWords(call), 9u);
}

TEST(ProbeColumns, AreNoneOfACallWithoutAResult) {
    Call call;
    call.wanted = {{"result", "f()", "CALL"}};
    Signature signature;
    signature.wanted = {Type{}};
    EXPECT_THAT(InputColumns(call, signature), IsEmpty());
    EXPECT_THAT(OutputColumns(call, signature), IsEmpty());
}

}  // namespace
}  // namespace etalon
