// Runs a plan: blocks, branches and the table of operations. Included by the one file of each
// number type, which instantiates Evaluator for it.
#pragma once

#include <spirv/unified1/GLSL.std.450.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "evaluate/arithmetic.h"
#include "evaluate/composite.h"
#include "evaluate/glsl_integer.h"
#include "evaluate/glsl_scalar.h"
#include "evaluate/glsl_vector.h"
#include "evaluate/image.h"
#include "evaluate/integer.h"
#include "evaluate/memory.h"
#include "evaluate/relation.h"

namespace etalon::evaluate {

template <typename N>
using Operation = void (*)(Machine<N>&, const Step&);

template <typename N>
Operation<N> OperationOf(std::uint32_t code) {
    static const std::unordered_map<std::uint32_t, Operation<N>> table = {
#define ETALON_OPERATION(name) {static_cast<std::uint32_t>(spv::Op::Op##name), operation::name<N>},
#include "evaluate/operations.def"
#undef ETALON_OPERATION
#define ETALON_GLSL_OPERATION(name) {kGlslCode + GLSLstd450##name, glsl::name<N>},
#include "evaluate/glsl_operations.def"
#undef ETALON_GLSL_OPERATION
    };
    const auto found = table.find(code);
    ETALON_CHECK(found != table.end());
    return found->second;
}

// What a function needs while it runs; as no function calls itself, it has one for good.
template <typename N>
struct Frame {
    std::vector<Mask> waiting;  // by block: the lanes that are to enter it
    std::vector<N> floats;      // of phis, between reading and writing
    std::vector<std::uint32_t> words;
    std::vector<Mask> ways;  // by edge of a switch
};

template <typename N>
struct Runner : Machine<N> {
    std::vector<Operation<N>> operations;         // by step
    std::vector<Operation<N>> global_operations;  // by step of Plan::globals
    std::vector<Frame<N>> frames;                 // by function
    std::vector<std::uint32_t> first_blocks;      // by function: its first in Rows::visits
    std::uint32_t blocks = 0;                     // of all functions

    Runner(std::shared_ptr<const Plan> what, const std::vector<Texture>& textures, Limits most);

