#include "run/parting.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

#include "spirv/read.h"
#include "spirv/watch.h"

namespace etalon {
namespace {

// For the programs that watch some instructions each; so many where all are too many.
constexpr std::chrono::seconds kTimeForParts{10};
constexpr std::size_t kFew = 64;
constexpr std::uint32_t kMoreThanExpected = 64;

// A leaf that the trace expects.
struct Expected {
    std::uint32_t mark = 0;
    std::uint32_t word = 0;
    bool is_float = true;
    std::size_t step = 0;
    std::uint32_t leaf = 0;
};

struct Told {
    std::uint32_t mark = 0;
    std::uint32_t word = 0;
};

std::vector<Expected> Expectations(const spirv::Module& module, const evaluate::Trace& trace) {
    const std::vector<std::uint32_t> watchable = spirv::Watchable(module);
    std::vector<Expected> expected;
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
        const evaluate::TracedStep& step = trace.steps[i];
        const auto place =
            std::lower_bound(watchable.begin(), watchable.end(), step.instruction->word);
        const auto instruction = static_cast<std::uint32_t>(place - watchable.begin());
        std::uint32_t leaf = 0;
        for (const evaluate::TracedNumber& number : step.numbers) {
            expected.push_back({spirv::PackMark({instruction, leaf}),
                                std::bit_cast<std::uint32_t>(number.value), true, i, leaf});
            ++leaf;
        }
        for (const evaluate::TracedWord& word : step.words) {
            expected.push_back({spirv::PackMark({instruction, leaf}), word.value, false, i, leaf});
            ++leaf;
        }
    }
    return expected;
}

bool IsAlike(const Expected& expected, std::uint32_t word) {
    return expected.is_float ? IsSameFloat(expected.word, word) : expected.word == word;
}

class Search {
  public:
    Search(const Program& program, const spirv::Module& module,
           std::span<const std::uint32_t> plain, const Execute& execute)
        : program_(program), module_(module), plain_(plain), execute_(execute) {}

    // What the device tells of the chosen instructions. False where it cannot be run; `is_kept`
    // tells whether its outputs stayed as they are.
    bool Watch(std::span<const std::uint32_t> chosen, std::uint32_t most) {
        told_.clear();
        const spirv::WatchPlace place{program_.output_words, most};
        auto watched = spirv::Watch(program_.spirv, module_, place, chosen);
        if (!watched) {
            reason_ = watched.error().message;
            return false;
        }
        Program program = program_;
        program.spirv = std::move(*watched);
        program.output_words += place.Words();
        const auto outputs = execute_(program);
        if (!outputs) {
            reason_ = outputs.error().reason;
            return false;
        }
        is_kept_ = true;
        for (std::size_t i = 0; i < plain_.size(); ++i) {
            is_kept_ = is_kept_ &&
                       (plain_[i] == (*outputs)[i] || (IsNan(plain_[i]) && IsNan((*outputs)[i])));
        }
        const std::uint32_t count = std::min((*outputs)[place.first], most);
        for (std::uint32_t i = 0; i < count; ++i) {
            told_.push_back(
                {(*outputs)[place.first + 1 + 2 * i], (*outputs)[place.first + 2 + 2 * i]});
        }
        return true;
    }

    const std::vector<Told>& told() const { return told_; }
    bool is_kept() const { return is_kept_; }
    const std::string& reason() const { return reason_; }

  private:
    static bool IsNan(std::uint32_t word) { return std::isnan(std::bit_cast<float>(word)); }

    const Program& program_;
    const spirv::Module& module_;
    std::span<const std::uint32_t> plain_;
    const Execute& execute_;
    std::vector<Told> told_;
    bool is_kept_ = false;
    std::string reason_;
};

// The first place at which what is told is not what is expected.
Parting Compare(std::span<const Expected> expected, std::span<const Told> told) {
    Parting parting;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (i >= told.size() || told[i].mark != expected[i].mark) {
            parting.kind = Parting::Kind::kWay;
            parting.step = expected[i].step;
            return parting;
        }
        if (!IsAlike(expected[i], told[i].word)) {
            parting.kind = Parting::Kind::kOperation;
            parting.step = expected[i].step;
            parting.leaf = expected[i].leaf;
            parting.word = told[i].word;
            return parting;
        }
    }
    if (told.size() > expected.size() && !expected.empty()) {
        parting.kind = Parting::Kind::kWay;
        parting.step = expected.back().step;
    }
    return parting;
}

