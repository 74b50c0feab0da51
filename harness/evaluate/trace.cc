#include "evaluate/trace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "evaluate/run.h"
#include "spirv/watch.h"

namespace etalon::evaluate {

// Where a number comes from, led through everything that only moves numbers.
template <>
struct Ops<Origin> {
    static Origin FromBits(std::uint32_t) { return {}; }
    static std::uint32_t ToBits(const Origin&) { return 0; }
};

namespace {

constexpr std::uint32_t Code(spv::Op op) {
    return static_cast<std::uint32_t>(op);
}

Operation<Origin> MoveOf(std::uint32_t code) {
    switch (static_cast<spv::Op>(code)) {
        case spv::Op::OpVariable:
            return operation::Variable<Origin>;
        case spv::Op::OpLoad:
            return operation::Load<Origin>;
        case spv::Op::OpStore:
            return operation::Store<Origin>;
        case spv::Op::OpAccessChain:
            return operation::AccessChain<Origin>;
        case spv::Op::OpVectorExtractDynamic:
            return operation::VectorExtractDynamic<Origin>;
        case spv::Op::OpVectorInsertDynamic:
            return operation::VectorInsertDynamic<Origin>;
        case spv::Op::OpVectorShuffle:
            return operation::VectorShuffle<Origin>;
        case spv::Op::OpCompositeConstruct:
            return operation::CompositeConstruct<Origin>;
        case spv::Op::OpCompositeInsert:
            return operation::CompositeInsert<Origin>;
        case spv::Op::OpTranspose:
            return operation::Transpose<Origin>;
        case spv::Op::OpSelect:
            return operation::Select<Origin>;
        default:
            return nullptr;
    }
}

double AsRatio(const Big& change, const Big& base) {
    using O = Ops<Big>;
    if (O::IsNan(change) || O::Equal(change, Big())) {
        return O::IsNan(change) ? std::numeric_limits<double>::quiet_NaN() : 0;
    }
    return std::fabs(O::Div(change, base).ToDouble());
}

// The same row by three machines in step: in binary32, exactly, and where each number comes from.
class Tracer {
  public:
    Tracer(std::shared_ptr<const Plan> plan, const std::vector<Texture>& images, Limits limits)
        : plan_(std::move(plan)), limits_(limits) {
        Each([&](auto& m) {
            m.Prepare(plan_);
            m.images = images;
        });
        for (const spirv::Function& function : plan_->module.functions) {
            for (const spirv::Block& block : function.blocks) {
                for (const spirv::Instruction& instruction : block.instructions) {
                    sources_.emplace(
                        instruction.word,
                        Source{&instruction, spirv::IsWatchable(plan_->module, instruction)});
                }
            }
        }
    }

    Result<Trace> Run(std::span<const std::uint32_t> inputs, std::uint32_t output_words) {
        trace_.outputs.resize(output_words);
        trace_.exact.resize(output_words);
        trace_.origins.resize(output_words);
        std::vector<std::uint32_t> unused(output_words);
        std::vector<float> floats(output_words);
        const Rows<float> rows{1, inputs, trace_.outputs, floats};
        const Rows<Big> exact_rows{1, inputs, unused, trace_.exact};
        const Rows<Origin> origin_rows{1, inputs, unused, trace_.origins};
        strict_.rows = &rows;
        exact_.rows = &exact_rows;
        origin_.rows = &origin_rows;
        const std::uint32_t row = 0;
        Each([&](auto& m) { m.Start({&row, 1}); });
        for (const Step& step : plan_->globals) {
            RunStep(step);
        }
        RunFunction(plan_->entry);
        if (!strict_.failure.empty()) {
            return Error{strict_.failure};
        }
        trace_.is_killed = is_killed_;
        return std::move(trace_);
    }

  private:
    template <typename F>
    void Each(F&& f) {
        f(strict_);
        f(exact_);
        f(origin_);
    }

    void RunFunction(std::uint32_t index) {
        const std::uint32_t calling = std::exchange(strict_.running, index);
        RunBlocks(plan_->functions[index]);
        strict_.running = calling;
    }

