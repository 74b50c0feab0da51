// Lanes that part: loops of different lengths, nested switches, early returns, calls.
#include <gmock/gmock.h>

#include <map>

#include "evaluate/probed.h"
#include "spirv/grammar.h"
#include "spirv/read.h"

namespace etalon {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::uint32_t>;

constexpr std::uint32_t kRows = 500;

Words Counted() {
    Words words;
    for (std::uint32_t i = 0; i < kRows; ++i) {
        words.push_back(i * 2654435761u >> 7);
    }
    return words;
}

const char* const kRecipes[] = {"spirv", "spirv+O", "spirv+Os"};

// Runs the function under all recipes and compares it with the host's.
template <typename F>
void ExpectAsHost(const std::string& source, F host) {
    const Words x = Counted();
    for (const char* recipe : kRecipes) {
        const Probed probed(source, "f(x)", {"uint x"}, recipe);
        ASSERT_EQ(probed.error(), "") << recipe;
        const auto out = probed.Words<float>({x});
        ASSERT_TRUE(out.ok()) << recipe << ": " << out.error().message;
        for (std::uint32_t i = 0; i < kRows; ++i) {
            ASSERT_EQ((*out)[i], host(x[i])) << recipe << " of " << x[i];
        }
    }
}

TEST(Control, LoopsOfDifferentLengths) {
    ExpectAsHost(
        "uint f(uint x) { uint steps = 0u;\n"
        "  while (x != 1u && steps < 1000u) {\n"
        "    x = (x & 1u) == 0u ? x / 2u : (x & 0xffffffu) * 3u + 1u;\n"
        "    if (x > 0x1000000u) { break; }\n"
        "    if ((x & 7u) == 3u) { continue; }\n"
        "    ++steps; }\n"
        "  return steps * 65536u + (x & 0xffffu); }\n",
        [](std::uint32_t x) {
            std::uint32_t steps = 0;
            while (x != 1 && steps < 1000) {
                x = (x & 1) == 0 ? x / 2 : (x & 0xffffffu) * 3 + 1;
                if (x > 0x1000000u) {
                    break;
                }
                if ((x & 7) == 3) {
                    continue;
                }
                ++steps;
            }
            return steps * 65536u + (x & 0xffffu);
        });
}

TEST(Control, LoopsInLoopsWithReturns) {
    ExpectAsHost(
        "uint f(uint x) { uint sum = 0u;\n"
        "  for (uint i = 0u; i < (x & 15u); ++i) {\n"
        "    uint j = i;\n"
        "    do { sum += j * x; j += 3u; if (sum % 11u == 5u) { return sum; } }\n"
        "    while (j < (x >> 4 & 31u));\n"
        "    if (sum % 7u == 2u) { break; } }\n"
        "  return sum + 1u; }\n",
        [](std::uint32_t x) {
            std::uint32_t sum = 0;
            for (std::uint32_t i = 0; i < (x & 15); ++i) {
                std::uint32_t j = i;
                do {
                    sum += j * x;
                    j += 3;
                    if (sum % 11 == 5) {
                        return sum;
                    }
                } while (j < (x >> 4 & 31));
                if (sum % 7 == 2) {
                    break;
                }
            }
            return sum + 1;
        });
}

TEST(Control, SwitchesInSwitchesThatFallThrough) {
    ExpectAsHost(
        "uint f(uint x) { uint r = 1u;\n"
        "  switch (int(x & 7u) - 2) {\n"
        "    case -2: r += 5u; break;\n"
        "    case -1: r += 7u;\n"
        "    case 0: switch (x >> 3 & 3u) { case 0u: r *= 3u; break; case 2u: r *= 5u;\n"
        "              default: r += 11u; } break;\n"
        "    case 3: return 99u;\n"
        "    default: r = r * 13u + (x & 31u); }\n"
        "  return r; }\n",
        [](std::uint32_t x) -> std::uint32_t {
            std::uint32_t r = 1;
            switch (static_cast<int>(x & 7) - 2) {
                case -2:
                    r += 5;
                    break;
                case -1:
                    r += 7;
                    [[fallthrough]];
                case 0:
                    switch (x >> 3 & 3) {
                        case 0:
                            r *= 3;
                            break;
                        case 2:
                            r *= 5;
                            [[fallthrough]];
                        default:
                            r += 11;
                    }
                    break;
                case 3:
                    return 99;
                default:
                    r = r * 13 + (x & 31);
            }
            return r;
        });
}

TEST(Control, CallsWithOutParametersArraysAndGlobals) {
    ExpectAsHost(
        "uint seen = 3u;\n"
        "struct Pair { uint a; uvec2 b; };\n"
        "void turn(inout uint a[4], uint at, out Pair p) {\n"
        "  if (at > 2u) { p = Pair(7u, uvec2(a[0], at)); return; }\n"
        "  uint old = a[at]; a[at] = a[at + 1u]; a[at + 1u] = old; seen += old;\n"
        "  p.a = old; p.b = uvec2(at, a[3]); }\n"
        "uint f(uint x) { uint a[4] = uint[4](x & 3u, x >> 2 & 3u, x >> 4 & 3u, x >> 6 & 3u);\n"
        "  Pair p; uint sum = 0u;\n"
        "  for (uint i = 0u; i < 4u; ++i) { turn(a, a[i], p); sum = sum * 5u + p.a + p.b[i & 1u]; "
        "}\n"
        "  return sum * 64u + seen + a[x & 3u]; }\n",
        [](std::uint32_t x) {
            std::uint32_t seen = 3;
            std::uint32_t a[4] = {x & 3, x >> 2 & 3, x >> 4 & 3, x >> 6 & 3};
            std::uint32_t sum = 0;
            for (std::uint32_t i = 0; i < 4; ++i) {
                const std::uint32_t at = a[i];
                std::uint32_t pa = 7;
                std::uint32_t pb[2] = {a[0], at};
                if (at <= 2) {
                    const std::uint32_t old = a[at];
                    a[at] = a[at + 1];
                    a[at + 1] = old;
                    seen += old;
                    pa = old;
                    pb[0] = at;
                    pb[1] = a[3];
                }
                sum = sum * 5 + pa + pb[i & 1];
            }
            return sum * 64 + seen + a[x & 3];
        });
}

TEST(Control, TellsWhatItCannotDo) {
    EXPECT_THAT(
        Probed("uint f(uint x) { return x; }\n", "f(x)", {"uint x"}, "spirv+fragment").error(),
        HasSubstr("no compute shader"));
    EXPECT_THAT(
        Probed("double f(uint x) { return double(x); }\n", "float(f(x))", {"uint x"}).error(),
        HasSubstr("function 'f': 64-bit floats are not supported"));
    EXPECT_THAT(
        Probed("float f(uint x) { return float(double(x) * 0.5lf); }\n", "f(x)", {"uint x"})
            .error(),
        testing::MatchesRegex("SPIR-V word [0-9]+, in f: OpConvertUToF: .*64-bit floats.*"));
}

// glslang refuses it, so one function's call is turned to its caller.
TEST(Control, RefusesRecursion) {
    const Probed probed(
        "uint h(uint x) { return x + 1u; }\n"
        "uint g(uint x) { return h(x); }\n"
        "uint f(uint x) { return g(x); }\n",
        "f(x)", {"uint x"});
    ASSERT_EQ(probed.error(), "");
    std::vector<std::uint32_t> words = probed.program().spirv;
    std::map<std::string, std::uint32_t> called;  // by function: the word that says whom it calls
    std::map<std::string, std::uint32_t> ids;
    const Result<spirv::RawModule> raw = spirv::CutWords(words);
    ASSERT_TRUE(raw.ok());
    std::map<std::uint32_t, std::string> names;
    std::string function;
    for (const spirv::RawInstruction& at : raw->instructions) {
        if (at.op == spv::Op::OpName) {
            names[words[at.word + 1]] = spirv::StringAt(words, at.word + 2);
        } else if (at.op == spv::Op::OpFunction) {
            function = names[at.result];
            ids[function] = at.result;
        } else if (at.op == spv::Op::OpFunctionCall) {
            called[function] = at.word + 3;
        }
    }
    const auto refusal = [&](const std::string& caller, const std::string& other) {
        std::vector<std::uint32_t> turned = words;
        turned[called.at(caller)] = ids.at(other);
        Result<spirv::Module> module = spirv::ReadModule(turned);
        EXPECT_TRUE(module.ok()) << module.error().message;
        const auto plan = evaluate::MakePlan(std::move(*module));
        return plan.ok() ? "" : plan.error().message;
    };
    EXPECT_EQ(refusal("g(u1;", "h(u1;"), "");
    EXPECT_EQ(refusal("g(u1;", "g(u1;"),
              "recursion: the function 'g' calls itself, by itself or by others");
    EXPECT_THAT(refusal("g(u1;", "f(u1;"),
                testing::MatchesRegex("recursion: the function '[fg]' calls itself, by itself "
                                      "or by others"));
}

TEST(Control, EndsALoopWithoutEnd) {
    const Probed probed("uint f(uint x) { while (x != 3u) { x |= 4u; } return x; }\n", "f(x)",
                        {"uint x"});
    ASSERT_EQ(probed.error(), "");
    EXPECT_TRUE(probed.Words<float>({{3, 3}}).ok());
    evaluate::Limits limits;
    limits.steps = 100;
    const auto out = probed.Words<float>({{3, 2, 3}}, nullptr, limits);
    ASSERT_FALSE(out.ok());
    EXPECT_THAT(out.error().message,
                HasSubstr("row 1: in f: a loop does not end within 100 steps"));
}

TEST(Control, RefusesAnIndexOutOfRange) {
    const Probed probed("float f(int i) { float a[3] = float[3](1.0, 2.0, 3.0); return a[i]; }\n",
                        "f(i)", {"int i"});
    ASSERT_EQ(probed.error(), "");
    EXPECT_TRUE(probed.Words<float>({{0, 1, 2}}).ok());
    const auto out = probed.Words<float>({{0, 1, 0xffffffffu}});
    ASSERT_FALSE(out.ok());
    EXPECT_THAT(out.error().message, HasSubstr("row 2: in f: index -1 is outside of 3 elements"));
}

}  // namespace
}  // namespace etalon
