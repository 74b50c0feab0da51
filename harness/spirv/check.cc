#include "spirv/check.h"

#include <algorithm>
#include <string>

namespace etalon::spirv {
namespace {

using Kind = Type::Kind;
using Reason = std::optional<std::string>;

constexpr std::uint32_t kNoIndex = 0xffffffffu;  // of a vector shuffle: any value will do

class Checker {
  public:
    Checker(const Module& module, std::uint32_t function, const Instruction& instruction)
        : module_(module),
          function_(function),
          instruction_(instruction),
          operands_(module.Operands(instruction)) {}

    Reason Check(Rule rule) const;

  private:
    std::uint32_t TypeIndex(std::size_t operand) const {
        return module_.values[operands_[operand]].type;
    }
    const Type& OperandType(std::size_t operand) const { return module_.types[TypeIndex(operand)]; }
    Numbers Operand(std::size_t operand) const { return NumbersOf(module_, TypeIndex(operand)); }
    Numbers ResultNumbers() const { return NumbersOf(module_, instruction_.type); }
    const Type& ResultType() const { return module_.types[instruction_.type]; }
    bool IsInt(std::size_t operand) const { return Operand(operand) == Numbers{Kind::kInt, 32, 1}; }
    bool IsIndex(std::size_t operand) const {
        const Numbers index = Operand(operand);
        return index.kind == Kind::kInt && index.count == 1 && index.width == 32;
    }

    static Reason Unless(bool good) {
        return good ? Reason() : Reason("its operands are of the wrong types");
    }

    Reason Same(Kind kind) const;
    Reason Compare(Kind kind) const;
    Reason Convert(Kind from, Kind to) const;
    Reason Product(Rule rule) const;
    Reason Composite(Rule rule) const;
    Reason Memory(Rule rule) const;
    Reason Image(Rule rule) const;
    Reason AccessChain() const;
    Reason Shuffle() const;
    Reason Construct() const;
    Reason Select() const;
    Reason Field(std::size_t values) const;
    Reason IntPair() const;
    Reason Return() const;
    Reason Selector() const;
    // The type that literal indices from `first` on lead to; kNone where they lead nowhere.
    std::uint32_t Walk(std::uint32_t type, std::size_t first) const;