    void RunBlocks(const Function& function) {
        for (std::uint32_t at = 0;;) {
            const Block& block = function.blocks[at];
            if (block.is_counted && ++spent_ > limits_.steps) {
                Step step;
                step.line = block.line;
                strict_.Fail(
                    0, step,
                    "a loop does not end within " + std::to_string(limits_.steps) + " steps");
            }
            for (std::uint32_t i = 0; i < block.steps && IsAlive(); ++i) {
                RunStep(plan_->steps[block.first_step + i]);
            }
            if (!IsAlive()) {
                return;
            }
            std::size_t edge = 0;
            switch (block.end) {
                case Block::End::kBranch:
                    break;
                case Block::End::kCondition:
                    edge = strict_.Words(block.column)[0] != 0 ? 0 : 1;
                    break;
                case Block::End::kSwitch: {
                    const auto found = std::find(block.cases.begin(), block.cases.end(),
                                                 strict_.Words(block.column)[0]);
                    edge = found == block.cases.end()
                               ? 0
                               : static_cast<std::size_t>(found - block.cases.begin()) + 1;
                    break;
                }
                case Block::End::kReturn:
                    if (function.result_size != Columns{}) {
                        Each([&](auto& m) {
                            m.Copy(block.returned.from, block.returned.to, block.returned.size);
                        });
                    }
                    return;
                case Block::End::kKill:
                    is_killed_ = true;
                    return;
                case Block::End::kUnreachable:
                    return;
            }
            Each([&](auto& m) { MovePhis(m, block.edges[edge]); });
            at = block.edges[edge].block;
        }
    }

    bool IsAlive() const { return strict_.failure.empty() && !is_killed_; }

    // All sources are read before any phi is written: they may be each other's.
    template <typename N>
    static void MovePhis(Machine<N>& m, const Edge& edge) {
        std::vector<N> floats;
        std::vector<std::uint32_t> words;
        for (const Move& move : edge.moves) {
            for (std::uint32_t i = 0; i < move.size.floats; ++i) {
                floats.push_back(m.Floats(move.from.floats + i)[0]);
            }
            for (std::uint32_t i = 0; i < move.size.words; ++i) {
                words.push_back(m.Words(move.from.words + i)[0]);
            }
        }
        std::size_t next_float = 0;
        std::size_t next_word = 0;
        for (const Move& move : edge.moves) {
            for (std::uint32_t i = 0; i < move.size.floats; ++i) {
                m.Floats(move.to.floats + i)[0] = floats[next_float++];
            }
            for (std::uint32_t i = 0; i < move.size.words; ++i) {
                m.Words(move.to.words + i)[0] = words[next_word++];
            }
        }
    }

    void RunStep(const Step& step) {
        if (step.code == Code(spv::Op::OpFunctionCall)) {
            RunCall(step);
            return;
        }
        const auto found = sources_.find(step.word);
        const Source source = found == sources_.end() ? Source{} : found->second;
        if (const Operation<Origin> move = MoveOf(step.code)) {
            if (step.code == Code(spv::Op::OpStore)) {
                NoteStore(step, source.instruction);
            }
            OperationOf<float>(step.code)(strict_, step);
            OperationOf<Big>(step.code)(exact_, step);
            move(origin_, step);
            return;
        }
        if (!source.is_watchable) {
            // Of words alone, or a cast of bits.
            OperationOf<float>(step.code)(strict_, step);
            OperationOf<Big>(step.code)(exact_, step);
            LeadWords(step, step.size.words);
            MarkNumbers(step, kNone);
            if (step.code == Code(spv::Op::OpBitcast)) {
                FollowBits(step);
            }
            return;
        }
        Record(step, source.instruction);
    }

    void RunCall(const Step& step) {
        const Call& call = plan_->calls[step.extra];
        Each([&](auto& m) {
            for (const Move& move : call.values) {
                m.Copy(move.from, move.to, move.size);
            }
            for (const Call::Pointer& pointer : call.pointers) {
                m.slots[pointer.slot] = m.Resolve(pointer.address);
            }
        });
        RunFunction(call.function);
        Each([&](auto& m) { m.Copy(call.result.from, call.result.to, call.result.size); });
    }

