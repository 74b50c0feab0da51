#include "evaluate/count.h"

#include <spirv/unified1/GLSL.std.450.h>

#include <algorithm>
#include <spirv/unified1/spirv.hpp11>

#include "base/check.h"

namespace etalon::evaluate {
namespace {

using Class = OperationClass;

// Sums and products of a scalar product.
std::int64_t OfDot(std::int64_t components) {
    return 2 * components - 1;
}

std::int64_t OfDeterminant(std::int64_t rows) {
    return rows == 1 ? 0 : rows * OfDeterminant(rows - 1) + OfDot(rows);
}

Operations Of(Class kind, std::int64_t count) {
    Operations operations;
    operations[kind] = count;
    return operations;
}

Operations Both(Class first, std::int64_t count, Class second, std::int64_t other) {
    Operations operations = Of(first, count);
    operations[second] += other;
    return operations;
}

Operations OfLength(std::int64_t components) {
    return components == 1 ? Of(Class::kArithmetic, 1)
                           : Both(Class::kArithmetic, OfDot(components), Class::kSpecial, 1);
}

Operations OfGlsl(const Step& step) {
    const std::int64_t n = step.components;
    const std::int64_t of_operand = step.extra;
    switch (step.code - kGlslCode) {
        case GLSLstd450Round:
        case GLSLstd450RoundEven:
        case GLSLstd450Trunc:
        case GLSLstd450FAbs:
        case GLSLstd450Floor:
        case GLSLstd450Ceil:
        case GLSLstd450Fract:
        case GLSLstd450Radians:
        case GLSLstd450Degrees:
        case GLSLstd450Ldexp:
            return Of(Class::kArithmetic, n);
        case GLSLstd450ModfStruct:
        case GLSLstd450Fma:
            return Of(Class::kArithmetic, 2 * n);
        case GLSLstd450FMix:
            return Of(Class::kArithmetic, 4 * n);
        case GLSLstd450Sin:
        case GLSLstd450Cos:
        case GLSLstd450Tan:
        case GLSLstd450Asin:
        case GLSLstd450Acos:
        case GLSLstd450Atan:
        case GLSLstd450Sinh:
        case GLSLstd450Cosh:
        case GLSLstd450Tanh:
        case GLSLstd450Asinh:
        case GLSLstd450Acosh:
        case GLSLstd450Atanh:
        case GLSLstd450Atan2:
        case GLSLstd450Pow:
        case GLSLstd450Exp:
        case GLSLstd450Log:
        case GLSLstd450Exp2:
        case GLSLstd450Log2:
        case GLSLstd450Sqrt:
        case GLSLstd450InverseSqrt:
            return Of(Class::kSpecial, n);
        case GLSLstd450FMin:
        case GLSLstd450FMax:
        case GLSLstd450NMin:
        case GLSLstd450NMax:
        case GLSLstd450UMin:
        case GLSLstd450SMin:
        case GLSLstd450UMax:
        case GLSLstd450SMax:
        case GLSLstd450Step:
            return Of(Class::kComparison, n);
        case GLSLstd450FSign:
        case GLSLstd450SSign:
        case GLSLstd450FClamp:
        case GLSLstd450NClamp:
        case GLSLstd450UClamp:
        case GLSLstd450SClamp:
            return Of(Class::kComparison, 2 * n);
        case GLSLstd450SmoothStep: {
            Operations operations = Both(Class::kArithmetic, 6 * n, Class::kComparison, 2 * n);
            operations[Class::kDivision] = n;
            return operations;
        }
        case GLSLstd450Length:
            return OfLength(of_operand);
        case GLSLstd450Distance: {
            Operations operations = OfLength(of_operand);
            operations[Class::kArithmetic] += of_operand;
            return operations;
        }
        case GLSLstd450Normalize: {
            Operations operations = OfLength(n);
            operations[Class::kArithmetic] += n;
            return operations;
        }
        case GLSLstd450Cross:
            return Of(Class::kArithmetic, 9);
        case GLSLstd450FaceForward:
            return Both(Class::kArithmetic, OfDot(n), Class::kComparison, 1 + n);
        case GLSLstd450Reflect:
            return Of(Class::kArithmetic, OfDot(n) + 1 + 2 * n);
        case GLSLstd450Refract: {
            // 1 - eta^2 (1 - c^2), eta c + sqrt(k), and eta i - (...) n.
            Operations operations =
                Both(Class::kArithmetic, OfDot(n) + 5 + 2 + 3 * n, Class::kComparison, 1);
            operations[Class::kSpecial] = 1;
            return operations;
        }
        case GLSLstd450Determinant:
            return Of(Class::kArithmetic, OfDeterminant(of_operand));
        case GLSLstd450MatrixInverse:
            return Both(Class::kArithmetic,
                        OfDeterminant(of_operand) + n * OfDeterminant(of_operand - 1) + n / 2,
                        Class::kDivision, n);
        case GLSLstd450SAbs:
        case GLSLstd450FindILsb:
        case GLSLstd450FindSMsb:
        case GLSLstd450FindUMsb:
            return Of(Class::kInteger, n);
        case GLSLstd450FrexpStruct:
            return Of(Class::kOther, n);
        case GLSLstd450PackSnorm4x8:
        case GLSLstd450PackUnorm4x8:
        case GLSLstd450PackSnorm2x16:
        case GLSLstd450PackUnorm2x16:
        case GLSLstd450PackHalf2x16:
        case GLSLstd450UnpackSnorm2x16:
        case GLSLstd450UnpackUnorm2x16:
        case GLSLstd450UnpackHalf2x16:
        case GLSLstd450UnpackSnorm4x8:
        case GLSLstd450UnpackUnorm4x8:
            return Of(Class::kOther, 1);
        default:
            break;
    }
    CheckFailed(__FILE__, __LINE__, "a function of glsl_operations.def has no count");
}

}  // namespace

Operations& Operations::operator+=(const Operations& more) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
        counts[i] += more.counts[i];
    }
    return *this;
}