    // Runs the program, lane by lane at these rows; the context, `rows` and `first_row` are set.
    void RunLanes(std::span<const std::uint32_t> rows_of_lanes);
    void RunFunction(std::uint32_t index);
    void RunBlock(const Block& block);
    void Leave(Frame<N>& frame, const Function& function, const Block& block);
    void Take(Frame<N>& frame, const Edge& edge, const Mask& mask);
    void MovePhis(Frame<N>& frame, const Edge& edge, const Mask& mask);
    void Switch(Frame<N>& frame, const Block& block);
    void CountStep(const Block& block);
    void CountVisits(std::uint32_t block);
};

template <typename N>
void RunFunction(Machine<N>& m, std::uint32_t function) {
    static_cast<Runner<N>&>(m).RunFunction(function);
}

// The lanes of the first block that has any are run, until no block has any. All lanes come back,
// but for those that are killed.
template <typename N>
void Runner<N>::RunFunction(std::uint32_t index) {
    const Function& function = this->plan->functions[index];
    Frame<N>& frame = frames[index];
    const Lanes caller = this->lanes;
    const std::uint32_t calling = std::exchange(this->running, index);
    frame.waiting[0] = caller.mask;
    const auto count = static_cast<std::uint32_t>(function.blocks.size());
    for (std::uint32_t at = 0; at < count && this->failure.empty();) {
        if (frame.waiting[at].IsEmpty()) {
            ++at;
            continue;
        }
        if (!(frame.waiting[at] == this->lanes.mask)) {
            this->lanes.Set(frame.waiting[at]);
        }
        frame.waiting[at] = Mask{};
        if (!this->rows->visits.empty()) {
            CountVisits(first_blocks[index] + at);
        }
        const Block& block = function.blocks[at];
        RunBlock(block);
        if (this->lanes.count == 0) {
            continue;
        }
        Leave(frame, function, block);
        for (const Edge& edge : block.edges) {
            at = std::min(at, edge.block);
        }
    }
    if (!this->failure.empty()) {
        std::fill(frame.waiting.begin(), frame.waiting.end(), Mask{});
    }
    this->lanes = caller;
    this->running = calling;
    if (!this->killed.IsEmpty()) {
        Mask alive = caller.mask;
        alive.Remove(this->killed);
        this->lanes.Set(alive);
    }
}

template <typename N>
void Runner<N>::CountStep(const Block& block) {
    bool is_spent = false;
    for (std::uint32_t i = 0; i < this->lanes.count; ++i) {
        const std::uint32_t lane = this->lanes.is_dense ? i : this->lanes.index[i];
        is_spent |= ++this->spent[lane] > this->limits.steps;
    }
    if (is_spent && this->failure.empty()) {
        Step at;
        at.line = block.line;
        Mask(this->lanes.mask).Each([&](std::uint32_t lane) {
            if (this->spent[lane] > this->limits.steps) {
                this->Fail(
                    lane, at,
                    "a loop does not end within " + std::to_string(this->limits.steps) + " steps");
            }
        });
    }
}

template <typename N>
void Runner<N>::CountVisits(std::uint32_t block) {
    std::uint32_t* visits =
        this->rows->visits.data() + std::size_t{block} * this->rows->count + this->first_row;
    this->lanes.Each([&](std::uint32_t lane) { ++visits[lane]; });
}

template <typename N>
void Runner<N>::RunBlock(const Block& block) {
    if (block.is_counted) {
        CountStep(block);
    }
    if constexpr (requires { this->context.lost; }) {
        if (!this->context.lost.IsEmpty()) {
            this->killed.Add(this->context.lost);
            Mask rest = this->lanes.mask;
            rest.Remove(this->context.lost);
            this->lanes.Set(rest);
            if (rest.IsEmpty()) {
                return;
            }
        }
    }
    const Step* step = this->plan->steps.data() + block.first_step;
    const Operation<N>* run = operations.data() + block.first_step;
    for (std::uint32_t i = 0; i < block.steps; ++i) {
        if constexpr (requires { this->context.Before(*this, step[i]); }) {
            this->context.Before(*this, step[i]);
        }
        run[i](*this, step[i]);
        if constexpr (requires { this->context.After(*this, step[i]); }) {
            this->context.After(*this, step[i]);
        }
    }
}

template <typename N>
void Runner<N>::Leave(Frame<N>& frame, const Function& function, const Block& block) {
    switch (block.end) {
        case Block::End::kBranch:
            Take(frame, block.edges[0], this->lanes.mask);
            break;
        case Block::End::kCondition: {
            const std::uint32_t* condition = this->Words(block.column);
            Mask yes;
            // Lanes::Each is for what each lane does for itself; a set belongs to all.
            for (std::uint32_t i = 0; i < this->lanes.count; ++i) {
                const std::uint32_t lane = this->lanes.is_dense ? i : this->lanes.index[i];
                if (condition[lane] != 0) {
                    yes.Add(lane);
                }
            }
            Mask no = this->lanes.mask;
            no.Remove(yes);
            if (!yes.IsEmpty()) {
                Take(frame, block.edges[0], yes);
            }
            if (!no.IsEmpty()) {
                Take(frame, block.edges[1], no);
            }
            break;
        }
        case Block::End::kSwitch:
            Switch(frame, block);
            break;
        case Block::End::kReturn:
            if (function.result_size != Columns{}) {
                this->Copy(block.returned.from, block.returned.to, block.returned.size);
            }
            break;
        case Block::End::kKill:
            this->killed.Add(this->lanes.mask);
            break;
        case Block::End::kUnreachable:
            break;
    }
}

template <typename N>
void Runner<N>::Switch(Frame<N>& frame, const Block& block) {
    const std::uint32_t* selector = this->Words(block.column);
    frame.ways.assign(block.edges.size(), Mask{});
    for (std::uint32_t i = 0; i < this->lanes.count; ++i) {
        const std::uint32_t lane = this->lanes.is_dense ? i : this->lanes.index[i];
        const auto found = std::find(block.cases.begin(), block.cases.end(), selector[lane]);
        const bool is_default = found == block.cases.end();
        frame.ways[is_default ? 0 : static_cast<std::size_t>(found - block.cases.begin()) + 1].Add(
            lane);
    }
    for (std::size_t i = 0; i < block.edges.size(); ++i) {
        if (!frame.ways[i].IsEmpty()) {
            Take(frame, block.edges[i], frame.ways[i]);
        }
    }
}

template <typename N>
void Runner<N>::Take(Frame<N>& frame, const Edge& edge, const Mask& mask) {
    if (!edge.moves.empty()) {
        MovePhis(frame, edge, mask);
    }
    frame.waiting[edge.block].Add(mask);
}

// All sources are read before any phi is written: they may be each other's.
template <typename N>
void Runner<N>::MovePhis(Frame<N>& frame, const Edge& edge, const Mask& mask) {
    Lanes saved;
    const bool is_part = !(mask == this->lanes.mask);
    if (is_part) {
        saved = this->lanes;
        this->lanes.Set(mask);
    }
    if (edge.moves.size() == 1) {
        this->Copy(edge.moves[0].from, edge.moves[0].to, edge.moves[0].size);
    } else {
        frame.floats.clear();
        frame.words.clear();
        for (const Move& move : edge.moves) {
            const N* first_float = this->Floats(move.from.floats);
            frame.floats.insert(frame.floats.end(), first_float,
                                first_float + std::size_t{move.size.floats} * kLanes);
            const std::uint32_t* first_word = this->Words(move.from.words);
            frame.words.insert(frame.words.end(), first_word,
                               first_word + std::size_t{move.size.words} * kLanes);
        }
        const N* from_floats = frame.floats.data();
        const std::uint32_t* from_words = frame.words.data();
        for (const Move& move : edge.moves) {
            for (std::uint32_t i = 0; i < move.size.floats; ++i, from_floats += kLanes) {
                N* to = this->Floats(move.to.floats + i);
                this->lanes.Each([&](std::uint32_t lane) { to[lane] = from_floats[lane]; });
            }
            for (std::uint32_t i = 0; i < move.size.words; ++i, from_words += kLanes) {
                std::uint32_t* to = this->Words(move.to.words + i);
                this->lanes.Each([&](std::uint32_t lane) { to[lane] = from_words[lane]; });
            }
        }
    }
    if (is_part) {
        this->lanes = saved;
    }
}

template <typename N>
Runner<N>::Runner(std::shared_ptr<const Plan> what, const std::vector<Texture>& textures,
                  Limits most) {
    ETALON_CHECK(textures.size() >= what->images);
    this->Prepare(std::move(what));
    this->images = textures;
    this->limits = most;
    for (const Step& step : this->plan->steps) {
        operations.push_back(OperationOf<N>(step.code));
    }
    for (const Step& step : this->plan->globals) {
        global_operations.push_back(OperationOf<N>(step.code));
    }
    for (const Function& function : this->plan->functions) {
        first_blocks.push_back(blocks);
        blocks += static_cast<std::uint32_t>(function.blocks.size());
        frames.emplace_back();
        frames.back().waiting.resize(function.blocks.size());
    }
}

template <typename N>
void Runner<N>::RunLanes(std::span<const std::uint32_t> rows_of_lanes) {
    this->Start(rows_of_lanes);
    for (std::size_t i = 0; i < this->plan->globals.size(); ++i) {
        global_operations[i](*this, this->plan->globals[i]);
    }
    RunFunction(this->plan->entry);
}

template <typename N>
struct Evaluator<N>::State : Runner<N> {
    using Runner<N>::Runner;
};

template <typename N>
Evaluator<N>::Evaluator(std::shared_ptr<const Plan> plan, const std::vector<Texture>& images,
                        Limits limits)
    : state_(std::make_unique<State>(std::move(plan), images, limits)) {}

template <typename N>
Evaluator<N>::~Evaluator() = default;

template <typename N>
Status<> Evaluator<N>::Run(const Rows<N>& rows) {
    ETALON_CHECK(rows.exact.empty() || rows.exact.size() == rows.outputs.size());
    ETALON_CHECK(rows.visits.empty() ||
                 rows.visits.size() == std::size_t{state_->blocks} * rows.count);
    State& state = *state_;
    state.rows = &rows;
    state.failure.clear();
    std::array<std::uint32_t, kLanes> row_of_lane;
    for (std::uint32_t first = 0; first < rows.count && state.failure.empty(); first += kLanes) {
        state.first_row = first;
        const std::uint32_t count = std::min(kLanes, rows.count - first);
        std::iota(row_of_lane.begin(), row_of_lane.begin() + count, first);
        state.RunLanes(std::span(row_of_lane).first(count));
    }
    state.rows = nullptr;
    if (!state.failure.empty()) {
        return Error{state.failure};
    }
    return Ok();
}

}  // namespace etalon::evaluate
