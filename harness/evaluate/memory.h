// Variables, pointers, buffers and calls.
#pragma once

#include "evaluate/machine.h"
#include "evaluate/number.h"

namespace etalon::evaluate {

template <typename N>
void RunFunction(Machine<N>& m, std::uint32_t function);

namespace operation {

// A variable's first value.
template <typename N>
void Variable(Machine<N>& m, const Step& step) {
    if (step.operands != 0) {
        m.Copy(m.Operand(step, 0), step.result, step.size);
        return;
    }
    const N zero = Ops<N>::FromBits(0);
    for (std::uint32_t i = 0; i < step.size.floats; ++i) {
        N* target = m.Floats(step.result.floats + i);
        m.lanes.Each([&](std::uint32_t lane) { target[lane] = zero; });
    }
    for (std::uint32_t i = 0; i < step.size.words; ++i) {
        std::uint32_t* target = m.Words(step.result.words + i);
        m.lanes.Each([&](std::uint32_t lane) { target[lane] = 0; });
    }
}

// Calls f(lane, where in the buffer) where that is within it; elsewhere it notes an error.
template <typename N, typename F>
void EachPlace(Machine<N>& m, const Step& step, std::size_t size, F f) {
    const auto target = m.Resolve(step.address);
    const std::uint32_t* offsets = target.offsets == kNone ? nullptr : m.Words(target.offsets + 1);
    m.lanes.Each([&](std::uint32_t lane) {
        const std::uint32_t place = target.place.words + (offsets == nullptr ? 0 : offsets[lane]);
        if (place >= size) {
            m.Fail(lane, step, "word " + std::to_string(place) + " is outside of the buffer");
            return;
        }
        f(lane, place);
    });
}

// Calls f(lane, columns of numbers, of words) to add to the target's place.
template <typename N, typename F>
void EachOffset(Machine<N>& m, const Step& step, const typename Machine<N>::Target& target, F f) {
    const std::uint32_t* float_offsets = m.Words(target.offsets);
    const std::uint32_t* word_offsets = m.Words(target.offsets + 1);
    const Columns end = target.place + step.size;
    m.lanes.Each([&](std::uint32_t lane) {
        // Chains check their indices; a module without dominance may reach here before its chain.
        if (float_offsets[lane] > m.plan->columns.floats - end.floats ||
            word_offsets[lane] > m.plan->columns.words - end.words) {
            m.Fail(lane, step, "a pointer is used before it has a value");
            return;
        }
        f(lane, float_offsets[lane], word_offsets[lane]);
    });
}

template <typename N>
void LoadInput(Machine<N>& m, const Step& step) {
    // Word 0 of the buffer is the number of rows.
    const auto& inputs = m.rows->inputs;
    EachPlace(m, step, inputs.size() + 1, [&](std::uint32_t lane, std::uint32_t place) {
        const std::uint32_t word = place == 0 ? m.rows->count : inputs[place - 1];
        if (step.size.floats != 0) {
            m.Floats(step.result.floats)[lane] = Ops<N>::FromBits(word);
        } else {
            m.Words(step.result.words)[lane] = word;
        }
    });
}

template <typename N>
void LoadOutput(Machine<N>& m, const Step& step) {
    const auto& outputs = m.rows->outputs;
    EachPlace(m, step, outputs.size(), [&](std::uint32_t lane, std::uint32_t place) {
        if (step.size.floats != 0) {
            m.Floats(step.result.floats)[lane] = Ops<N>::FromBits(outputs[place]);
        } else {
            m.Words(step.result.words)[lane] = outputs[place];
        }
    });
}

template <typename N>
void Load(Machine<N>& m, const Step& step) {
    switch (m.plan->addresses[step.address].space) {
        case Address::Space::kInputs:
            return LoadInput(m, step);
        case Address::Space::kOutputs:
            return LoadOutput(m, step);
        default:
            break;
    }
    const auto target = m.Resolve(step.address);
    if (target.offsets == kNone) {
        m.Copy(target.place, step.result, step.size);
        return;
    }
    EachOffset(m, step, target, [&](std::uint32_t lane, std::uint32_t floats, std::uint32_t words) {
        for (std::uint32_t i = 0; i < step.size.floats; ++i) {
            m.Floats(step.result.floats + i)[lane] =
                m.Floats(target.place.floats + floats + i)[lane];
        }
        for (std::uint32_t i = 0; i < step.size.words; ++i) {
            m.Words(step.result.words + i)[lane] = m.Words(target.place.words + words + i)[lane];
        }
    });
}

template <typename N>
void StoreOutput(Machine<N>& m, const Step& step) {
    const auto& outputs = m.rows->outputs;
    const auto& exact = m.rows->exact;
    const Columns from = m.Operand(step, 0);
    EachPlace(m, step, outputs.size(), [&](std::uint32_t lane, std::uint32_t place) {
        outputs[place] = step.size.floats != 0 ? Ops<N>::ToBits(m.Floats(from.floats)[lane])
                                               : m.Words(from.words)[lane];
        if (!exact.empty()) {
            exact[place] =
                step.extra != kNone ? m.Floats(step.extra)[lane] : Ops<N>::FromBits(outputs[place]);
        }
    });
}

template <typename N>
void Store(Machine<N>& m, const Step& step) {
    if (m.plan->addresses[step.address].space == Address::Space::kOutputs) {
        return StoreOutput(m, step);
    }
    const Columns from = m.Operand(step, 0);
    const auto target = m.Resolve(step.address);
    if (target.offsets == kNone) {
        m.Copy(from, target.place, step.size);
        return;
    }
    EachOffset(m, step, target, [&](std::uint32_t lane, std::uint32_t floats, std::uint32_t words) {
        for (std::uint32_t i = 0; i < step.size.floats; ++i) {
            m.Floats(target.place.floats + floats + i)[lane] = m.Floats(from.floats + i)[lane];
        }
        for (std::uint32_t i = 0; i < step.size.words; ++i) {
            m.Words(target.place.words + words + i)[lane] = m.Words(from.words + i)[lane];
        }
    });
}

// The offsets of a chain with dynamic indices: two columns, from step.result on.
template <typename N>
void AccessChain(Machine<N>& m, const Step& step) {
    const auto base = m.Resolve(step.address);
    std::uint32_t* floats = m.Words(step.result.words);
    std::uint32_t* words = m.Words(step.result.words + 1);
    const std::uint32_t* base_floats = base.offsets == kNone ? nullptr : m.Words(base.offsets);
    const std::uint32_t* base_words = base.offsets == kNone ? nullptr : m.Words(base.offsets + 1);
    m.lanes.Each([&](std::uint32_t lane) {
        floats[lane] = base_floats == nullptr ? 0 : base_floats[lane];
        words[lane] = base_words == nullptr ? 0 : base_words[lane];
    });
    for (const Index& index : m.plan->chains[step.extra]) {
        const std::uint32_t* values = m.Words(index.column);
        if (index.count == kNone) {
            m.lanes.Each(
                [&](std::uint32_t lane) { words[lane] += values[lane] * index.stride.words; });
            continue;
        }
        m.lanes.Each([&](std::uint32_t lane) {
            std::uint32_t value = values[lane];
            if (value >= index.count) {
                m.Fail(lane, step,
                       "index " + std::to_string(static_cast<std::int32_t>(value)) +
                           " is outside of " + std::to_string(index.count) + " elements");
                value = 0;
            }
            floats[lane] += value * index.stride.floats;
            words[lane] += value * index.stride.words;
        });
    }
}

template <typename N>
void FunctionCall(Machine<N>& m, const Step& step) {
    const Call& call = m.plan->calls[step.extra];
    for (const Move& move : call.values) {
        m.Copy(move.from, move.to, move.size);
    }
    for (const Call::Pointer& pointer : call.pointers) {
        m.slots[pointer.slot] = m.Resolve(pointer.address);
    }
    RunFunction(m, call.function);
    m.Copy(call.result.from, call.result.to, call.result.size);
}

}  // namespace operation
}  // namespace etalon::evaluate