    const Module& module_;
    std::uint32_t function_;
    const Instruction& instruction_;
    std::span<const std::uint32_t> operands_;
};

Reason Checker::Check(Rule rule) const {
    switch (rule) {
        case Rule::kAny:
        case Rule::kCall:
        case Rule::kPhi:
            return {};
        case Rule::kFloats:
            return Same(Kind::kFloat);
        case Rule::kInts:
            return Same(Kind::kInt);
        case Rule::kBools:
            return Same(Kind::kBool);
        case Rule::kCompareFloats:
            return Compare(Kind::kFloat);
        case Rule::kCompareInts:
            return Compare(Kind::kInt);
        case Rule::kAnyAll:
            return Unless(ResultType().kind == Kind::kBool && Operand(0).kind == Kind::kBool);
        case Rule::kFloatToInt:
            return Convert(Kind::kFloat, Kind::kInt);
        case Rule::kIntToFloat:
            return Convert(Kind::kInt, Kind::kFloat);
        case Rule::kIntToInt:
            return Convert(Kind::kInt, Kind::kInt);
        case Rule::kFloatToFloat:
            return Convert(Kind::kFloat, Kind::kFloat);
        case Rule::kBitcast: {
            const Numbers from = Operand(0);
            const Numbers to = ResultNumbers();
            const auto is_number = [](Kind kind) {
                return kind == Kind::kInt || kind == Kind::kFloat;
            };
            return Unless(is_number(from.kind) && is_number(to.kind) && from.count == to.count &&
                          from.width == to.width);
        }
        case Rule::kSelect:
            return Select();
        case Rule::kFieldInsert:
            return Field(2);
        case Rule::kFieldExtract:
            return Field(1);
        case Rule::kIntPair:
            return IntPair();
        case Rule::kVectorTimesScalar:
        case Rule::kMatrixTimesScalar:
        case Rule::kVectorTimesMatrix:
        case Rule::kMatrixTimesVector:
        case Rule::kMatrixTimesMatrix:
        case Rule::kOuterProduct:
        case Rule::kDot:
        case Rule::kTranspose:
            return Product(rule);
        case Rule::kExtract:
        case Rule::kInsert:
        case Rule::kExtractDynamic:
        case Rule::kInsertDynamic:
        case Rule::kShuffle:
        case Rule::kConstruct:
        case Rule::kSame:
        case Rule::kCopyLogical:
            return Composite(rule);
        case Rule::kLoad:
        case Rule::kStore:
        case Rule::kCopyMemory:
        case Rule::kAccessChain:
        case Rule::kArrayLength:
            return Memory(rule);
        case Rule::kCondition:
            return Unless(OperandType(0).kind == Kind::kBool);
        case Rule::kSelector:
            return Selector();
        case Rule::kReturn:
            return Return();
        case Rule::kImageOf:
        case Rule::kSample:
        case Rule::kFetch:
        case Rule::kQuery:
            return Image(rule);
        case Rule::kExtended:
            return CheckGlsl(module_, instruction_);
    }
    return {};
}

// All are alike; signs may differ, and so may the widths of what an integer is shifted by.
Reason Checker::Same(Kind kind) const {
    const Numbers result = ResultNumbers();
    bool good = result.kind == kind;
    for (std::size_t i = 0; i < operands_.size(); ++i) {
        good = good && Operand(i) == result;
    }
    return Unless(good);
}

Reason Checker::Compare(Kind kind) const {
    const Numbers result = ResultNumbers();
    bool good = result.kind == Kind::kBool;
    for (std::size_t i = 0; i < operands_.size(); ++i) {
        good = good && Operand(i).kind == kind && Operand(i).count == result.count &&
               Operand(i).width == Operand(0).width;
    }
    return Unless(good);
}

Reason Checker::Convert(Kind from, Kind to) const {
    return Unless(Operand(0).kind == from && ResultNumbers().kind == to &&
                  Operand(0).count == ResultNumbers().count);
}

Reason Checker::Select() const {
    const Numbers condition = Operand(0);
    const Kind kind = ResultType().kind;
    const bool is_data = kind != Kind::kVoid && kind != Kind::kFunction;
    return Unless(is_data && condition.kind == Kind::kBool && TypeIndex(1) == instruction_.type &&
                  TypeIndex(2) == instruction_.type &&
                  (condition.count == 1 || condition.count == ResultNumbers().count));
}

Reason Checker::Field(std::size_t values) const {
    const Numbers result = ResultNumbers();
    bool good = result.kind == Kind::kInt;
    for (std::size_t i = 0; i < values; ++i) {
        good = good && Operand(i) == result;
    }
    return Unless(good && IsInt(values) && IsInt(values + 1));
}

Reason Checker::IntPair() const {
    const Type& result = ResultType();
    if (result.kind != Kind::kStruct || result.members.size() != 2) {
        return "its result is no pair";
    }
    const Numbers low = NumbersOf(module_, result.members[0]);
    return Unless(low.kind == Kind::kInt && low == NumbersOf(module_, result.members[1]) &&
                  Operand(0) == low && Operand(1) == low);
}

// A vector is a matrix of one column, or of one row.
Reason Checker::Product(Rule rule) const {
    struct Shape {
        std::uint32_t columns = 0;
        std::uint32_t rows = 0;
        std::uint32_t width = 0;
        bool operator==(const Shape&) const = default;
    };
    const auto shape = [&](std::uint32_t index) {
        const Type& type = module_.types[index];
        const bool is_matrix = type.kind == Kind::kMatrix;
        const Numbers column = NumbersOf(module_, is_matrix ? type.element : index);
        return column.kind == Kind::kFloat
                   ? Shape{is_matrix ? type.count : 1u, column.count, column.width}
                   : Shape{};
    };
    const Shape result = shape(instruction_.type);
    const Shape a = shape(TypeIndex(0));
    const Shape b = operands_.size() > 1 ? shape(TypeIndex(1)) : Shape{};
    const bool matrix_result = ResultType().kind == Kind::kMatrix;
    const bool a_matrix = OperandType(0).kind == Kind::kMatrix;
    if (a.width == 0 || result.width != a.width) {
        return Unless(false);
    }
    switch (rule) {
        case Rule::kVectorTimesScalar:
            return Unless(!a_matrix && !matrix_result && result == a && b == Shape{1, 1, a.width});
        case Rule::kMatrixTimesScalar:
            return Unless(a_matrix && matrix_result && result == a && b == Shape{1, 1, a.width});
        case Rule::kVectorTimesMatrix:
            return Unless(!a_matrix && !matrix_result && OperandType(1).kind == Kind::kMatrix &&
                          b == Shape{result.rows, a.rows, a.width});
        case Rule::kMatrixTimesVector:
            return Unless(a_matrix && !matrix_result && result.rows == a.rows &&
                          b == Shape{1, a.columns, a.width} &&
                          OperandType(1).kind == Kind::kVector);
        case Rule::kMatrixTimesMatrix:
            return Unless(a_matrix && matrix_result && OperandType(1).kind == Kind::kMatrix &&
                          result.rows == a.rows && b == Shape{result.columns, a.columns, a.width});
        case Rule::kOuterProduct:
            return Unless(!a_matrix && matrix_result && b.columns == 1 &&
                          result == Shape{b.rows, a.rows, b.width});
        case Rule::kDot:
            return Unless(!a_matrix && a.rows > 1 && a == b && result == Shape{1, 1, a.width});
        default:  // kTranspose
            return Unless(a_matrix && matrix_result && result == Shape{a.rows, a.columns, a.width});
    }
}

std::uint32_t Checker::Walk(std::uint32_t type, std::size_t first) const {
    for (std::size_t i = first; i < operands_.size(); ++i) {
        const Type& outer = module_.types[type];
        const std::uint32_t index = operands_[i];
        switch (outer.kind) {
            case Kind::kStruct:
                if (index >= outer.members.size()) {
                    return kNone;
                }
                type = outer.members[index];
                break;
            case Kind::kVector:
            case Kind::kMatrix:
            case Kind::kArray:
                if (index >= outer.count) {
                    return kNone;
                }
                type = outer.element;
                break;
            default:
                return kNone;
        }
    }
    return type;
}

Reason Checker::Composite(Rule rule) const {
    switch (rule) {
        case Rule::kExtract:
            return Unless(Walk(TypeIndex(0), 1) == instruction_.type);
        case Rule::kInsert:
            return Unless(TypeIndex(1) == instruction_.type &&
                          Walk(instruction_.type, 2) == TypeIndex(0));
        case Rule::kExtractDynamic:
            return Unless(OperandType(0).kind == Kind::kVector &&
                          OperandType(0).element == instruction_.type && IsIndex(1));
        case Rule::kInsertDynamic:
            return Unless(ResultType().kind == Kind::kVector && TypeIndex(0) == instruction_.type &&
                          TypeIndex(1) == ResultType().element && IsIndex(2));
        case Rule::kShuffle:
            return Shuffle();
        case Rule::kConstruct:
            return Construct();
        case Rule::kSame:
            return Unless(TypeIndex(0) == instruction_.type);
        default:  // kCopyLogical: types that differ in decorations only
            return "is not known";
    }
}

Reason Checker::Shuffle() const {
    const Type& result = ResultType();
    const Type& a = OperandType(0);
    const Type& b = OperandType(1);
    bool good = result.kind == Kind::kVector && a.kind == Kind::kVector &&
                b.kind == Kind::kVector && a.element == result.element &&
                b.element == result.element && operands_.size() == result.count + 2;
    for (std::size_t i = 2; good && i < operands_.size(); ++i) {
        good = operands_[i] == kNoIndex || operands_[i] < a.count + b.count;
    }
    return Unless(good);
}

Reason Checker::Construct() const {
    const Type& result = ResultType();
    if (result.kind == Kind::kVector) {
        const Numbers whole = ResultNumbers();
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < operands_.size(); ++i) {
            const Numbers part = Operand(i);
            const std::uint32_t component = part.count > 1 ? OperandType(i).element : TypeIndex(i);
            if (part.kind != whole.kind || component != result.element) {
                return Unless(false);
            }
            count += part.count;
        }
        return Unless(count == whole.count);
    }
    const bool is_struct = result.kind == Kind::kStruct;
    if (!is_struct && result.kind != Kind::kMatrix && result.kind != Kind::kArray) {
        return "its result is no composite";
    }
    bool good = operands_.size() == (is_struct ? result.members.size() : result.count);
    for (std::size_t i = 0; good && i < operands_.size(); ++i) {
        good = TypeIndex(i) == (is_struct ? result.members[i] : result.element);
    }
    return Unless(good);
}

Reason Checker::Memory(Rule rule) const {
    const Type& pointer = OperandType(0);
    if (pointer.kind != Kind::kPointer) {
        return "its first operand is no pointer";
    }
    switch (rule) {
        case Rule::kLoad:
            return Unless(pointer.element == instruction_.type);
        case Rule::kStore:
            return Unless(TypeIndex(1) == pointer.element);
        case Rule::kCopyMemory:
            return Unless(OperandType(1).kind == Kind::kPointer &&
                          OperandType(1).element == pointer.element);
        case Rule::kAccessChain:
            return AccessChain();
        default: {  // kArrayLength
            const Type& block = module_.types[pointer.element];
            return Unless(ResultNumbers() == Numbers{Kind::kInt, 32, 1} &&
                          block.kind == Kind::kStruct && operands_[1] < block.members.size() &&
                          module_.types[block.members[operands_[1]]].kind == Kind::kRuntimeArray);
        }
    }
}

Reason Checker::AccessChain() const {
    std::uint32_t type = OperandType(0).element;
    for (std::size_t i = 1; i < operands_.size(); ++i) {
        const Type& outer = module_.types[type];
        if (!IsIndex(i)) {
            return "an index is no 32-bit integer";
        }
        switch (outer.kind) {
            case Kind::kStruct: {
                const Value& value = module_.values[operands_[i]];
                if (value.kind != Value::Kind::kConstant) {
                    return "an index into a structure is no constant";
                }
                const Constant& constant = module_.constants[value.index];
                const std::uint32_t index = constant.is_null ? 0 : constant.words[0];
                if (index >= outer.members.size()) {
                    return "an index lies outside its structure";
                }
                type = outer.members[index];
                break;
            }
            case Kind::kVector:
            case Kind::kMatrix:
            case Kind::kArray:
            case Kind::kRuntimeArray:
                type = outer.element;
                break;
            default:
                return "has more indices than its base has levels";
        }
    }
    const Type& result = ResultType();
    return Unless(result.kind == Kind::kPointer && result.storage == OperandType(0).storage &&
                  result.element == type);
}

Reason Checker::Selector() const {
    const Numbers selector = Operand(0);
    return Unless(selector.kind == Kind::kInt && selector.width == 32 && selector.count == 1);
}

Reason Checker::Return() const {
    const Type& type = module_.types[module_.functions[function_].type];
    if (instruction_.op == spv::Op::OpReturn) {
        return Unless(module_.types[type.element].kind == Kind::kVoid);
    }
    return Unless(TypeIndex(0) == type.element);
}

Reason Checker::Image(Rule rule) const {
    const Type& first = OperandType(0);
    if (rule == Rule::kImageOf) {
        return Unless(first.kind == Kind::kSampledImage && first.element == instruction_.type);
    }
    const bool samples = rule == Rule::kSample;
    if (first.kind != (samples ? Kind::kSampledImage : Kind::kImage)) {
        return Unless(false);
    }
    const Numbers result = ResultNumbers();
    if (rule == Rule::kQuery) {
        return Unless(result.kind == Kind::kInt && result.width == 32 &&
                      (operands_.size() == 1 || IsInt(1)));
    }
    const Numbers coordinate = Operand(1);
    bool good = result.count == 4 && result.width == 32 &&
                coordinate.kind == (samples ? Kind::kFloat : Kind::kInt) && coordinate.width == 32;
    for (std::size_t i = 3; i < operands_.size(); ++i) {
        good = good && Operand(i).kind != Kind::kVoid && Operand(i).width == 32;
    }
    return Unless(good);
}

}  // namespace

Numbers NumbersOf(const Module& module, std::uint32_t type) {
    const Type* component = &module.types[type];
    std::uint32_t count = 1;
    if (component->kind == Kind::kVector) {
        count = component->count;
        component = &module.types[component->element];
    }
    switch (component->kind) {
        case Kind::kBool:
        case Kind::kInt:
        case Kind::kFloat:
            return {component->kind, component->width, count};
        default:
            return {};
    }
}

std::optional<std::string> CheckTypes(const Module& module, std::uint32_t function,
                                      const Instruction& instruction, Rule rule) {
    return Checker(module, function, instruction).Check(rule);
}

}  // namespace etalon::spirv
