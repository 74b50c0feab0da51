// Machine: what the operations of one evaluation work on. The families' headers (arithmetic.h,
// integer.h, ...) hold a function for each instruction; run.h drives them.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "evaluate/evaluate.h"
#include "evaluate/number.h"
#include "evaluate/plan.h"

// No lane reads what another one writes. Clang finds out at run time.
#if defined(__clang__)
#define ETALON_LANES
#else
#define ETALON_LANES _Pragma("GCC ivdep")
#endif

namespace etalon::evaluate {

inline constexpr std::uint32_t kLanes = 128;

// A set of lanes.
class Mask {
  public:
    void Add(std::uint32_t lane) { words_[lane / 64] |= std::uint64_t{1} << lane % 64; }
    void Add(const Mask& more) {
        for (std::size_t i = 0; i < words_.size(); ++i) {
            words_[i] |= more.words_[i];
        }
    }
    void Remove(const Mask& less) {
        for (std::size_t i = 0; i < words_.size(); ++i) {
            words_[i] &= ~less.words_[i];
        }
    }
    bool IsEmpty() const {
        std::uint64_t any = 0;
        for (const std::uint64_t word : words_) {
            any |= word;
        }
        return any == 0;
    }
    bool Has(std::uint32_t lane) const { return (words_[lane / 64] >> lane % 64 & 1) != 0; }
    void Keep(const Mask& others) {
        for (std::size_t i = 0; i < words_.size(); ++i) {
            words_[i] &= others.words_[i];
        }
    }
    bool operator==(const Mask&) const = default;
    template <typename F>
    void Each(F&& f) const {
        for (std::size_t i = 0; i < words_.size(); ++i) {
            for (std::uint64_t rest = words_[i]; rest != 0; rest &= rest - 1) {
                f(static_cast<std::uint32_t>(i * 64) +
                  static_cast<std::uint32_t>(std::countr_zero(rest)));
            }
        }
    }
    static Mask First(std::uint32_t count) {
        Mask mask;
        for (std::uint32_t lane = 0; lane < count; ++lane) {
            mask.Add(lane);
        }
        return mask;
    }

  private:
    std::array<std::uint64_t, kLanes / 64> words_{};
};

// The lanes that an operation works on: the first `count`, or those in `index`.
struct Lanes {
    Mask mask;
    std::uint32_t count = 0;
    bool is_dense = true;
    std::array<std::uint16_t, kLanes> index;

    void Set(const Mask& set) {
        mask = set;
        count = 0;
        set.Each([&](std::uint32_t lane) { index[count++] = static_cast<std::uint16_t>(lane); });
        is_dense = count == 0 || index[count - 1] == count - 1;
    }
    template <typename F>
    void Each(F&& f) const {
        if (is_dense) {
            ETALON_LANES
            for (std::uint32_t lane = 0; lane < count; ++lane) {
                f(lane);
            }
        } else {
            for (std::uint32_t i = 0; i < count; ++i) {
                f(std::uint32_t{index[i]});
            }
        }
    }
};

// What a number type needs beside its values.
template <typename Number>
struct Context {};

template <typename Number>
struct Machine {
    // Where a pointer leads at run time.
    struct Target {
        Columns place;
        std::uint32_t offsets = kNone;
    };

    std::shared_ptr<const Plan> plan;
    std::vector<Texture> images;
    Limits limits;
    std::vector<Number> floats;
    std::vector<std::uint32_t> words;
    std::vector<Target> slots;
    std::array<std::uint32_t, kLanes> spent{};
    Lanes lanes;
    Mask killed;
    std::uint32_t first_row = 0;
    std::uint32_t running = 0;  // the function that runs
    const Rows<Number>* rows = nullptr;
    std::string failure;  // the first, empty for none
    [[no_unique_address]] Context<Number> context;

