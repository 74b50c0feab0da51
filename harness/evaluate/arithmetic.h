// Arithmetic of numbers, products of vectors and matrices, conversions.
#pragma once

#include "evaluate/machine.h"
#include "evaluate/number.h"

namespace etalon::evaluate::operation {

template <typename N>
void FNegate(Machine<N>& m, const Step& step) {
    m.FloatsToFloats1(step, [](const N& a) { return Ops<N>::Neg(a); });
}
template <typename N>
void FAdd(Machine<N>& m, const Step& step) {
    m.FloatsToFloats2(step, [](const N& a, const N& b) { return Ops<N>::Add(a, b); });
}
template <typename N>
void FSub(Machine<N>& m, const Step& step) {
    m.FloatsToFloats2(step, [](const N& a, const N& b) { return Ops<N>::Sub(a, b); });
}
template <typename N>
void FMul(Machine<N>& m, const Step& step) {
    m.FloatsToFloats2(step, [](const N& a, const N& b) { return Ops<N>::Mul(a, b); });
}
template <typename N>
void FDiv(Machine<N>& m, const Step& step) {
    m.FloatsToFloats2(step, [](const N& a, const N& b) { return Ops<N>::Div(a, b); });
}
template <typename N>
void FRem(Machine<N>& m, const Step& step) {
    m.FloatsToFloats2(step, [](const N& a, const N& b) { return Ops<N>::Rem(a, b); });
}
// GLSL's mod: x - y floor(x / y), each operation rounded.
template <typename N>
void FMod(Machine<N>& m, const Step& step) {
    using O = Ops<N>;
    m.FloatsToFloats2(
        step, [](const N& a, const N& b) { return O::Sub(a, O::Mul(b, O::Floor(O::Div(a, b)))); });
}

// result += a b, or a b where it is the first product.
template <typename N>
void AddProduct(Machine<N>& m, std::uint32_t a, std::uint32_t b, std::uint32_t result,
                bool is_first) {
    using O = Ops<N>;
    const N* left = m.Floats(a);
    const N* right = m.Floats(b);
    N* sum = m.Floats(result);
    if (is_first) {
        m.lanes.Each([&](std::uint32_t lane) { sum[lane] = O::Mul(left[lane], right[lane]); });
    } else {
        m.lanes.Each([&](std::uint32_t lane) {
            sum[lane] = O::Add(sum[lane], O::Mul(left[lane], right[lane]));
        });
    }
}

template <typename N>
void VectorTimesScalar(Machine<N>& m, const Step& step) {
    for (std::uint32_t i = 0; i < step.components; ++i) {
        AddProduct(m, m.Operand(step, 0).floats + i, m.Operand(step, 1).floats,
                   step.result.floats + i, true);
    }
}
template <typename N>
void MatrixTimesScalar(Machine<N>& m, const Step& step) {
    VectorTimesScalar(m, step);
}
template <typename N>
void Dot(Machine<N>& m, const Step& step) {
    for (std::uint32_t i = 0; i < step.extra; ++i) {
        AddProduct(m, m.Operand(step, 0).floats + i, m.Operand(step, 1).floats + i,
                   step.result.floats, i == 0);
    }
}
template <typename N>
void VectorTimesMatrix(Machine<N>& m, const Step& step) {
    for (std::uint32_t column = 0; column < step.components; ++column) {
        for (std::uint32_t row = 0; row < step.extra; ++row) {
            AddProduct(m, m.Operand(step, 0).floats + row,
                       m.Operand(step, 1).floats + column * step.extra + row,
                       step.result.floats + column, row == 0);
        }
    }
}
template <typename N>
void MatrixTimesMatrix(Machine<N>& m, const Step& step) {
    const std::uint32_t inner = m.Literal(step, 0);
    const std::uint32_t rows = m.Literal(step, 1);
    for (std::uint32_t i = 0; i < step.components; ++i) {
        for (std::uint32_t k = 0; k < inner; ++k) {
            AddProduct(m, m.Operand(step, 0).floats + k * rows + i % rows,
                       m.Operand(step, 1).floats + i / rows * inner + k, step.result.floats + i,
                       k == 0);
        }
    }
}
template <typename N>
void MatrixTimesVector(Machine<N>& m, const Step& step) {
    MatrixTimesMatrix(m, step);
}
template <typename N>
void OuterProduct(Machine<N>& m, const Step& step) {
    for (std::uint32_t i = 0; i < step.components; ++i) {
        AddProduct(m, m.Operand(step, 0).floats + i % step.extra,
                   m.Operand(step, 1).floats + i / step.extra, step.result.floats + i, true);
    }
}
template <typename N>
void Transpose(Machine<N>& m, const Step& step) {
    const std::uint32_t columns = m.Literal(step, 0);
    const std::uint32_t rows = m.Literal(step, 1);
    for (std::uint32_t i = 0; i < step.components; ++i) {
        m.Copy({m.Operand(step, 0).floats + i % columns * rows + i / columns, 0},
               {step.result.floats + i, 0}, {1, 0});
    }
}

template <typename N>
void ConvertFToU(Machine<N>& m, const Step& step) {
    m.FloatsToWords1(step, [](const N& a) { return Ops<N>::ToUint(a); });
}
template <typename N>
void ConvertFToS(Machine<N>& m, const Step& step) {
    m.FloatsToWords1(step, [](const N& a) { return static_cast<std::uint32_t>(Ops<N>::ToInt(a)); });
}
template <typename N>
void ConvertSToF(Machine<N>& m, const Step& step) {
    m.WordsToFloats1(step,
                     [](std::uint32_t a) { return Ops<N>::FromInt(static_cast<std::int32_t>(a)); });
}
template <typename N>
void ConvertUToF(Machine<N>& m, const Step& step) {
    m.WordsToFloats1(step, [](std::uint32_t a) { return Ops<N>::FromUint(a); });
}
template <typename N>
void Bitcast(Machine<N>& m, const Step& step) {
    if (step.size.floats == 0 && step.extra != 0) {
        m.FloatsToWords1(step, [](const N& a) { return Ops<N>::ToBits(a); });
    } else if (step.size.floats == 0) {
        m.WordsToWords1(step, [](std::uint32_t a) { return a; });
    } else if (step.extra == 0) {
        m.WordsToFloats1(step, [](std::uint32_t a) { return Ops<N>::FromBits(a); });
    } else {
        m.FloatsToFloats1(step, [](const N& a) { return a; });
    }
}

}  // namespace etalon::evaluate::operation