    // Words are those of binary32, in all machines.
    void LeadWords(const Step& step, std::uint32_t count) {
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t word = strict_.Words(step.result.words + i)[0];
            exact_.Words(step.result.words + i)[0] = word;
            origin_.Words(step.result.words + i)[0] = word;
        }
    }
    // A number whose bits were taken, and then come back, is still that number: it was moved,
    // compared or chosen among others as an integer.
    void FollowBits(const Step& step) {
        for (std::uint32_t i = 0; i < step.components; ++i) {
            if (step.size.floats == 0 && step.extra != 0) {
                const std::uint32_t from = strict_.Operand(step, 0).floats + i;
                cast_.insert_or_assign(strict_.Words(step.result.words + i)[0],
                                       Cast{exact_.Floats(from)[0], origin_.Floats(from)[0]});
            } else if (step.size.floats != 0 && step.extra == 0) {
                const std::uint32_t to = step.result.floats + i;
                const auto cast = cast_.find(strict_.Words(strict_.Operand(step, 0).words + i)[0]);
                if (cast != cast_.end()) {
                    exact_.Floats(to)[0] = cast->second.exact;
                    origin_.Floats(to)[0] = cast->second.origin;
                }
            }
        }
    }
    void MarkNumbers(const Step& step, std::uint32_t traced) {
        for (std::uint32_t i = 0; i < step.size.floats; ++i) {
            origin_.Floats(step.result.floats + i)[0] =
                traced == kNone ? Origin{} : Origin{traced, i};
        }
    }

    // The variable that a number is kept in names it.
    void NoteStore(const Step& step, const spirv::Instruction* instruction) {
        if (step.size.floats == 0 ||
            plan_->addresses[step.address].space == Address::Space::kOutputs) {
            return;
        }
        const Origin first = origin_.Floats(origin_.Operand(step, 0).floats)[0];
        for (std::uint32_t i = 0; i < step.size.floats; ++i) {
            if (first.step == kNone || !(origin_.Floats(origin_.Operand(step, 0).floats + i)[0] ==
                                         Origin{first.step, i})) {
                return;
            }
        }
        TracedStep& traced = trace_.steps[first.step];
        if (traced.stored == nullptr && traced.numbers.size() == step.size.floats) {
            traced.stored = instruction;
        }
    }

    void Record(const Step& step, const spirv::Instruction* instruction) {
        const std::vector<std::uint32_t> values = OperandValues(plan_->module, *instruction);
        TracedStep traced;
        traced.instruction = instruction;
        std::vector<std::uint32_t> columns;
        for (std::size_t k = 0; k < values.size(); ++k) {
            const Columns place = strict_.Operand(step, k);
            const std::uint32_t type = plan_->module.values[values[k]].type;
            const std::uint32_t floats = spirv::CountFloats(plan_->module, type);
            const auto leaves =
                static_cast<std::uint32_t>(spirv::Leaves(plan_->module, type).size());
            traced.operands.emplace_back();
            traced.operand_words.emplace_back();
            for (std::uint32_t i = 0; i < floats; ++i) {
                const std::uint32_t column = place.floats + i;
                traced.operands.back().push_back({strict_.Floats(column)[0],
                                                  exact_.Floats(column)[0],
                                                  origin_.Floats(column)[0]});
                columns.push_back(column);
            }
            for (std::uint32_t i = floats; i < leaves; ++i) {
                traced.operand_words.back().push_back(strict_.Words(place.words + i - floats)[0]);
            }
        }
        OperationOf<float>(step.code)(strict_, step);
        OperationOf<Big>(step.code)(exact_, step);
        for (std::uint32_t i = 0; i < step.size.words; ++i) {
            traced.words.push_back(
                {strict_.Words(step.result.words + i)[0], exact_.Words(step.result.words + i)[0]});
        }
        const bool is_frexp = step.code == kGlslCode + GLSLstd450FrexpStruct;
        if (is_frexp) {
            KeepValueOfFrexp(step);
        }
        for (std::uint32_t i = 0; i < step.size.floats; ++i) {
            TracedNumber number;
            number.value = strict_.Floats(step.result.floats + i)[0];
            number.exact = exact_.Floats(step.result.floats + i)[0];
            traced.numbers.push_back(number);
        }
        LeadWords(step, is_frexp ? step.components : step.size.words);
        if (trace_.steps.size() == kMostTraced) {
            trace_.is_cut = true;
            MarkNumbers(step, kNone);
            return;
        }
        std::sort(columns.begin(), columns.end());
        columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
        if (!is_frexp && step.size.floats != 0) {
            Measure(step, columns, traced);
        }
        MarkNumbers(step, static_cast<std::uint32_t>(trace_.steps.size()));
        if (step.code == kGlslCode + GLSLstd450ModfStruct) {
            // The whole part, where it goes through a pointer, is no part of the result.
            for (std::uint32_t i = step.size.floats; i < 2 * step.components; ++i) {
                origin_.Floats(step.result.floats + i)[0] = Origin{};
            }
        }
        trace_.steps.push_back(std::move(traced));
    }