    // Takes the plan: columns for all that it names, constants in theirs.
    void Prepare(std::shared_ptr<const Plan> taken) {
        plan = std::move(taken);
        slots.resize(plan->slots);
        floats.resize(std::size_t{plan->columns.floats} * kLanes, Ops<Number>::FromBits(0));
        words.resize(std::size_t{plan->columns.words} * kLanes);
        for (const Constant& constant : plan->constants) {
            for (std::uint32_t i = 0; i < constant.floats.size(); ++i) {
                std::fill_n(Floats(constant.place.floats + i), kLanes,
                            Ops<Number>::FromBits(constant.floats[i]));
            }
            for (std::uint32_t i = 0; i < constant.words.size(); ++i) {
                std::fill_n(Words(constant.place.words + i), kLanes, constant.words[i]);
            }
        }
    }

    // The next group of lanes, by their rows.
    void Start(std::span<const std::uint32_t> rows_of_lanes) {
        killed = Mask{};
        spent.fill(0);
        lanes.Set(Mask::First(static_cast<std::uint32_t>(rows_of_lanes.size())));
        for (const std::uint32_t column : plan->row_columns) {
            std::uint32_t* row = Words(column);
            std::fill_n(row, 3 * kLanes, 0);
            std::copy(rows_of_lanes.begin(), rows_of_lanes.end(), row);
        }
    }

    Number* Floats(std::uint32_t column) { return floats.data() + std::size_t{column} * kLanes; }
    // Each lane at work has a single word there.
    std::uint32_t* Words(std::uint32_t column) {
        if constexpr (requires { context.Close(*this, column); }) {
            context.Close(*this, column);
        }
        return RawWords(column);
    }
    std::uint32_t* RawWords(std::uint32_t column) {
        return words.data() + std::size_t{column} * kLanes;
    }
    Columns Operand(const Step& step, std::size_t i) const {
        return plan->operands[step.first_operand + i];
    }
    std::uint32_t Literal(const Step& step, std::size_t i) const {
        return plan->literals[step.first_literal + i];
    }

    Target Resolve(std::uint32_t address) const {
        const Address& to = plan->addresses[address];
        Target target{to.place, to.offsets};
        if (to.slot != kNone) {
            target.place = target.place + slots[to.slot].place;
            target.offsets = to.offsets == kNone ? slots[to.slot].offsets : to.offsets;
        }
        return target;
    }

    void Fail(std::uint32_t lane, const Step& step, const std::string& reason) {
        if constexpr (requires { context.Lose(lane); }) {
            context.Lose(lane);
        } else if (failure.empty()) {
            failure = "row " + std::to_string(first_row + lane) + ": ";
            if (step.line != kNone) {
                const spirv::Line& line = plan->module.lines[step.line];
                failure += line.file + ":" + std::to_string(line.line) + ": ";
            }
            if (const std::string& name = plan->module.functions[running].name; !name.empty()) {
                failure += "in " + PlainName(name) + ": ";
            }
            failure += reason;
        }
    }

    void Copy(Columns from, Columns to, Columns size) {
        for (std::uint32_t i = 0; i < size.floats; ++i) {
            const Number* source = Floats(from.floats + i);
            Number* target = Floats(to.floats + i);
            lanes.Each([&](std::uint32_t lane) { target[lane] = source[lane]; });
        }
        for (std::uint32_t i = 0; i < size.words; ++i) {
            const std::uint32_t* source = RawWords(from.words + i);
            std::uint32_t* target = RawWords(to.words + i);
            lanes.Each([&](std::uint32_t lane) { target[lane] = source[lane]; });
            if constexpr (requires { context.CopyRange(*this, from.words, to.words); }) {
                context.CopyRange(*this, from.words + i, to.words + i);
            }
        }
    }

