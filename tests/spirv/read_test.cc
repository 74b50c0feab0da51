#include "spirv/read.h"

#include <gmock/gmock.h>

namespace etalon::spirv {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Words = std::vector<std::uint32_t>;

// Writes modules word by word.
class Writer {
  public:
    Writer& Add(spv::Op op, const Words& operands) {
        words_.push_back(static_cast<std::uint32_t>(operands.size() + 1) << 16 |
                         static_cast<std::uint32_t>(op));
        words_.insert(words_.end(), operands.begin(), operands.end());
        return *this;
    }
    const Words& words() const { return words_; }

  private:
    Words words_ = {spv::MagicNumber, 0x00010300, 0, 100, 0};
};

constexpr std::uint32_t kMain = 0x6e69616d;  // "main"

enum : std::uint32_t { kVoid = 1, kSignature, kFloat, kVector, kOne, kEntry, kLabel, kSum, kMore };

Writer Begun() {
    Writer writer;
    writer.Add(spv::Op::OpCapability, {1})
        .Add(spv::Op::OpMemoryModel, {0, 1})
        .Add(spv::Op::OpEntryPoint, {5, kEntry, kMain, 0})
        .Add(spv::Op::OpName, {kSum, kMain, 0})
        .Add(spv::Op::OpDecorate,
             {kSum, static_cast<std::uint32_t>(spv::Decoration::NoContraction)})
        .Add(spv::Op::OpTypeVoid, {kVoid})
        .Add(spv::Op::OpTypeFunction, {kSignature, kVoid})
        .Add(spv::Op::OpTypeFloat, {kFloat, 32})
        .Add(spv::Op::OpTypeVector, {kVector, kFloat, 2})
        .Add(spv::Op::OpConstant, {kFloat, kOne, 0x3f800000})
        .Add(spv::Op::OpFunction, {kVoid, kEntry, 0, kSignature})
        .Add(spv::Op::OpLabel, {kLabel});
    return writer;
}
Words Ended(Writer writer) {
    return writer.Add(spv::Op::OpReturn, {}).Add(spv::Op::OpFunctionEnd, {}).words();
}
std::string Reason(const Words& words) {
    const Result<Module> module = ReadModule(words);
    return module.ok() ? "" : module.error().message;
}

TEST(ReadModule, ReadsWhatItIsGiven) {
    const Result<Module> module =
        ReadModule(Ended(Begun().Add(spv::Op::OpFAdd, {kFloat, kSum, kOne, kOne})));
    ASSERT_TRUE(module.ok()) << module.error().message;
    ASSERT_EQ(module->functions.size(), 1u);
    ASSERT_EQ(module->functions[0].blocks.size(), 1u);
    const Instruction& sum = module->functions[0].blocks[0].instructions[0];
    EXPECT_EQ(sum.op, spv::Op::OpFAdd);
    EXPECT_EQ(module->types[sum.type].kind, Type::Kind::kFloat);
    EXPECT_EQ(module->values[sum.result].name, "main");
    EXPECT_TRUE(module->values[sum.result].no_contraction);
    const std::uint32_t one = module->Operands(sum)[0];
    EXPECT_EQ(module->values[one].kind, Value::Kind::kConstant);
    EXPECT_THAT(module->constants[module->values[one].index].words, ElementsAre(0x3f800000u));
}

TEST(ReadModule, TellsWhatIsWrongWithTheHeader) {
    Words words = Ended(Begun());
    EXPECT_EQ(Reason(words), "");
    EXPECT_THAT(Reason({}), HasSubstr("0 words are no module"));
    EXPECT_THAT(Reason({spv::MagicNumber, 0x00010000, 0, 1}), HasSubstr("4 words"));
    const auto with = [&](std::size_t at, std::uint32_t word) {
        Words changed = words;
        changed[at] = word;
        return Reason(changed);
    };
    EXPECT_THAT(with(0, 0x03022307), HasSubstr("word 0: not the magic number"));
    EXPECT_THAT(with(1, 0x00020000), HasSubstr("word 1: not a version"));
    EXPECT_THAT(with(3, 0xffffffff), HasSubstr("word 3: the bound of ids"));
    EXPECT_THAT(with(4, 1), HasSubstr("word 4: the schema"));
    EXPECT_THAT(with(5, 0x00000011), HasSubstr("word 5: OpCapability: is 0 words long"));
    EXPECT_THAT(with(5, 0x0002ffff), HasSubstr("word 5: instruction 65535: is not known"));
    EXPECT_THAT(with(5, 0x00020000 | 133), HasSubstr("word 5: OpFMul: lacks an operand"));
}

TEST(ReadModule, NamesInstructionsThatItRefuses) {
    EXPECT_THAT(Reason(Ended(Begun().Add(spv::Op::OpAtomicIAdd, {kFloat, kSum, kOne, 1, 1, kOne}))),
                HasSubstr("OpAtomicIAdd: is not known"));
}

struct Row {
    spv::Op op;
    Words operands;
    const char* reason;
};

TEST(ReadModule, ChecksInstructions) {
    const std::vector<Row> rows = {
        {spv::Op::OpFAdd, {kFloat, kSum, kOne}, "OpFAdd: lacks an operand"},
        {spv::Op::OpFAdd, {kFloat, kSum, kOne, kOne, kOne}, "operands beyond those that it takes"},
        {spv::Op::OpFAdd, {kFloat, kSum, kOne, 100}, "has the id 100, not below the bound"},
        {spv::Op::OpFAdd, {kFloat, kSum, kOne, 0}, "has the id 0"},
        {spv::Op::OpFAdd, {kFloat, kSum, kOne, kSum}, "no value that stands before it"},
        {spv::Op::OpFAdd, {kFloat, kSum, kOne, kFloat}, "no value that stands before it"},
        {spv::Op::OpFAdd, {kOne, kSum, kOne, kOne}, "is no type that stands before it"},
        {spv::Op::OpFAdd, {kVector, kSum, kOne, kOne}, "operands are of the wrong types"},
        {spv::Op::OpFAdd, {kFloat, kOne, kOne, kOne}, "defines the id 5 once more"},
        {spv::Op::OpIAdd, {kFloat, kSum, kOne, kOne}, "operands are of the wrong types"},
        {spv::Op::OpDot, {kFloat, kSum, kOne, kOne}, "operands are of the wrong types"},
        {spv::Op::OpCompositeExtract, {kFloat, kSum, kOne, 0}, "operands are of the wrong types"},
        {spv::Op::OpCompositeConstruct, {kVector, kSum, kOne}, "operands are of the wrong types"},
        {spv::Op::OpVectorShuffle, {kVector, kSum, kOne, kOne, 0, 1}, "of the wrong types"},
        {spv::Op::OpLoad, {kFloat, kSum, kOne}, "first operand is no pointer"},
        {spv::Op::OpAccessChain, {kFloat, kSum, kOne}, "first operand is no pointer"},
        {spv::Op::OpFunctionCall, {kFloat, kSum, kEntry}, "does not fit the function's type"},
        {spv::Op::OpFunctionCall, {kVoid, kSum, kOne}, "calls no function"},
        {spv::Op::OpBranch, {kOne}, "is no block of the function"},
        {spv::Op::OpReturnValue, {kOne}, "operands are of the wrong types"},
        {spv::Op::OpTypeFloat, {kMore, 32}, "stands within a function"},
        {spv::Op::OpLabel, {kMore}, "stands within a block"},
        {spv::Op::OpString, {kMore, 0x61616161}, "has a string without an end"},
        {spv::Op::OpVariable, {kFloat, kSum, 7}, "no pointer into its storage class"},
    };
    for (const Row& row : rows) {
        EXPECT_THAT(Reason(Ended(Begun().Add(row.op, row.operands))), HasSubstr(row.reason))
            << OpName(row.op);
    }
    EXPECT_THAT(
        Reason(Begun().Add(spv::Op::OpBranch, {kLabel}).Add(spv::Op::OpFunctionEnd, {}).words()),
        HasSubstr("leads to the first block"));
}

TEST(ReadModule, ChecksTypesAndConstants) {
    const auto global = [](spv::Op op, const Words& operands) {
        Writer writer;
        writer.Add(spv::Op::OpTypeFloat, {kFloat, 32}).Add(spv::Op::OpTypeInt, {kVoid, 32, 0});
        writer.Add(spv::Op::OpConstant, {kVoid, kOne, 0x7fffffff});
        return Reason(writer.Add(op, operands).words());
    };
    EXPECT_THAT(global(spv::Op::OpTypeFloat, {kMore, 33}), HasSubstr("has a width of 33"));
    EXPECT_THAT(global(spv::Op::OpTypeVector, {kMore, kFloat, 5}), HasSubstr("has a size of 5"));
    EXPECT_THAT(global(spv::Op::OpTypeVector, {kMore, kMore, 2}), HasSubstr("no type that stands"));
    EXPECT_THAT(global(spv::Op::OpTypeMatrix, {kMore, kFloat, 2}), HasSubstr("wrong type"));
    EXPECT_THAT(global(spv::Op::OpTypeArray, {kMore, kFloat, kOne}),
                HasSubstr("has a length of 2147483647"));
    EXPECT_THAT(global(spv::Op::OpConstant, {kFloat, kMore, 1, 2}), HasSubstr("has 2 words"));
    EXPECT_THAT(global(spv::Op::OpConstantTrue, {kFloat, kMore}), HasSubstr("not bool"));
    EXPECT_THAT(global(spv::Op::OpConstantComposite, {kFloat, kMore, kOne}),
                HasSubstr("no composite"));
    EXPECT_THAT(global(spv::Op::OpNop, {}), HasSubstr("has no entry point"));
    EXPECT_THAT(global(spv::Op::OpReturn, {}), HasSubstr("stands outside a function"));
}

TEST(ReadModule, RefusesTypesNestedWithoutEnd) {
    Writer writer;
    writer.Add(spv::Op::OpTypeFloat, {1, 32});
    for (std::uint32_t id = 2; id < 60; ++id) {
        writer.Add(spv::Op::OpTypeStruct, {id, id - 1, id - 1});
    }
    EXPECT_THAT(Reason(writer.words()), HasSubstr("is nested more than 16 deep"));
}

TEST(ReadModule, EveryTruncationIsRefused) {
    const Words words = Ended(Begun().Add(spv::Op::OpFAdd, {kFloat, kSum, kOne, kOne}));
    for (std::size_t size = 0; size < words.size(); ++size) {
        EXPECT_FALSE(ReadModule(std::span(words).first(size)).ok()) << size;
    }
}

}  // namespace
}  // namespace etalon::spirv