    // The exact significand goes with the exponent of binary32.
    void KeepValueOfFrexp(const Step& step) {
        for (std::uint32_t i = 0; i < step.components; ++i) {
            Big& significand = exact_.Floats(step.result.floats + i)[0];
            const std::int64_t more =
                std::int64_t{static_cast<std::int32_t>(exact_.Words(step.result.words + i)[0])} -
                static_cast<std::int32_t>(strict_.Words(step.result.words + i)[0]);
            significand = Ops<Big>::Ldexp(significand, static_cast<std::int32_t>(more));
        }
    }

    // Moves each number that goes in by 2^-40 of itself and looks what comes out.
    void Measure(const Step& step, const std::vector<std::uint32_t>& columns, TracedStep& traced) {
        using O = Ops<Big>;
        constexpr std::int32_t kMoved = -40;
        std::vector<std::uint32_t> words(step.size.words);
        for (std::uint32_t i = 0; i < step.size.words; ++i) {
            words[i] = exact_.Words(step.result.words + i)[0];
        }
        const Operation<Big> run = OperationOf<Big>(step.code);
        for (const std::uint32_t column : columns) {
            const Big kept = exact_.Floats(column)[0];
            if (O::IsNan(kept) || O::IsInf(kept)) {
                continue;
            }
            const bool is_zero = O::Equal(kept, Big());
            // Of a zero the least float shows at least what depends on it.
            exact_.Floats(column)[0] =
                is_zero ? O::FromBits(1) : O::Add(kept, O::Ldexp(kept, kMoved));
            run(exact_, step);
            exact_.Floats(column)[0] = kept;
            const Origin origin = origin_.Floats(column)[0];
            for (std::uint32_t i = 0; i < step.size.floats; ++i) {
                TracedNumber& number = traced.numbers[i];
                const Big change = O::Sub(exact_.Floats(step.result.floats + i)[0], number.exact);
                if (O::Equal(change, Big())) {
                    continue;
                }
                if (!is_zero) {
                    number.amplification += std::ldexp(AsRatio(change, number.exact), -kMoved);
                }
                if (origin.step != kNone) {
                    number.from.push_back(origin);
                }
            }
        }
        for (std::uint32_t i = 0; i < step.size.floats; ++i) {
            exact_.Floats(step.result.floats + i)[0] = traced.numbers[i].exact;
        }
        for (std::uint32_t i = 0; i < step.size.words; ++i) {
            exact_.Words(step.result.words + i)[0] = words[i];
        }
    }

    std::shared_ptr<const Plan> plan_;
    Limits limits_;
    Machine<float> strict_;
    Machine<Big> exact_;
    Machine<Origin> origin_;
    struct Source {
        const spirv::Instruction* instruction = nullptr;
        bool is_watchable = false;
    };
    std::unordered_map<std::uint32_t, Source> sources_;  // by word
    struct Cast {
        Big exact;
        Origin origin;
    };
    std::unordered_map<std::uint32_t, Cast> cast_;  // by the number's bits
    std::uint32_t spent_ = 0;
    bool is_killed_ = false;
    Trace trace_;
};

}  // namespace

std::vector<std::uint32_t> OperandValues(const spirv::Module& module,
                                         const spirv::Instruction& instruction) {
    const std::span<const std::uint32_t> operands = module.Operands(instruction);
    switch (instruction.op) {
        case spv::Op::OpExtInst: {
            // What modf and frexp write through a pointer is no operand.
            const bool has_pointer =
                operands[0] == GLSLstd450Modf || operands[0] == GLSLstd450Frexp;
            return {operands.begin() + 1, has_pointer ? operands.begin() + 2 : operands.end()};
        }
        case spv::Op::OpImageSampleExplicitLod:
        case spv::Op::OpImageFetch:
            if (operands.size() > 3) {
                return {operands[1], operands[3]};
            }
            return {operands[1]};
        default:
            return {operands.begin(), operands.end()};
    }
}

Result<Trace> TraceRow(std::shared_ptr<const Plan> plan, const std::vector<Texture>& images,
                       std::span<const std::uint32_t> inputs, std::uint32_t output_words,
                       Limits limits) {
    return Tracer(std::move(plan), images, limits).Run(inputs, output_words);
}

}  // namespace etalon::evaluate