    // What most operations are: a function of numbers or words, lane by lane, for each component.
    // No result shares a column with an operand, so that large numbers are made where they stay.
    template <typename F>
    void FloatsToFloats1(const Step& step, F f) {
        for (std::uint32_t i = 0; i < step.components; ++i) {
            const Number* a = Floats(Operand(step, 0).floats + i);
            Number* result = Floats(step.result.floats + i);
            lanes.Each([&](std::uint32_t lane) { std::construct_at(&result[lane], f(a[lane])); });
        }
    }
    template <typename F>
    void FloatsToFloats2(const Step& step, F f) {
        for (std::uint32_t i = 0; i < step.components; ++i) {
            const Number* a = Floats(Operand(step, 0).floats + i);
            const Number* b = Floats(Operand(step, 1).floats + i);
            Number* result = Floats(step.result.floats + i);
            lanes.Each(
                [&](std::uint32_t lane) { std::construct_at(&result[lane], f(a[lane], b[lane])); });
        }
    }
    template <typename F>
    void FloatsToFloats3(const Step& step, F f) {
        for (std::uint32_t i = 0; i < step.components; ++i) {
            const Number* a = Floats(Operand(step, 0).floats + i);
            const Number* b = Floats(Operand(step, 1).floats + i);
            const Number* c = Floats(Operand(step, 2).floats + i);
            Number* result = Floats(step.result.floats + i);
            lanes.Each([&](std::uint32_t lane) {
                std::construct_at(&result[lane], f(a[lane], b[lane], c[lane]));
            });
        }
    }
    template <typename F>
    void FloatsToWords1(const Step& step, F f) {
        for (std::uint32_t i = 0; i < step.components; ++i) {
            const Number* a = Floats(Operand(step, 0).floats + i);
            std::uint32_t* result = Words(step.result.words + i);
            lanes.Each([&](std::uint32_t lane) { result[lane] = f(a[lane]); });
        }
    }
    template <typename F>
    void FloatsToWords2(const Step& step, F f) {
        for (std::uint32_t i = 0; i < step.components; ++i) {
            const Number* a = Floats(Operand(step, 0).floats + i);
            const Number* b = Floats(Operand(step, 1).floats + i);
            std::uint32_t* result = Words(step.result.words + i);
            lanes.Each([&](std::uint32_t lane) { result[lane] = f(a[lane], b[lane]); });
        }
    }
    template <typename F>
    void WordsToFloats1(const Step& step, F f) {
        for (std::uint32_t i = 0; i < step.components; ++i) {
            const std::uint32_t* a = Words(Operand(step, 0).words + i);
            Number* result = Floats(step.result.floats + i);
            lanes.Each([&](std::uint32_t lane) { result[lane] = f(a[lane]); });
        }
    }
    template <typename F>
    void WordsToWords1(const Step& step, F f) {
        for (std::uint32_t i = 0; i < step.components; ++i) {
            const std::uint32_t* a = Words(Operand(step, 0).words + i);
            std::uint32_t* result = Words(step.result.words + i);
            lanes.Each([&](std::uint32_t lane) { result[lane] = f(a[lane]); });
        }
    }
    template <typename F>
    void WordsToWords2(const Step& step, F f) {
        for (std::uint32_t i = 0; i < step.components; ++i) {
            const std::uint32_t* a = Words(Operand(step, 0).words + i);
            const std::uint32_t* b = Words(Operand(step, 1).words + i);
            std::uint32_t* result = Words(step.result.words + i);
            lanes.Each([&](std::uint32_t lane) { result[lane] = f(a[lane], b[lane]); });
        }
    }
    template <typename F>
    void WordsToWords3(const Step& step, F f) {
        for (std::uint32_t i = 0; i < step.components; ++i) {
            const std::uint32_t* a = Words(Operand(step, 0).words + i);
            const std::uint32_t* b = Words(Operand(step, 1).words + i);
            const std::uint32_t* c = Words(Operand(step, 2).words + i);
            std::uint32_t* result = Words(step.result.words + i);
            lanes.Each([&](std::uint32_t lane) { result[lane] = f(a[lane], b[lane], c[lane]); });
        }
    }
};

}  // namespace etalon::evaluate
