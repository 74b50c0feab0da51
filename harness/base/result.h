// Result<T>: a value, or the reason why there is none.
//
// Three channels are never mixed: a mistake of the user or of the environment travels as a Result;
// a mistake of the programmer stops the program (check.h); a wrong number from a shader is a
// verdict (judge).
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "base/check.h"

namespace etalon {

// A user's or the environment's mistake: one sentence, lower case, no full stop, location first
// ("fresnel.glsl:3: 'x' is not declared").
struct Error {
    std::string message;
};

template <typename T, typename E = Error>
class [[nodiscard]] Result {
  public:
    // Implicit on purpose: `return value;` and `return Error{...};` both read well.
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(E error) : state_(std::in_place_index<1>, std::move(error)) {}

    bool ok() const { return state_.index() == 0; }
    explicit operator bool() const { return ok(); }

    T& value() {
        ETALON_CHECK(ok());
        return std::get<0>(state_);
    }
    const T& value() const {
        ETALON_CHECK(ok());
        return std::get<0>(state_);
    }
    const E& error() const {
        ETALON_CHECK(!ok());
        return std::get<1>(state_);
    }
    T& operator*() { return value(); }
    const T& operator*() const { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

  private:
    std::variant<T, E> state_;
};

struct Nothing {};

// For a step that yields nothing but may fail: `return Ok();`.
template <typename E = Error>
using Status = Result<Nothing, E>;
inline Nothing Ok() {
    return {};
}

}  // namespace etalon

// Evaluates a Result; on failure returns its error from the enclosing function, else names the
// value.
#define ETALON_CONCAT_(a, b) a##b
#define ETALON_CONCAT(a, b) ETALON_CONCAT_(a, b)
#define ETALON_TRY(name, expression)                                                           \
    auto ETALON_CONCAT(result_, __LINE__) = (expression);                                      \
    if (!ETALON_CONCAT(result_, __LINE__)) {                                                   \
        return ETALON_CONCAT(result_, __LINE__).error();                                       \
    }                                                                                          \
    /* NOLINTNEXTLINE(bugprone-macro-parentheses): a declarator cannot stand in parentheses */ \
    auto& name = *ETALON_CONCAT(result_, __LINE__)

// As above for a step without a value.
#define ETALON_TRY_STEP(expression)            \
    do {                                       \
        if (auto step = (expression); !step) { \
            return step.error();               \
        }                                      \
    } while (false)
