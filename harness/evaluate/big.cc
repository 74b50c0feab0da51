#include "evaluate/big.h"

#include <mpfr.h>

#include "evaluate/run.h"

namespace etalon::evaluate {
namespace {

static_assert(sizeof(mp_limb_t) == sizeof(std::uint64_t));

// MPFR's view of a Big, whose digits it uses in place; what it writes is put back at the end.
class View {
  public:
    explicit View(Big& x) : big_(&x) { Open(x); }
    // Only read.
    explicit View(const Big& x) { Open(const_cast<Big&>(x)); }
    ~View() {
        if (big_ != nullptr) {
            big_->kind = mpfr_custom_get_kind(view_);
            big_->exponent = mpfr_regular_p(view_) != 0 ? mpfr_custom_get_exp(view_) : 0;
        }
    }
    View(const View&) = delete;
    View& operator=(const View&) = delete;
    operator mpfr_ptr() { return view_; }

  private:
    void Open(Big& x) {
        mpfr_custom_init_set(view_, x.kind, x.exponent, kBigBits, x.digits.data());
    }

    Big* big_ = nullptr;
    mpfr_t view_;
};

template <typename F>
Big Make(F f) {
    Big result;
    {
        View view(result);
        f(static_cast<mpfr_ptr>(view));
    }
    return result;
}

using Unary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using Binary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

Big Of(Unary function, const Big& x) {
    View a(x);
    return Make([&](mpfr_ptr result) { function(result, a, MPFR_RNDN); });
}
Big Of(Binary function, const Big& x, const Big& y) {
    View a(x);
    View b(y);
    return Make([&](mpfr_ptr result) { function(result, a, b, MPFR_RNDN); });
}

// Rounds to binary32 at once, subnormal numbers included: mpfr_get_flt rounds to 24 bits and then
// again where the result is subnormal.
float ToFloat(mpfr_srcptr x) {
    if (mpfr_regular_p(x) == 0) {
        return mpfr_get_flt(x, MPFR_RNDN);
    }
    constexpr mpfr_exp_t kLeastExponent = -148;  // of 2^-149 as 1/2 2^-148
    const mpfr_exp_t bits = mpfr_get_exp(x) - kLeastExponent + 1;
    if (bits >= 24) {
        return mpfr_get_flt(x, MPFR_RNDN);
    }
    // In units of the least subnormal number.
    mpfr_t units;
    mpfr_init2(units, kBigBits);
    mpfr_mul_2si(units, x, 149, MPFR_RNDN);
    mpfr_rint(units, units, MPFR_RNDN);
    const float whole = static_cast<float>(mpfr_get_d(units, MPFR_RNDN) * 0x1p-149);
    const float signed_zero = mpfr_signbit(x) != 0 ? -0.0f : 0.0f;
    mpfr_clear(units);
    return whole == 0 ? signed_zero : whole;
}

}  // namespace

Big::Big() : digits{}, exponent(0), kind(MPFR_ZERO_KIND) {}

double Big::ToDouble() const {
    View view(*this);
    return mpfr_get_d(view, MPFR_RNDN);
}
Big Big::FromDouble(double x) {
    return Make([&](mpfr_ptr result) { mpfr_set_d(result, x, MPFR_RNDN); });
}

using O = Ops<Big>;

Big O::FromBits(std::uint32_t bits) {
    return Big::FromDouble(static_cast<double>(std::bit_cast<float>(bits)));
}
std::uint32_t O::ToBits(const Big& x) {
    View view(x);
    return std::bit_cast<std::uint32_t>(ToFloat(view));
}
Big O::FromInt(std::int32_t x) {
    return Big::FromDouble(x);
}
Big O::FromUint(std::uint32_t x) {
    return Big::FromDouble(x);
}
std::int32_t O::ToInt(const Big& x) {
    View view(x);
    return HostOps<double>::ToInt(mpfr_get_d(view, MPFR_RNDZ));
}
std::uint32_t O::ToUint(const Big& x) {
    View view(x);
    return HostOps<double>::ToUint(mpfr_get_d(view, MPFR_RNDZ));
}
Big O::Add(const Big& a, const Big& b) {
    return Of(mpfr_add, a, b);
}
Big O::Sub(const Big& a, const Big& b) {
    return Of(mpfr_sub, a, b);
}
Big O::Mul(const Big& a, const Big& b) {
    return Of(mpfr_mul, a, b);
}
Big O::Div(const Big& a, const Big& b) {
    return Of(mpfr_div, a, b);
}
Big O::Fma(const Big& a, const Big& b, const Big& c) {
    View x(a);
    View y(b);
    View z(c);
    return Make([&](mpfr_ptr result) { mpfr_fma(result, x, y, z, MPFR_RNDN); });
}
Big O::Sqrt(const Big& x) {
    return Of(mpfr_sqrt, x);
}
Big O::Neg(const Big& x) {
    return Of(mpfr_neg, x);
}
Big O::Abs(const Big& x) {
    View view(x);
    return Make([&](mpfr_ptr result) { mpfr_abs(result, view, MPFR_RNDN); });
}
Big O::Floor(const Big& x) {
    View view(x);
    return Make([&](mpfr_ptr result) { mpfr_rint(result, view, MPFR_RNDD); });
}
Big O::Ceil(const Big& x) {
    View view(x);
    return Make([&](mpfr_ptr result) { mpfr_rint(result, view, MPFR_RNDU); });
}
Big O::Trunc(const Big& x) {
    View view(x);
    return Make([&](mpfr_ptr result) { mpfr_rint(result, view, MPFR_RNDZ); });
}
Big O::RoundEven(const Big& x) {
    return Of(mpfr_rint, x);
}
Big O::Rem(const Big& a, const Big& b) {
    return Of(mpfr_fmod, a, b);
}
Big O::Ldexp(const Big& x, std::int32_t exponent) {
    View view(x);
    return Make([&](mpfr_ptr result) { mpfr_mul_2si(result, view, exponent, MPFR_RNDN); });
}
Big O::Frexp(const Big& x, std::int32_t& exponent) {
    View view(x);
    exponent = 0;
    if (mpfr_regular_p(static_cast<mpfr_ptr>(view)) == 0) {
        return x;
    }
    exponent = static_cast<std::int32_t>(mpfr_get_exp(static_cast<mpfr_ptr>(view)));
    return Ldexp(x, -exponent);
}
bool O::Less(const Big& a, const Big& b) {
    View x(a);
    View y(b);
    return mpfr_less_p(x, y) != 0;
}
bool O::LessEqual(const Big& a, const Big& b) {
    View x(a);
    View y(b);
    return mpfr_lessequal_p(x, y) != 0;
}
bool O::Equal(const Big& a, const Big& b) {
    View x(a);
    View y(b);
    return mpfr_equal_p(x, y) != 0;
}
bool O::IsNan(const Big& x) {
    View view(x);
    return mpfr_nan_p(static_cast<mpfr_ptr>(view)) != 0;
}
bool O::IsInf(const Big& x) {
    View view(x);
    return mpfr_inf_p(static_cast<mpfr_ptr>(view)) != 0;
}
bool O::IsNegative(const Big& x) {
    View view(x);
    return mpfr_signbit(static_cast<mpfr_ptr>(view)) != 0;
}
// MPFR's own gives +inf for -0, the quotient -inf, as the host does.
Big O::InverseSqrt(const Big& x) {
    return Div(FromInt(1), Sqrt(x));
}
Big O::Sin(const Big& x) {
    return Of(mpfr_sin, x);
}
Big O::Cos(const Big& x) {
    return Of(mpfr_cos, x);
}
Big O::Tan(const Big& x) {
    return Of(mpfr_tan, x);
}
Big O::Asin(const Big& x) {
    return Of(mpfr_asin, x);
}
Big O::Acos(const Big& x) {
    return Of(mpfr_acos, x);
}
Big O::Atan(const Big& x) {
    return Of(mpfr_atan, x);
}
Big O::Atan2(const Big& y, const Big& x) {
    return Of(mpfr_atan2, y, x);
}
Big O::Sinh(const Big& x) {
    return Of(mpfr_sinh, x);
}
Big O::Cosh(const Big& x) {
    return Of(mpfr_cosh, x);
}
Big O::Tanh(const Big& x) {
    return Of(mpfr_tanh, x);
}
Big O::Asinh(const Big& x) {
    return Of(mpfr_asinh, x);
}
Big O::Acosh(const Big& x) {
    return Of(mpfr_acosh, x);
}
Big O::Atanh(const Big& x) {
    return Of(mpfr_atanh, x);
}
Big O::Exp(const Big& x) {
    return Of(mpfr_exp, x);
}
Big O::Log(const Big& x) {
    return Of(mpfr_log, x);
}
Big O::Exp2(const Big& x) {
    return Of(mpfr_exp2, x);
}
Big O::Log2(const Big& x) {
    return Of(mpfr_log2, x);
}
Big O::Pow(const Big& x, const Big& y) {
    return Of(mpfr_pow, x, y);
}

template class Evaluator<Big>;

}  // namespace etalon::evaluate
