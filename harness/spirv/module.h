// A SPIR-V module in memory, as read.h has checked it: every index is within its vector, every
// operand has the kind and the type that its instruction asks for, and what an instruction uses
// stands before it in the module (but for the sources of an OpPhi).
//
// Ids are gone: types, values, functions and blocks are known by their places in the vectors below.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

// The enumerations of Debian's spirv-headers; no code comes with them.
#include <spirv/unified1/spirv.hpp11>

namespace etalon::spirv {

inline constexpr std::uint32_t kNone = 0xffffffffu;

struct Type {
    enum class Kind : std::uint8_t {
        kVoid,
        kBool,
        kInt,
        kFloat,
        kVector,
        kMatrix,
        kArray,
        kRuntimeArray,
        kStruct,
        kPointer,
        kFunction,
        kImage,
        kSampler,
        kSampledImage,
    };
    Kind kind = Kind::kVoid;
    std::uint32_t width = 0;  // bits, of an integer or a float
    bool is_signed = false;
    std::uint32_t element = kNone;       // a type: component, column, element, pointer's target,
                                         // function's result, texel's component, image
    std::uint32_t count = 0;             // components, columns, elements
    std::vector<std::uint32_t> members;  // types: of a structure, of a function's parameters
    spv::StorageClass storage = {};      // of a pointer

    spv::Dim dimension = {};  // of an image
    bool is_depth = false;
    bool is_arrayed = false;
    bool is_multisampled = false;

    std::uint32_t array_stride = kNone;  // bytes, where decorated
    std::vector<std::uint32_t> offsets;  // bytes of each member, kNone where not decorated
    std::string name;
    std::vector<std::string> member_names;  // empty, or of each member
};

struct Value {
    enum class Kind : std::uint8_t { kConstant, kVariable, kParameter, kResult };
    Kind kind = Kind::kResult;
    std::uint32_t type = kNone;
    std::uint32_t function = kNone;  // kNone for what stands outside functions
    std::uint32_t index = kNone;     // into Module::constants or Module::variables, or which
                                     // parameter
    bool no_contraction = false;
    bool relaxed_precision = false;
    std::string name;
};

struct Constant {
    std::vector<std::uint32_t> words;    // of a scalar, lowest first; a bool has one
    std::vector<std::uint32_t> members;  // values, of a composite
    bool is_null = false;                // zero through and through; also an undefined value
    bool is_spec = false;
};

struct Variable {
    std::uint32_t value = kNone;
    spv::StorageClass storage = {};
    std::uint32_t initializer = kNone;  // a constant value
    std::uint32_t set = kNone;
    std::uint32_t binding = kNone;
    std::uint32_t built_in = kNone;  // spv::BuiltIn
};

struct Line {
    std::string file;
    std::uint32_t line = 0;
    std::uint32_t column = 0;
};

struct Instruction {
    spv::Op op = spv::Op::OpNop;
    std::uint32_t type = kNone;
    std::uint32_t result = kNone;  // a value
    std::uint32_t first_operand = 0;
    std::uint32_t operands = 0;
    std::uint32_t line = kNone;  // into Module::lines
    std::uint32_t word = 0;      // where it stands in the module
};

// Its last instruction leaves the block, and no other does. Phi instructions come first.
struct Block {
    std::vector<Instruction> instructions;
    std::uint32_t merge = kNone;           // block, of OpSelectionMerge or OpLoopMerge
    std::uint32_t continue_block = kNone;  // of OpLoopMerge: the block is a loop's header
    std::vector<std::uint32_t> successors;
};

struct Function {
    std::uint32_t type = kNone;             // of kind kFunction
    std::vector<std::uint32_t> parameters;  // values
    std::vector<std::uint32_t> variables;   // values
    std::vector<Block> blocks;              // the first is the entry
    std::string name;
};

struct Module {
    std::vector<Type> types;
    std::vector<Value> values;
    std::vector<Constant> constants;
    std::vector<Variable> variables;  // global and local
    std::vector<Function> functions;
    std::vector<Line> lines;
    std::uint32_t entry = kNone;  // function; the one entry point
    spv::ExecutionModel model = {};

    // Operands after type and result, in the instruction's order. A value, type, function or block
    // is its index, a literal its word, the import of an OpExtInst is left out, mask words stand as
    // they are. OpPhi: pairs of value, block. OpSwitch: selector, default, then literal, block.
    std::vector<std::uint32_t> operands;

    std::span<const std::uint32_t> Operands(const Instruction& instruction) const {
        return std::span(operands).subspan(instruction.first_operand, instruction.operands);
    }
    const Type& TypeOf(std::uint32_t value) const { return types[values[value].type]; }
};

// "OpFAdd"; "instruction 1234" where it has no name here.
std::string OpName(spv::Op op);

// "InverseSqrt": an instruction of GLSL.std.450; empty where it is not known.
std::string GlslName(std::uint32_t instruction);

}  // namespace etalon::spirv
