// Making and changing composites. Taking them apart costs nothing: a part is a range of columns.
#pragma once

#include "evaluate/machine.h"

namespace etalon::evaluate::operation {

// Calls f(lane, index) where the index is within the vector; elsewhere it notes an error.
template <typename N, typename F>
void EachIndex(Machine<N>& m, const Step& step, std::uint32_t column, std::uint32_t count, F f) {
    const std::uint32_t* index = m.Words(column);
    m.lanes.Each([&](std::uint32_t lane) {
        if (index[lane] >= count) {
            m.Fail(lane, step,
                   "index " + std::to_string(static_cast<std::int32_t>(index[lane])) +
                       " is outside of " + std::to_string(count) + " components");
            return;
        }
        f(lane, index[lane]);
    });
}

template <typename N>
void VectorExtractDynamic(Machine<N>& m, const Step& step) {
    const Columns from = m.Operand(step, 0);
    EachIndex(m, step, m.Operand(step, 1).words, step.extra,
              [&](std::uint32_t lane, std::uint32_t index) {
                  if (step.size.floats != 0) {
                      m.Floats(step.result.floats)[lane] = m.Floats(from.floats + index)[lane];
                  } else {
                      m.Words(step.result.words)[lane] = m.Words(from.words + index)[lane];
                  }
              });
}
template <typename N>
void VectorInsertDynamic(Machine<N>& m, const Step& step) {
    m.Copy(m.Operand(step, 0), step.result, step.size);
    const Columns from = m.Operand(step, 1);
    EachIndex(m, step, m.Operand(step, 2).words, step.components,
              [&](std::uint32_t lane, std::uint32_t index) {
                  if (step.size.floats != 0) {
                      m.Floats(step.result.floats + index)[lane] = m.Floats(from.floats)[lane];
                  } else {
                      m.Words(step.result.words + index)[lane] = m.Words(from.words)[lane];
                  }
              });
}
template <typename N>
void VectorShuffle(Machine<N>& m, const Step& step) {
    const Columns one = step.size.floats != 0 ? Columns{1, 0} : Columns{0, 1};
    for (std::uint32_t i = 0; i < step.literals; ++i) {
        const std::uint32_t index = m.Literal(step, i);
        const bool is_first = index < step.extra;
        m.Copy(m.Operand(step, is_first ? 0 : 1) + one * (is_first ? index : index - step.extra),
               step.result + one * i, one);
    }
}
// The operands' places, then their sizes.
template <typename N>
void CompositeConstruct(Machine<N>& m, const Step& step) {
    Columns to = step.result;
    const std::uint32_t parts = step.operands / 2;
    for (std::uint32_t i = 0; i < parts; ++i) {
        const Columns size = m.Operand(step, parts + i);
        m.Copy(m.Operand(step, i), to, size);
        to = to + size;
    }
}
// The part, the whole, where the part goes, its size.
template <typename N>
void CompositeInsert(Machine<N>& m, const Step& step) {
    m.Copy(m.Operand(step, 1), step.result, step.size);
    m.Copy(m.Operand(step, 0), step.result + m.Operand(step, 2), m.Operand(step, 3));
}

}  // namespace etalon::evaluate::operation