Operations& Operations::operator-=(const Operations& less) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
        counts[i] -= less.counts[i];
    }
    return *this;
}

Operations OperationsOf(const Plan& plan, const Step& step) {
    if (step.code >= kGlslCode) {
        return OfGlsl(step);
    }
    const std::int64_t n = step.components;
    const std::int64_t of_operand = step.extra;
    switch (static_cast<spv::Op>(step.code)) {
        case spv::Op::OpFNegate:
        case spv::Op::OpFAdd:
        case spv::Op::OpFSub:
        case spv::Op::OpFMul:
        case spv::Op::OpVectorTimesScalar:
        case spv::Op::OpMatrixTimesScalar:
        case spv::Op::OpOuterProduct:
            return Of(Class::kArithmetic, n);
        case spv::Op::OpDot:
            return Of(Class::kArithmetic, OfDot(of_operand));
        case spv::Op::OpVectorTimesMatrix:
            return Of(Class::kArithmetic, n * OfDot(of_operand));
        case spv::Op::OpMatrixTimesVector:
        case spv::Op::OpMatrixTimesMatrix:
            return Of(Class::kArithmetic, n * OfDot(plan.Literals(step)[0]));
        case spv::Op::OpFDiv:
        case spv::Op::OpFRem:
        case spv::Op::OpFMod:
            return Of(Class::kDivision, n);
        case spv::Op::OpAny:
        case spv::Op::OpAll:
            return Of(Class::kComparison, of_operand - 1);
        case spv::Op::OpIsNan:
        case spv::Op::OpIsInf:
        case spv::Op::OpLogicalEqual:
        case spv::Op::OpLogicalNotEqual:
        case spv::Op::OpLogicalOr:
        case spv::Op::OpLogicalAnd:
        case spv::Op::OpLogicalNot:
        case spv::Op::OpSelect:
        case spv::Op::OpIEqual:
        case spv::Op::OpINotEqual:
        case spv::Op::OpUGreaterThan:
        case spv::Op::OpSGreaterThan:
        case spv::Op::OpUGreaterThanEqual:
        case spv::Op::OpSGreaterThanEqual:
        case spv::Op::OpULessThan:
        case spv::Op::OpSLessThan:
        case spv::Op::OpULessThanEqual:
        case spv::Op::OpSLessThanEqual:
        case spv::Op::OpFOrdEqual:
        case spv::Op::OpFUnordEqual:
        case spv::Op::OpFOrdNotEqual:
        case spv::Op::OpFUnordNotEqual:
        case spv::Op::OpFOrdLessThan:
        case spv::Op::OpFUnordLessThan:
        case spv::Op::OpFOrdGreaterThan:
        case spv::Op::OpFUnordGreaterThan:
        case spv::Op::OpFOrdLessThanEqual:
        case spv::Op::OpFUnordLessThanEqual:
        case spv::Op::OpFOrdGreaterThanEqual:
        case spv::Op::OpFUnordGreaterThanEqual:
            return Of(Class::kComparison, n);
        case spv::Op::OpSNegate:
        case spv::Op::OpIAdd:
        case spv::Op::OpISub:
        case spv::Op::OpIMul:
        case spv::Op::OpUDiv:
        case spv::Op::OpSDiv:
        case spv::Op::OpUMod:
        case spv::Op::OpSRem:
        case spv::Op::OpSMod:
        case spv::Op::OpShiftRightLogical:
        case spv::Op::OpShiftRightArithmetic:
        case spv::Op::OpShiftLeftLogical:
        case spv::Op::OpBitwiseOr:
        case spv::Op::OpBitwiseXor:
        case spv::Op::OpBitwiseAnd:
        case spv::Op::OpNot:
        case spv::Op::OpBitFieldInsert:
        case spv::Op::OpBitFieldSExtract:
        case spv::Op::OpBitFieldUExtract:
        case spv::Op::OpBitReverse:
        case spv::Op::OpBitCount:
            return Of(Class::kInteger, n);
        case spv::Op::OpIAddCarry:
        case spv::Op::OpISubBorrow:
        case spv::Op::OpUMulExtended:
        case spv::Op::OpSMulExtended:
            // The result has two words for each pair of operands.
            return Of(Class::kInteger, n / 2);
        case spv::Op::OpImageSampleExplicitLod:
        case spv::Op::OpImageFetch:
            return Of(Class::kFetch, 1);
        case spv::Op::OpConvertFToU:
        case spv::Op::OpConvertFToS:
        case spv::Op::OpConvertSToF:
        case spv::Op::OpConvertUToF:
            return Of(Class::kOther, n);
        case spv::Op::OpImageQuerySizeLod:
        case spv::Op::OpImageQueryLevels:
            return Of(Class::kOther, 1);
        case spv::Op::OpBitcast:
        case spv::Op::OpTranspose:
        case spv::Op::OpVectorExtractDynamic:
        case spv::Op::OpVectorInsertDynamic:
        case spv::Op::OpVectorShuffle:
        case spv::Op::OpCompositeConstruct:
        case spv::Op::OpCompositeInsert:
        case spv::Op::OpVariable:
        case spv::Op::OpLoad:
        case spv::Op::OpStore:
        case spv::Op::OpAccessChain:
        case spv::Op::OpFunctionCall:
            return {};
        default:
            break;
    }
    CheckFailed(__FILE__, __LINE__, "an instruction of operations.def has no count");
}

