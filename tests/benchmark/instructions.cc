#include "instructions.h"

#include <spirv/unified1/spirv.hpp11>

namespace etalon {
namespace {

constexpr std::size_t kHeaderWords = 5;

bool IsFetch(spv::Op op) {
    return op >= spv::Op::OpImageSampleImplicitLod && op <= spv::Op::OpImageRead;
}

bool IsComputing(spv::Op op) {
    switch (op) {
        case spv::Op::OpExtInst:
        case spv::Op::OpPhi:
        case spv::Op::OpBranchConditional:
        case spv::Op::OpSwitch:
            return true;
        case spv::Op::OpIAdd:
        case spv::Op::OpIMul:
            return false;
        default:
            return IsFetch(op) ||
                   (op >= spv::Op::OpVectorExtractDynamic && op <= spv::Op::OpTranspose) ||
                   (op >= spv::Op::OpConvertFToU && op < spv::Op::OpBitcast) ||
                   (op >= spv::Op::OpSNegate && op <= spv::Op::OpFwidthCoarse);
    }
}

}  // namespace

InstructionCount CountInstructions(std::span<const std::uint32_t> module) {
    InstructionCount count;
    bool in_function = false;
    for (std::size_t at = kHeaderWords; at < module.size();) {
        const auto op = static_cast<spv::Op>(module[at] & 0xffffu);
        in_function = in_function || op == spv::Op::OpFunction;
        if (in_function) {
            count.computing += IsComputing(op) ? 1 : 0;
            count.fetches += IsFetch(op) ? 1 : 0;
            count.loops = count.loops || op == spv::Op::OpLoopMerge;
        }
        const std::size_t words = module[at] >> 16;
        if (words == 0) {
            break;
        }
        at += words;
    }
    return count;
}

}  // namespace etalon
