// fresnel_transmittance as shaders/optics has it, in C++, operation by operation: what the
// evaluator's speed is measured against. The reasons stand in the shaders.
#include "benchmark/fresnel_host.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace etalon {
namespace {

struct Wide {
    std::uint32_t x;
    std::uint32_t y;
};
struct Lights {
    float x;
    float y;
    float z;
    float w;
};

int SignedBits(float x) {
    return std::bit_cast<int>(x);
}
std::uint32_t Bits(float x) {
    return std::bit_cast<std::uint32_t>(x);
}
float Float(int x) {
    return std::bit_cast<float>(x);
}
float Float(std::uint32_t x) {
    return std::bit_cast<float>(x);
}
float Min(float a, float b) {
    return b < a ? b : a;
}
float Max(float a, float b) {
    return a < b ? b : a;
}

float Limit(float x, float low, float high) {
    return Float(std::clamp(SignedBits(x), SignedBits(low), SignedBits(high)));
}

float ClampIndex(float n) {
    return Limit(n, 1.0f / 1024.0f, 1024.0f);
}

Wide WideProduct(std::uint32_t a, std::uint32_t b) {
    std::uint32_t a_high = a >> 16;
    std::uint32_t a_low = a & 0xffffu;
    std::uint32_t b_high = b >> 16;
    std::uint32_t b_low = b & 0xffffu;
    std::uint32_t low = a_low * b_low;
    std::uint32_t middle = a_high * b_low + (low >> 16);
    std::uint32_t other = a_low * b_high + (middle & 0xffffu);
    return {a_high * b_high + (middle >> 16) + (other >> 16), (other << 16) | (low & 0xffffu)};
}

float ExactSquare(float n1, float n2, float c) {
    std::uint32_t bits1 = Bits(n1);
    std::uint32_t bits2 = Bits(n2);
    std::uint32_t bits_c = Bits(c);
    std::uint32_t shift = (bits1 >> 23) - (bits2 >> 23);
    std::uint32_t m1 = ((bits1 & 0x7fffffu) | 0x800000u) << shift;
    std::uint32_t m2 = (bits2 & 0x7fffffu) | 0x800000u;
    std::uint32_t mc = (bits_c & 0x7fffffu) | 0x800000u;
    std::uint32_t f = 127u - (bits_c >> 23);

    Wide p = WideProduct(m1, mc);
    Wide low = WideProduct(p.y, p.y);
    Wide cross_term = WideProduct(p.x, p.y);
    Wide high = WideProduct(p.x, p.x);
    std::uint32_t w0 = low.y;
    std::uint32_t w1 = low.x + (cross_term.y << 1);
    std::uint32_t carry = w1 < low.x ? 1u : 0u;
    std::uint32_t doubled = (cross_term.x << 1) | (cross_term.y >> 31);
    std::uint32_t w2 = high.y + doubled;
    std::uint32_t w3 = high.x + (w2 < doubled ? 1u : 0u);
    w2 += carry;
    w3 += w2 < carry ? 1u : 0u;

    Wide k = WideProduct(m1 - m2, m1 + m2);
    std::uint32_t k_high = (k.x << (2u * f)) | ((k.y >> 1) >> (31u - 2u * f));
    std::uint32_t k_low = k.y << (2u * f);
    std::uint32_t s1 = k_low << 14;
    std::uint32_t s2 = (k_high << 14) | (k_low >> 18);
    std::uint32_t s3 = k_high >> 18;
    bool borrow1 = w1 < s1;
    bool borrow2 = w2 < s2 || (w2 == s2 && borrow1);
    w1 -= s1;
    w2 -= s2 + (borrow1 ? 1u : 0u);
    w3 -= s3 + (borrow2 ? 1u : 0u);

    float sign_of = 1.0f;
    if ((w3 & 0x80000000u) != 0u) {
        sign_of = -1.0f;
        w0 = ~w0 + 1u;
        w1 = ~w1 + (w0 == 0u ? 1u : 0u);
        w2 = ~w2 + (w0 == 0u && w1 == 0u ? 1u : 0u);
        w3 = ~w3 + (w0 == 0u && w1 == 0u && w2 == 0u ? 1u : 0u);
    }
    int exponent = static_cast<int>(bits1 >> 23) - static_cast<int>(shift + f) - 141;

    if (w3 == 0u) {
        w3 = w2;
        w2 = w1;
        w1 = w0;
        exponent -= 16;
    }
    if (w3 == 0u) {
        w3 = w2;
        w2 = w1;
        exponent -= 16;
    }

    float unit = Float(static_cast<std::uint32_t>(exponent + 127) << 23);
    return sign_of *
           (((static_cast<float>(w3) * 4294967296.0f + static_cast<float>(w2)) * unit) * unit);
}

float TransmittedSquare(float n1, float n2, float c) {
    if (n1 <= n2) {
        float x = n1 * c;
        return (n2 - n1) * (n2 + n1) + x * x;
    }
    float n2_square = n2 * n2;
    float square = n2_square - n1 * (n1 * ((1.0f - c) * (1.0f + c)));
    if (square > 0.5f * n2_square || square < -n2_square / 524288.0f || n1 > 32.0f * n2) {
        return square;
    }

    if (c < 1.0f / 4096.0f) {
        return (n2 - n1) * (n2 + n1);
    }
    return ExactSquare(n1, n2, c);
}

Lights Shares(float n1, float n2, float c, float g) {
    float excess = (n2 - n1) / n1;
    float ratio = n2 / n1;
    float ratio_squared = ratio * ratio;

    float s_sum = Max(c + g, 1.0f / 1073741824.0f);
    float p_sum = Max(g + ratio_squared * c, 1.0f / 1125899906842624.0f);
    float s_squared = s_sum * s_sum;
    float along = c * g;
    float across = (1.0f - c) * (1.0f + c);

    float s_amplitude = excess * (2.0f + excess) / s_squared;

    float least = Min(along, across);
    float sum = along + across;
    float p_to_s = 4.0f * least < sum ? 1.0f - 2.0f * least / sum : (along - across) / sum;
    float s_reflected = s_amplitude * s_amplitude;
    float p_reflected = s_reflected * (p_to_s * p_to_s);

    float s_transmitted = Min(c * (4.0f * g / s_squared), 1.0f);
    float p_transmitted = Min(c * (4.0f * g * ratio_squared / (p_sum * p_sum)), 1.0f);

    if (s_reflected < 0.5f) {
        s_transmitted = 1.0f - s_reflected;
    } else {
        s_reflected = 1.0f - s_transmitted;
    }
    if (p_reflected < 0.5f) {
        p_transmitted = 1.0f - p_reflected;
    } else {
        p_reflected = 1.0f - p_transmitted;
    }
    return {s_reflected, p_reflected, s_transmitted, p_transmitted};
}

float IntoDenser(float n1, float n2, float c) {
    float excess = (n2 - n1) / n1;
    return std::sqrt(excess * (2.0f + excess) + c * c);
}

Lights Fresnel(float n1, float n2, float cos_i) {
    n1 = ClampIndex(n1);
    n2 = ClampIndex(n2);
    cos_i = Limit(cos_i, 0.0f, 1.0f);
    float g = 0;
    if (n1 <= n2) {
        g = IntoDenser(n1, n2, cos_i);
    } else {
        float square = TransmittedSquare(n1, n2, cos_i);
        if (square < 0.0f) {
            return {1.0f, 1.0f, 0.0f, 0.0f};
        }
        g = std::sqrt(square) / n1;
    }
    return Shares(n1, n2, cos_i, g);
}

float Transmittance(float n1, float n2, float cos_i) {
    Lights shares = Fresnel(n1, n2, cos_i);
    return 0.5f * (shares.z + shares.w);
}

}  // namespace

float FresnelTransmittance(float n1, float n2, float cos_i) {
    return Transmittance(n1, n2, cos_i);
}

}  // namespace etalon