Result<std::vector<Operations>> CountOperations(const std::shared_ptr<const Plan>& plan,
                                                const std::vector<Texture>& images,
                                                std::uint32_t rows,
                                                std::span<const std::uint32_t> inputs,
                                                std::uint32_t output_words, Limits limits) {
    Operations before;
    for (const Step& step : plan->globals) {
        before += OperationsOf(*plan, step);
    }
    std::vector<Operations> of_blocks;
    for (const Function& function : plan->functions) {
        for (const Block& block : function.blocks) {
            Operations& sum = of_blocks.emplace_back();
            for (std::uint32_t i = 0; i < block.steps; ++i) {
                sum += OperationsOf(*plan, plan->steps[block.first_step + i]);
            }
        }
    }
    std::vector<std::uint32_t> outputs(std::size_t{rows} * output_words);
    std::vector<std::uint32_t> visits(of_blocks.size() * rows);
    Evaluator<float> evaluator(plan, images, limits);
    ETALON_TRY_STEP(evaluator.Run({rows, inputs, outputs, {}, visits}));
    std::vector<Operations> counted(rows, before);
    for (std::size_t block = 0; block < of_blocks.size(); ++block) {
        for (std::uint32_t row = 0; row < rows; ++row) {
            const std::int64_t times = visits[block * rows + row];
            for (std::size_t kind = 0; kind < kOperationClasses; ++kind) {
                counted[row].counts[kind] += times * of_blocks[block].counts[kind];
            }
        }
    }
    return counted;
}

}  // namespace etalon::evaluate
