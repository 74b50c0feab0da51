// Turns a checked module into a plan. The parts: translate.cc leads, translate_instruction.cc makes
// the steps, translate_memory.cc lays out types, variables and pointers, translate_control.cc
// orders the blocks.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "evaluate/plan.h"
#include "spirv/check.h"

namespace etalon::evaluate {

// What a plan never goes beyond.
inline constexpr std::uint64_t kMostColumns = 1u << 16;
inline constexpr std::uint64_t kMostSteps = 1u << 20;

// The order of blocks that plan.h promises, those that nothing leads to left out.
std::vector<std::uint32_t> OrderBlocks(const spirv::Function& function);

class Translator {
  public:
    explicit Translator(spirv::Module module) { plan_->module = std::move(module); }

    Result<std::shared_ptr<const Plan>> Translate();

  private:
    using Instruction = spirv::Instruction;
    using Kind = spirv::Type::Kind;

    // translate.cc
    Status<> TranslateFunction(std::uint32_t index);
    Status<> TranslateBlock(const spirv::Function& function, std::uint32_t block,
                            const std::vector<std::uint32_t>& places, Block& out);
    Status<> TranslateConstants();
    void AddEdge(const spirv::Function& function, std::uint32_t from, std::uint32_t to,
                 const std::vector<std::uint32_t>& places, Block& out);
    Status<> CheckRecursion();
    Error Wrong(const Instruction& instruction, const std::string& reason) const;

    // translate_instruction.cc
    Status<> TranslateStep(const Instruction& instruction);
    Status<> TranslateOrdinary(const Instruction& instruction);
    Status<> TranslateExtended(const Instruction& instruction);
    Status<> TranslateCall(const Instruction& instruction);
    Status<> TranslateImage(const Instruction& instruction);
    Step MakeStep(std::uint32_t code, const Instruction& instruction);
    void AddOperand(Step& step, Columns place);

    // translate_memory.cc
    void LayOutTypes();
    Result<Columns> SizeOf(std::uint32_t type) const;
    Result<Columns> Allocate(std::uint32_t type);
    Columns Part(std::uint32_t& type, std::uint32_t index) const;
    Status<> PlaceVariable(std::uint32_t variable, std::vector<Step>& steps, bool is_set_first);
    Status<> CheckAddress(const Instruction& instruction, std::uint32_t value) const;
    Status<> TranslateLoad(const Instruction& instruction);
    Status<> TranslateStore(const Instruction& instruction);
    Status<> TranslateChain(const Instruction& instruction);
    std::optional<std::uint32_t> ConstantWord(std::uint32_t value) const;
    // The number whose bits the value is, where that is plain to see.
    void NoteBits(const Instruction& instruction);
    bool ReturnsBits(const spirv::Function& function) const;
    bool IsOutputOnly(std::uint32_t value) const;
    bool IsSetFirst(const spirv::Function& function, std::uint32_t variable) const;
    std::uint32_t AddAddress(const Address& address);

    // translate_control.cc
    Status<> TranslateEnd(const spirv::Function& function, std::uint32_t block,
                          const Instruction& instruction, const std::vector<std::uint32_t>& places,
                          Block& out);

    const std::shared_ptr<Plan> plan_ = std::make_shared<Plan>();
    const spirv::Module& module_ = plan_->module;
    std::vector<std::optional<Columns>> sizes_;  // by type; none where no column can hold it
    std::vector<Columns> places_;                // by value
    std::vector<std::uint32_t> addresses_;       // by value: of pointers and images
    std::unordered_map<std::uint32_t, std::string> refused_;  // by value: why it has no address
    std::vector<std::uint32_t> bits_;                // by value: column of the number, or kNone
    std::vector<std::vector<std::uint32_t>> slots_;  // by function and parameter
};

}  // namespace etalon::evaluate