// Watches `size` instructions at a time, in the order of the path.
Parting WatchParts(Search& search, const std::vector<Expected>& expected, std::size_t size) {
    std::vector<std::uint32_t> order;
    for (const Expected& one : expected) {
        const std::uint32_t instruction = spirv::UnpackMark(one.mark).instruction;
        if (std::find(order.begin(), order.end(), instruction) == order.end()) {
            order.push_back(instruction);
        }
    }
    Parting first;
    first.kind = Parting::Kind::kUnseen;
    const auto start = std::chrono::steady_clock::now();
    std::size_t tried = 0;
    while (tried < order.size() && std::chrono::steady_clock::now() - start < kTimeForParts) {
        const std::size_t count = std::min(size, order.size() - tried);
        std::vector<std::uint32_t> chosen(
            order.begin() + static_cast<std::ptrdiff_t>(tried),
            order.begin() + static_cast<std::ptrdiff_t>(tried + count));
        std::sort(chosen.begin(), chosen.end());
        std::vector<Expected> own;
        for (const Expected& one : expected) {
            const std::uint32_t instruction = spirv::UnpackMark(one.mark).instruction;
            if (std::binary_search(chosen.begin(), chosen.end(), instruction)) {
                own.push_back(one);
            }
        }
        // What comes later on the path than a difference that is known is of no interest.
        if (first.kind != Parting::Kind::kUnseen && own.front().step > first.step) {
            break;
        }
        tried += count;
        const auto most = static_cast<std::uint32_t>(own.size()) + kMoreThanExpected;
        if (!search.Watch(chosen, most) || !search.is_kept()) {
            continue;
        }
        const Parting one = Compare(own, search.told());
        if (one.kind != Parting::Kind::kNowhere &&
            (first.kind == Parting::Kind::kUnseen || one.step < first.step)) {
            first = one;
        }
    }
    first.is_in_parts = true;
    first.tried = tried;
    first.instructions = order.size();
    return first;
}

}  // namespace

bool IsSameFloat(std::uint32_t a, std::uint32_t b) {
    const auto left = std::bit_cast<float>(a);
    const auto right = std::bit_cast<float>(b);
    return left == right || (std::isnan(left) && std::isnan(right));
}

Parting FindParting(const Program& program, const spirv::Module& traced,
                    const evaluate::Trace& trace, std::span<const std::uint32_t> plain,
                    const Execute& execute) {
    Parting parting;
    parting.kind = Parting::Kind::kFailed;
    const Result<spirv::Module> module = spirv::ReadModule(program.spirv);
    if (!module) {
        parting.reason = module.error().message;
        return parting;
    }
    const std::vector<std::uint32_t> watchable = spirv::Watchable(*module);
    if (watchable.size() != spirv::Watchable(traced).size()) {
        parting.reason = "its program has other operations than the one that is traced";
        return parting;
    }
    const std::vector<Expected> expected = Expectations(traced, trace);
    std::vector<std::uint32_t> all(watchable.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        all[i] = i;
    }
    Search search(program, *module, plain, execute);
    // A path that is cut is watched as far as it is known.
    const auto most =
        static_cast<std::uint32_t>(expected.size()) + (trace.is_cut ? 0 : kMoreThanExpected);
    if (!search.Watch(all, most)) {
        const std::string reason = search.reason();
        if (all.size() > kFew) {
            parting = WatchParts(search, expected, kFew);
        }
        parting.reason = reason;
        return parting;
    }
    return search.is_kept() ? Compare(expected, search.told()) : WatchParts(search, expected, 1);
}

}  // namespace etalon
