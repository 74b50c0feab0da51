// GLSL.std.450 of vectors and matrices: the formulas of the specification, each operation rounded.
#pragma once

#include <spirv/unified1/GLSL.std.450.h>

#include <array>

#include "evaluate/glsl_scalar.h"
#include "evaluate/machine.h"
#include "evaluate/number.h"

namespace etalon::evaluate::glsl {

inline constexpr std::uint32_t kMostRows = 4;

// A vector, or a matrix column by column, of one lane.
template <typename N>
using Lane = std::array<N, std::size_t{kMostRows} * kMostRows>;

template <typename N>
void Take(Machine<N>& m, std::uint32_t column, std::uint32_t count, std::uint32_t lane,
          Lane<N>& out) {
    for (std::uint32_t i = 0; i < count; ++i) {
        out[i] = m.Floats(column + i)[lane];
    }
}

template <typename N>
N DotOf(const Lane<N>& a, const Lane<N>& b, std::uint32_t count) {
    using O = Ops<N>;
    N sum = O::Mul(a[0], b[0]);
    for (std::uint32_t i = 1; i < count; ++i) {
        sum = O::Add(sum, O::Mul(a[i], b[i]));
    }
    return sum;
}

// Of one component: its magnitude, which no product overflows.
template <typename N>
N LengthOf(const Lane<N>& a, std::uint32_t count) {
    return count == 1 ? Ops<N>::Abs(a[0]) : Ops<N>::Sqrt(DotOf(a, a, count));
}

// Calls f(lane, operands...) and stores the first `components` of its result.
template <typename N, typename F>
void EachLane(Machine<N>& m, const evaluate::Step& step, std::uint32_t count, F f) {
    std::array<Lane<N>, 3> operands{};
    m.lanes.Each([&](std::uint32_t lane) {
        for (std::uint32_t i = 0; i < step.operands && i < operands.size(); ++i) {
            // The last operand of Refract is a scalar; what is read beyond it is not used.
            const bool is_scalar = i == 2 && step.code == kGlslCode + GLSLstd450Refract;
            Take(m, m.Operand(step, i).floats, is_scalar ? 1 : count, lane, operands[i]);
        }
        const Lane<N> result = f(operands[0], operands[1], operands[2]);
        for (std::uint32_t i = 0; i < step.components; ++i) {
            m.Floats(step.result.floats + i)[lane] = result[i];
        }
    });
}

template <typename N>
void Length(Machine<N>& m, const evaluate::Step& step) {
    const std::uint32_t count = step.extra;
    EachLane(m, step, count, [&](const Lane<N>& a, const Lane<N>&, const Lane<N>&) {
        return Lane<N>{LengthOf(a, count)};
    });
}
template <typename N>
void Distance(Machine<N>& m, const evaluate::Step& step) {
    const std::uint32_t count = step.extra;
    EachLane(m, step, count, [&](const Lane<N>& a, const Lane<N>& b, const Lane<N>&) {
        Lane<N> way{};
        for (std::uint32_t i = 0; i < count; ++i) {
            way[i] = Ops<N>::Sub(a[i], b[i]);
        }
        return Lane<N>{LengthOf(way, count)};
    });
}
template <typename N>
void Cross(Machine<N>& m, const evaluate::Step& step) {
    using O = Ops<N>;
    EachLane(m, step, 3, [](const Lane<N>& a, const Lane<N>& b, const Lane<N>&) {
        return Lane<N>{O::Sub(O::Mul(a[1], b[2]), O::Mul(b[1], a[2])),
                       O::Sub(O::Mul(a[2], b[0]), O::Mul(b[2], a[0])),
                       O::Sub(O::Mul(a[0], b[1]), O::Mul(b[0], a[1]))};
    });
}
template <typename N>
void Normalize(Machine<N>& m, const evaluate::Step& step) {
    EachLane(m, step, step.components, [&](const Lane<N>& a, const Lane<N>&, const Lane<N>&) {
        const N length = LengthOf(a, step.components);
        Lane<N> result{};
        for (std::uint32_t i = 0; i < step.components; ++i) {
            result[i] = Ops<N>::Div(a[i], length);
        }
        return result;
    });
}
template <typename N>
void FaceForward(Machine<N>& m, const evaluate::Step& step) {
    using O = Ops<N>;
    EachLane(m, step, step.components, [&](const Lane<N>& n, const Lane<N>& i, const Lane<N>& to) {
        const bool keeps = O::Less(DotOf(to, i, step.components), Zero<N>());
        Lane<N> result{};
        for (std::uint32_t k = 0; k < step.components; ++k) {
            result[k] = keeps ? n[k] : O::Neg(n[k]);
        }
        return result;
    });
}
template <typename N>
void Reflect(Machine<N>& m, const evaluate::Step& step) {
    using O = Ops<N>;
    EachLane(m, step, step.components, [&](const Lane<N>& i, const Lane<N>& n, const Lane<N>&) {
        const N twice = O::Mul(O::FromBits(kTwoBits), DotOf(n, i, step.components));
        Lane<N> result{};
        for (std::uint32_t k = 0; k < step.components; ++k) {
            result[k] = O::Sub(i[k], O::Mul(twice, n[k]));
        }
        return result;
    });
}
template <typename N>
void Refract(Machine<N>& m, const evaluate::Step& step) {
    using O = Ops<N>;
    EachLane(m, step, step.components,
             [&](const Lane<N>& i, const Lane<N>& n, const Lane<N>& ratio) {
                 const N eta = ratio[0];
                 const N cosine = DotOf(n, i, step.components);
                 const N k = O::Sub(
                     One<N>(), O::Mul(O::Mul(eta, eta), O::Sub(One<N>(), O::Mul(cosine, cosine))));
                 Lane<N> result{};
                 if (O::Less(k, Zero<N>())) {
                     result.fill(Zero<N>());
                     return result;
                 }
                 const N along = O::Add(O::Mul(eta, cosine), O::Sqrt(k));
                 for (std::uint32_t c = 0; c < step.components; ++c) {
                     result[c] = O::Sub(O::Mul(eta, i[c]), O::Mul(along, n[c]));
                 }
                 return result;
             });
}

// By the first row, with the signs in turn.
template <typename N>
N DeterminantOf(const Lane<N>& a, std::uint32_t rows) {
    using O = Ops<N>;
    if (rows == 1) {
        return a[0];
    }
    N sum = Zero<N>();
    for (std::uint32_t column = 0; column < rows; ++column) {
        Lane<N> minor{};
        std::uint32_t at = 0;
        for (std::uint32_t i = 0; i < rows * rows; ++i) {
            if (i / rows != column && i % rows != 0) {
                minor[at++] = a[i];
            }
        }
        const N term = O::Mul(a[column * rows], DeterminantOf(minor, rows - 1));
        sum = column == 0 ? term : column % 2 == 0 ? O::Add(sum, term) : O::Sub(sum, term);
    }
    return sum;
}
template <typename N>
void Determinant(Machine<N>& m, const evaluate::Step& step) {
    const std::uint32_t rows = step.extra;
    EachLane(m, step, rows * rows, [&](const Lane<N>& a, const Lane<N>&, const Lane<N>&) {
        return Lane<N>{DeterminantOf(a, rows)};
    });
}
// The adjugate by the determinant.
template <typename N>
void MatrixInverse(Machine<N>& m, const evaluate::Step& step) {
    using O = Ops<N>;
    const std::uint32_t rows = step.extra;
    EachLane(m, step, rows * rows, [&](const Lane<N>& a, const Lane<N>&, const Lane<N>&) {
        const N whole = DeterminantOf(a, rows);
        Lane<N> result{};
        for (std::uint32_t place = 0; place < rows * rows; ++place) {
            // Without the row that is this place's column, and the column that is its row.
            const std::uint32_t row = place / rows;
            const std::uint32_t column = place % rows;
            Lane<N> minor{};
            std::uint32_t at = 0;
            for (std::uint32_t i = 0; i < rows * rows; ++i) {
                if (i / rows != column && i % rows != row) {
                    minor[at++] = a[i];
                }
            }
            const N cofactor = DeterminantOf(minor, rows - 1);
            result[place] = O::Div((row + column) % 2 == 0 ? cofactor : O::Neg(cofactor), whole);
        }
        return result;
    });
}

}  // namespace etalon::evaluate::glsl
