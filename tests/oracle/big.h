// Numbers of 200 bits, the truth that the oracles are held against.
#pragma once

#include <mpfr.h>

namespace etalon::oracle {

class Big {
  public:
    Big(double value = 0) {
        mpfr_init2(value_, kBits);
        mpfr_set_d(value_, value, MPFR_RNDN);
    }
    Big(const Big& other) {
        mpfr_init2(value_, kBits);
        mpfr_set(value_, other.value_, MPFR_RNDN);
    }
    Big& operator=(const Big& other) {
        mpfr_set(value_, other.value_, MPFR_RNDN);
        return *this;
    }
    ~Big() { mpfr_clear(value_); }

    static Big Ln2() {
        Big result;
        mpfr_const_log2(result.value_, MPFR_RNDN);
        return result;
    }

    static Big Pi() {
        Big result;
        mpfr_const_pi(result.value_, MPFR_RNDN);
        return result;
    }

    double ToDouble() const { return mpfr_get_d(value_, MPFR_RNDN); }

    friend Big operator+(const Big& a, const Big& b) { return Apply(mpfr_add, a, b); }
    friend Big operator-(const Big& a, const Big& b) { return Apply(mpfr_sub, a, b); }
    friend Big operator*(const Big& a, const Big& b) { return Apply(mpfr_mul, a, b); }
    friend Big operator/(const Big& a, const Big& b) { return Apply(mpfr_div, a, b); }
    friend Big operator-(const Big& a) { return Big(0) - a; }
    friend bool operator<(const Big& a, const Big& b) { return mpfr_less_p(a.value_, b.value_); }
    friend bool operator==(const Big& a, const Big& b) { return mpfr_equal_p(a.value_, b.value_); }

    friend Big Sqrt(const Big& a) { return Apply(mpfr_sqrt, a); }
    friend Big Atan(const Big& a) { return Apply(mpfr_atan, a); }
    friend Big Expm1(const Big& a) { return Apply(mpfr_expm1, a); }
    friend Big Exp2(const Big& a) { return Apply(mpfr_exp2, a); }
    friend Big BesselJ1(const Big& a) { return Apply(mpfr_j1, a); }
    friend Big Sin(const Big& a) { return Apply(mpfr_sin, a); }
    friend Big Floor(const Big& a) {
        Big result;
        mpfr_floor(result.value_, a.value_);
        return result;
    }
    friend Big Abs(const Big& a) { return Apply(mpfr_abs, a); }

  private:
    static constexpr mpfr_prec_t kBits = 200;

    template <typename Operation>
    static Big Apply(Operation operation, const Big& a, const Big& b) {
        Big result;
        operation(result.value_, a.value_, b.value_, MPFR_RNDN);
        return result;
    }
    template <typename Operation>
    static Big Apply(Operation operation, const Big& a) {
        Big result;
        operation(result.value_, a.value_, MPFR_RNDN);
        return result;
    }

    mpfr_t value_;
};

}  // namespace etalon::oracle
