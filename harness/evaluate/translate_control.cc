#include <algorithm>

#include "evaluate/translate.h"

namespace etalon::evaluate {

// The reverse of the order in which a depth-first walk leaves the blocks. What is visited first is
// left first and comes last: so of a block's ways the merge block is taken first, then the continue
// block.
std::vector<std::uint32_t> OrderBlocks(const spirv::Function& function) {
    const auto ways = [&](std::uint32_t block) {
        const spirv::Block& source = function.blocks[block];
        std::vector<std::uint32_t> to;
        if (source.merge != kNone) {
            to.push_back(source.merge);
        }
        if (source.continue_block != kNone) {
            to.push_back(source.continue_block);
        }
        to.insert(to.end(), source.successors.begin(), source.successors.end());
        return to;
    };
    struct Visit {
        std::uint32_t block;
        std::vector<std::uint32_t> ways;
        std::size_t next = 0;
    };
    std::vector<std::uint32_t> order;
    std::vector<bool> seen(function.blocks.size());
    std::vector<Visit> stack;
    stack.push_back({0, ways(0)});
    seen[0] = true;
    while (!stack.empty()) {
        Visit& top = stack.back();
        if (top.next == top.ways.size()) {
            order.push_back(top.block);
            stack.pop_back();
            continue;
        }
        const std::uint32_t to = top.ways[top.next++];
        if (!seen[to]) {
            seen[to] = true;
            stack.push_back({to, ways(to)});
        }
    }
    std::reverse(order.begin(), order.end());
    return order;
}

void Translator::AddEdge(const spirv::Function& function, std::uint32_t from, std::uint32_t to,
                         const std::vector<std::uint32_t>& places, Block& out) {
    Edge edge;
    edge.block = places[to];
    for (const Instruction& phi : function.blocks[to].instructions) {
        if (phi.op != spv::Op::OpPhi) {
            break;
        }
        const std::span<const std::uint32_t> operands = module_.Operands(phi);
        for (std::size_t i = 0; i + 1 < operands.size(); i += 2) {
            if (operands[i + 1] == from) {
                edge.moves.push_back(
                    {places_[operands[i]], places_[phi.result], *sizes_[phi.type]});
                break;
            }
        }
    }
    out.edges.push_back(std::move(edge));
}

Status<> Translator::TranslateEnd(const spirv::Function& function, std::uint32_t block,
                                  const Instruction& instruction,
                                  const std::vector<std::uint32_t>& places, Block& out) {
    const std::span<const std::uint32_t> operands = module_.Operands(instruction);
    switch (instruction.op) {
        case spv::Op::OpBranch:
            out.end = Block::End::kBranch;
            AddEdge(function, block, operands[0], places, out);
            break;
        case spv::Op::OpBranchConditional:
            out.end = Block::End::kCondition;
            out.column = places_[operands[0]].words;
            AddEdge(function, block, operands[1], places, out);
            AddEdge(function, block, operands[2], places, out);
            break;
        case spv::Op::OpSwitch:
            out.end = Block::End::kSwitch;
            out.column = places_[operands[0]].words;
            AddEdge(function, block, operands[1], places, out);
            for (std::size_t i = 2; i + 1 < operands.size(); i += 2) {
                out.cases.push_back(operands[i]);
                AddEdge(function, block, operands[i + 1], places, out);
            }
            break;
        case spv::Op::OpReturn:
            out.end = Block::End::kReturn;
            break;
        case spv::Op::OpReturnValue: {
            out.end = Block::End::kReturn;
            ETALON_TRY(size, SizeOf(module_.values[operands[0]].type));
            const auto index = static_cast<std::size_t>(&function - module_.functions.data());
            out.returned = {places_[operands[0]], plan_->functions[index].result, size};
            break;
        }
        case spv::Op::OpKill:
        case spv::Op::OpTerminateInvocation:
            out.end = Block::End::kKill;
            break;
        default:
            out.end = Block::End::kUnreachable;
            break;
    }
    return Ok();
}

}  // namespace etalon::evaluate
