// Modules with words changed, cut and doubled at random: each is refused with a reason, or runs, or
// ends with one; by numbers of every kind and by intervals. ETALON_MUTATIONS=N asks for another
// number of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "evaluate/big.h"
#include "evaluate/bound.h"
#include "evaluate/probed.h"
#include "spirv/read.h"

namespace etalon {
namespace {

constexpr std::uint32_t kHeaderWords = 5;

std::vector<std::vector<std::uint32_t>> Modules() {
    const char* source =
        "uniform sampler2D height;\n"
        "struct Hit { vec3 at; int layer; };\n"
        "float kept = 2.0;\n"
        "float part(mat3 m, int i) { return m[i][1] * kept; }\n"
        "void find(inout Hit hit, float x) {\n"
        "  for (int i = 0; i < 6; ++i) {\n"
        "    if (hit.at.x > x) { hit.layer = i; break; }\n"
        "    hit.at += vec3(x, 0.5, part(mat3(x), i % 3)); kept = kept * 0.5; } }\n"
        "float f(float x, uint n) {\n"
        "  Hit hit = Hit(vec3(x, 1.0, 2.0), 3); find(hit, x);\n"
        "  float a[4] = float[4](x, 1.0, hit.at.y, 2.0); int e; float w = frexp(x, e);\n"
        "  switch (n & 3u) { case 0u: w += a[n & 3u]; case 1u: w *= 2.0; break;\n"
        "    case 2u: return textureLod(height, hit.at.xy, x).r; default: w -= length(hit.at); }\n"
        "  return w + a[hit.layer & 3] + float(e) + dot(inverse(mat2(x, 1.0, 2.0, w))[0], "
        "vec2(w)); }\n";
    BoundImage image;
    image.name = "height";
    image.image = std::make_shared<Image>(Image{2, 2, std::vector<float>(16, 0.25f)});
    std::vector<std::vector<std::uint32_t>> modules;
    for (const char* recipe : {"spirv", "spirv+O", "spirv+Os"}) {
        const Probed probed(source, "f(x, n)", {"float x", "uint n"}, recipe, {image});
        EXPECT_EQ(probed.error(), "") << recipe;
        modules.push_back(probed.program().spirv);
    }
    return modules;
}

constexpr std::uint32_t kRows = 4;

template <typename Number>
void RunAs(const std::shared_ptr<const evaluate::Plan>& plan,
           const std::vector<evaluate::Texture>& images, evaluate::Limits limits,
           const std::vector<std::uint32_t>& in) {
    evaluate::Evaluator<Number> evaluator(plan, images, limits);
    std::vector<std::uint32_t> out(kRows);
    if (const auto done = evaluator.Run({kRows, in, out}); !done) {
        EXPECT_FALSE(done.error().message.empty());
    }
}

// What became of a module; 0 refused by the reader, 1 by the translation, 2 run.
int Try(const std::vector<std::uint32_t>& words) {
    Result<spirv::Module> module = spirv::ReadModule(words);
    if (!module) {
        EXPECT_FALSE(module.error().message.empty());
        return 0;
    }
    auto plan = evaluate::MakePlan(std::move(*module));
    if (!plan) {
        EXPECT_FALSE(plan.error().message.empty());
        return 1;
    }
    const Image image{2, 2, std::vector<float>(16, 0.25f)};
    const std::vector<evaluate::Texture> images((*plan)->images,
                                                {std::make_shared<Image>(image), Sampling{}});
    evaluate::Limits limits;
    limits.steps = 200;
    const std::vector<std::uint32_t> in = {0x3f000000u, 0xbf800000u, 0x7fc00000u, 0,
                                           1,           2,           3,           0xffffffffu};
    RunAs<float>(*plan, images, limits, in);
    RunAs<double>(*plan, images, limits, in);
    RunAs<evaluate::Big>(*plan, images, limits, in);
    const auto bounds = evaluate::BoundOutputs(*plan, images, *evaluate::FindProfile("vulkan-1.3"),
                                               kRows, in, 1, limits);
    EXPECT_EQ(bounds.size(), kRows);
    return 2;
}

// The place of the instruction that holds the word, in a module that may be none.
std::size_t StartOf(const std::vector<std::uint32_t>& words, std::size_t at) {
    std::size_t start = kHeaderWords;
    while (start < at) {
        const std::size_t next = start + std::max<std::size_t>(words[start] >> 16, 1);
        if (next > at) {
            break;
        }
        start = next;
    }
    return start;
}

// An instruction takes the name of another one, or swaps its last operands: what often is right.
void TurnInstruction(std::vector<std::uint32_t>& words, std::size_t at, std::size_t other) {
    const std::size_t start = StartOf(words, at);
    const std::size_t length = words[start] >> 16;
    const std::size_t model = StartOf(words, other);
    if (words[model] >> 16 == length && model != start) {
        words[start] = words[model];
    } else if (length >= 3 && start + length <= words.size()) {
        std::swap(words[start + length - 1], words[start + length - 2]);
    }
}

TEST(Mutations, AreRefusedOrRun) {
    const std::vector<std::vector<std::uint32_t>> modules = Modules();
    const char* wanted = std::getenv("ETALON_MUTATIONS");
    const std::uint32_t count =
        wanted == nullptr ? 20000u : static_cast<std::uint32_t>(std::strtoul(wanted, nullptr, 10));
    std::array<std::uint32_t, 3> ends{};
    for (std::uint32_t seed = 0; seed < count; ++seed) {
        std::mt19937 random(seed);
        const auto below = [&](std::size_t end) {
            return static_cast<std::size_t>(random() % end);
        };
        std::vector<std::uint32_t> words = modules[below(modules.size())];
        const std::size_t changes = 1 + (below(4) == 0 ? below(3) : 0);
        for (std::size_t i = 0; i < changes && words.size() > kHeaderWords; ++i) {
            const std::size_t at = below(8) == 0
                                       ? below(words.size())
                                       : kHeaderWords + below(words.size() - kHeaderWords);
            const auto place = words.begin() + static_cast<std::ptrdiff_t>(at);
            switch (below(16)) {
                case 0:
                    *place = static_cast<std::uint32_t>(random());
                    break;
                case 1:
                    *place ^= 1u << below(32);
                    break;
                case 2:
                case 3:
                    *place = words[below(words.size())];
                    break;
                case 4:
                    *place += below(2) == 0 ? 1u : ~0u;
                    break;
                case 5:
                    words.erase(place);
                    break;
                case 6:
                    words.insert(place, words[below(words.size())]);
                    break;
                case 7:
                case 8:
                case 9:
                    TurnInstruction(words, at, below(words.size()));
                    break;
                default:
                    // Another id: the kind of change that gets furthest.
                    *place = static_cast<std::uint32_t>(below(words[3] == 0 ? 1 : words[3]));
                    break;
            }
        }
        if (below(20) == 0) {
            words.resize(below(words.size() + 1));
        }
        ++ends[static_cast<std::size_t>(Try(words))];
    }
    RecordProperty("run", static_cast<int>(ends[2]));
    std::printf("of %u modules %u were refused by the reader, %u by the translation, %u ran\n",
                count, ends[0], ends[1], ends[2]);
    EXPECT_GT(ends[0], 0u);
    EXPECT_GT(ends[2], 0u);
}

TEST(Mutations, EveryTruncationIsRefused) {
    for (const std::vector<std::uint32_t>& module : Modules()) {
        for (std::size_t size = 0; size < module.size(); ++size) {
            EXPECT_FALSE(spirv::ReadModule(std::span(module).first(size)).ok()) << size;
        }
    }
}

}  // namespace
}  // namespace etalon
