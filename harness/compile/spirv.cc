#include "compile/spirv.h"

#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>
#include <spirv/unified1/spirv.hpp11>

namespace etalon {
namespace {

spv_target_env Environment(Target target) {
    return target.client == Target::Client::kVulkan ? SPV_ENV_VULKAN_1_1 : SPV_ENV_OPENGL_4_5;
}

class Messages {
  public:
    spvtools::MessageConsumer Consumer() {
        return [this](spv_message_level_t level, const char*, const spv_position_t&,
                      const char* message) {
            if (level <= SPV_MSG_ERROR && first_.empty()) {
                first_ = message;
            }
        };
    }
    Error AsError(const char* who) const {
        return Error{std::string(who) + ": " +
                     (first_.empty() ? "failed without a message" : first_)};
    }

  private:
    std::string first_;
};

bool IsArithmetic(spv::Op op) {
    switch (op) {
        case spv::Op::OpFNegate:
        case spv::Op::OpFAdd:
        case spv::Op::OpFSub:
        case spv::Op::OpFMul:
        case spv::Op::OpFDiv:
        case spv::Op::OpFRem:
        case spv::Op::OpFMod:
        case spv::Op::OpVectorTimesScalar:
        case spv::Op::OpMatrixTimesScalar:
        case spv::Op::OpVectorTimesMatrix:
        case spv::Op::OpMatrixTimesVector:
        case spv::Op::OpMatrixTimesMatrix:
        case spv::Op::OpOuterProduct:
        case spv::Op::OpDot:
        case spv::Op::OpExtInst:
            return true;
        default:
            return false;
    }
}

bool IsAnnotationOrLater(spv::Op op) {
    switch (op) {
        case spv::Op::OpCapability:
        case spv::Op::OpExtension:
        case spv::Op::OpExtInstImport:
        case spv::Op::OpMemoryModel:
        case spv::Op::OpEntryPoint:
        case spv::Op::OpExecutionMode:
        case spv::Op::OpExecutionModeId:
        case spv::Op::OpString:
        case spv::Op::OpSource:
        case spv::Op::OpSourceContinued:
        case spv::Op::OpSourceExtension:
        case spv::Op::OpName:
        case spv::Op::OpMemberName:
        case spv::Op::OpModuleProcessed:
            return false;
        default:
            return true;
    }
}

constexpr std::size_t kHeaderWords = 5;

}  // namespace

Status<> ValidateSpirv(const std::vector<std::uint32_t>& module, Target target) {
    Messages messages;
    spvtools::SpirvTools tools(Environment(target));
    tools.SetMessageConsumer(messages.Consumer());
    if (!tools.Validate(module)) {
        return messages.AsError("the SPIR-V validator");
    }
    return Ok();
}

Result<std::vector<std::uint32_t>> OptimiseSpirv(const std::vector<std::uint32_t>& module,
                                                 Recipe::Optimise goal, Target target) {
    Messages messages;
    spvtools::Optimizer optimizer(Environment(target));
    optimizer.SetMessageConsumer(messages.Consumer());
    if (goal == Recipe::Optimise::kSpeed) {
        optimizer.RegisterPerformancePasses();
    } else {
        optimizer.RegisterSizePasses();
    }
    std::vector<std::uint32_t> better;
    if (!optimizer.Run(module.data(), module.size(), &better)) {
        return messages.AsError("the SPIR-V optimiser");
    }
    return better;
}

std::vector<std::uint32_t> ForbidContraction(const std::vector<std::uint32_t>& module) {
    constexpr auto kDecorate = static_cast<std::uint32_t>(spv::Op::OpDecorate) | (3u << 16);
    constexpr auto kNoContraction = static_cast<std::uint32_t>(spv::Decoration::NoContraction);
    std::vector<std::uint32_t> decorations;
    std::size_t place = 0;
    for (std::size_t at = kHeaderWords; at < module.size(); at += module[at] >> 16) {
        const auto op = static_cast<spv::Op>(module[at] & 0xffffu);
        if (place == 0 && IsAnnotationOrLater(op)) {
            place = at;
        }
        if (IsArithmetic(op)) {
            decorations.insert(decorations.end(), {kDecorate, module[at + 2], kNoContraction});
        }
    }
    // glslang decorates `precise` operations itself; a second equal decoration is invalid.
    std::vector<std::uint32_t> precise;
    precise.reserve(module.size() + decorations.size());
    for (std::size_t at = 0; at < module.size();) {
        if (at == place) {
            precise.insert(precise.end(), decorations.begin(), decorations.end());
        }
        const std::size_t words = at == 0 ? kHeaderWords : module[at] >> 16;
        const bool repeated =
            at != 0 && module[at] == kDecorate && module[at + 2] == kNoContraction;
        if (!repeated) {
            precise.insert(precise.end(), module.begin() + static_cast<std::ptrdiff_t>(at),
                           module.begin() + static_cast<std::ptrdiff_t>(at + words));
        }
        at += words;
    }
    return precise;
}

}  // namespace etalon
