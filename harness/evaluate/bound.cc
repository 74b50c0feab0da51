#include "evaluate/bound.h"

#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "evaluate/interval_context.h"
#include "evaluate/interval_glsl.h"
#include "evaluate/interval_image.h"
#include "evaluate/interval_integer.h"
#include "evaluate/interval_words.h"
#include "evaluate/run.h"

namespace etalon::evaluate {

std::uint32_t Context<Interval>::Decide(std::uint32_t lane, std::uint64_t alternatives) {
    // What is decided is no choice, in the first run of a way as in those that follow it.
    if (alternatives == 1 || lost.Has(lane)) {
        return 0;
    }
    Way& way = ways[lane];
    if (way.at < way.taken.size()) {
        return way.taken[way.at++];
    }
    if (alternatives > most_choices || way.taken.size() >= most_choices) {
        Lose(lane);
        return 0;
    }
    way.taken.push_back(0);
    way.alternatives.push_back(static_cast<std::uint8_t>(alternatives));
    ++way.at;
    return 0;
}

std::int64_t Context<Interval>::DecideInteger(std::uint32_t lane, double low, double high,
                                              double least, double most) {
    const double first = std::trunc(low);
    const double last = std::trunc(high);
    if (!(first >= least && last <= most)) {
        Lose(lane);
        return 0;
    }
    return static_cast<std::int64_t>(first) +
           Decide(lane, static_cast<std::uint64_t>(last - first) + 1);
}

void Context<Interval>::Store(std::size_t place, const Bound& bound) {
    Bound& hull = bounds[place];
    if (!is_stored[place]) {
        is_stored[place] = true;
        hull = bound;
        return;
    }
    const bool is_number = hull.kind == Bound::Kind::kNumber && bound.kind == Bound::Kind::kNumber;
    const bool is_word = hull.kind == Bound::Kind::kWord && bound.kind == Bound::Kind::kWord;
    if (is_number) {
        hull.low = std::min(hull.low, bound.low);
        hull.high = std::max(hull.high, bound.high);
        hull.quantum = std::min(hull.quantum, bound.quantum);
    } else if (!is_word || hull.word != bound.word) {
        hull = {};
    }
}

const TexelRange& Context<Interval>::RangeOf(const Image& image, std::uint32_t level) {
    const auto [found, is_new] = levels.try_emplace({&image, level});
    if (is_new) {
        found->second.fill(
            {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()});
        const std::size_t texels = LevelSize(image, level).texels() * FaceCount(image);
        const float* texel = image.rgba.data() + LevelStart(image, level);
        for (std::size_t i = 0; i < 4 * texels; ++i) {
            auto& [least, greatest] = found->second[i % 4];
            least = std::min(least, texel[i]);
            greatest = std::max(greatest, texel[i]);
        }
    }
    return found->second;
}

WordRange Context<Interval>::RangeAt(Machine<Interval>& m, std::uint32_t column,
                                     std::uint32_t lane) {
    const std::uint32_t first = m.RawWords(column)[lane];
    const bool is_open = has_ranges && open[column].Has(lane);
    return {first, is_open ? lasts[std::size_t{column} * kLanes + lane] : first};
}

void Context<Interval>::SetRange(Machine<Interval>& m, std::uint32_t column, std::uint32_t lane,
                                 WordRange range) {
    m.RawWords(column)[lane] = range.first;
    if (range.IsPoint()) {
        return;
    }
    if (((range.first ^ range.last) & kSignBit) != 0 || range.first > range.last) {
        Lose(lane);
        return;
    }
    open.resize(m.plan->columns.words);
    lasts.resize(m.words.size());
    open[column].Add(lane);
    lasts[std::size_t{column} * kLanes + lane] = range.last;
    has_ranges = true;
}

void Context<Interval>::CopyRange(Machine<Interval>& m, std::uint32_t from, std::uint32_t to) {
    if (!has_ranges) {
        return;
    }
    open[to].Remove(m.lanes.mask);
    Mask copied = open[from];
    copied.Keep(m.lanes.mask);
    open[to].Add(copied);
    copied.Each([&](std::uint32_t lane) {
        lasts[std::size_t{to} * kLanes + lane] = lasts[std::size_t{from} * kLanes + lane];
    });
}

void Context<Interval>::Close(Machine<Interval>& m, std::uint32_t column) {
    if (!has_ranges) {
        return;
    }
    Mask closed = open[column];
    closed.Keep(m.lanes.mask);
    open[column].Remove(closed);
    closed.Each([&](std::uint32_t lane) {
        std::uint32_t& word = m.RawWords(column)[lane];
        const std::uint32_t last = lasts[std::size_t{column} * kLanes + lane];
        word += Decide(lane, std::uint64_t{last - word} + 1);
    });
}

void Context<Interval>::Forget() {
    if (has_ranges) {
        std::fill(open.begin(), open.end(), Mask{});
        has_ranges = false;
    }
}

void Context<Interval>::Before(Machine<Interval>& m, const Step& step) {
    for (std::uint32_t i = 0; has_ranges && i < step.size.words; ++i) {
        open[step.result.words + i].Remove(m.lanes.mask);
    }
}

namespace {

// The profiles state no bound for numbers of relaxed precision; integers keep 16 bits of theirs.
void Relax(Machine<Interval>& m, const Step& step) {
    for (std::uint32_t i = 0; i < step.size.floats; ++i) {
        Interval* result = m.Floats(step.result.floats + i);
        m.lanes.Each([&](std::uint32_t lane) { result[lane] = interval::Anything(); });
    }
    for (std::uint32_t i = 0; i < step.size.words; ++i) {
        const std::uint32_t* result = m.Words(step.result.words + i);
        m.lanes.mask.Each([&](std::uint32_t lane) {
            const std::uint32_t word = result[lane];
            if (word != (word & 0x7fffu) && word != (word | 0xffff8000u)) {
                m.context.Lose(lane);
            }
        });
    }
}

}  // namespace

void Context<Interval>::After(Machine<Interval>& m, const Step& step) {
    operation::LoseUndefined(m, step);
    if (step.value == kNone) {
        return;
    }
    const spirv::Value& value = m.plan->module.values[step.value];
    if (value.relaxed_precision) {
        Relax(m, step);
    }
    if (!value.no_contraction) {
        return;
    }
    for (std::uint32_t i = 0; i < step.size.floats; ++i) {
        Interval* result = m.Floats(step.result.floats + i);
        m.lanes.Each([&](std::uint32_t lane) { result[lane] = interval::Settle(result[lane]); });
    }
}

bool Bound::Holds(std::uint32_t bits) const {
    switch (kind) {
        case Kind::kNumber: {
            const auto value = std::bit_cast<float>(bits);
            return low <= value && value <= high &&
                   (quantum == 0 || std::isinf(value) || std::fmod(value, quantum) == 0);
        }
        case Kind::kWord:
            return bits == word;
        case Kind::kUnbounded:
            return true;
    }
    return true;
}

namespace {

// A row and the next of its ways, as far as that is given.
struct Task {
    std::uint32_t row = 0;
    Way way;
};

// The way with the last choice that has an alternative left changed to that; false where none has.
bool Turn(Way& way) {
    way.at = 0;
    while (!way.taken.empty() && way.taken.back() + 1 == way.alternatives.back()) {
        way.taken.pop_back();
        way.alternatives.pop_back();
    }
    if (way.taken.empty()) {
        return false;
    }
    ++way.taken.back();
    return true;
}

// Ways that are known to follow this one.
std::uint64_t WaysLeft(const Way& way) {
    std::uint64_t left = 0;
    for (std::size_t i = 0; i < way.taken.size(); ++i) {
        left += way.alternatives[i] - 1u - way.taken[i];
    }
    return left;
}

class Bounder {
  public:
    Bounder(std::shared_ptr<const Plan> plan, const std::vector<Texture>& images,
            const Rows<Interval>& rows, std::span<Bound> bounds, Limits limits)
        : runner_(std::move(plan), images, limits),
          rows_(rows),
          limits_(limits),
          ways_(rows.count),
          is_lost_(rows.count),
          most_(std::uint64_t{limits.mean_ways} * rows.count + limits.ways) {
        runner_.rows = &rows_;
        ETALON_CHECK(limits.ways <= std::numeric_limits<std::uint8_t>::max());
        // Each choice leads to at least one more way.
        runner_.context.most_choices = limits.ways;
        runner_.context.bounds = bounds;
        runner_.context.is_stored.resize(bounds.size());
    }

    void RunAll() {
        std::uint32_t next = 0;
        std::vector<Task> batch;
        while (next < rows_.count || !batch.empty()) {
            while (batch.size() < kLanes && next < rows_.count) {
                batch.push_back({next++, {}});
            }
            RunBatch(batch);
            std::erase_if(batch, [&](Task& task) { return is_lost_[task.row] || !Turn(task.way); });
        }
        for (std::size_t i = 0; i < runner_.context.bounds.size(); ++i) {
            if (is_lost_[i % rows_.count]) {
                runner_.context.bounds[i] = {};
            }
        }
    }

  private:
    void RunBatch(std::vector<Task>& batch) {
        std::array<std::uint32_t, kLanes> row_of_lane;
        runner_.context.lost = Mask{};
        runner_.context.Forget();
        for (std::uint32_t lane = 0; lane < batch.size(); ++lane) {
            row_of_lane[lane] = batch[lane].row;
            runner_.context.ways[lane] = std::move(batch[lane].way);
        }
        runner_.RunLanes(std::span(row_of_lane).first(batch.size()));
        spent_ += batch.size();
        for (std::uint32_t lane = 0; lane < batch.size(); ++lane) {
            const std::uint32_t row = batch[lane].row;
            batch[lane].way = std::move(runner_.context.ways[lane]);
            const std::uint64_t left = WaysLeft(batch[lane].way);
            is_lost_[row] = runner_.context.lost.Has(lane) || ++ways_[row] + left > limits_.ways ||
                            (left > 0 && spent_ > most_);
        }
    }

    Runner<Interval> runner_;
    const Rows<Interval> rows_;
    const Limits limits_;
    std::vector<std::uint32_t> ways_;  // by row: those taken
    std::vector<bool> is_lost_;        // by row
    const std::uint64_t most_;         // ways of all rows
    std::uint64_t spent_ = 0;
};

}  // namespace

bool BoundAlike(const Plan& plan, const Profile& a, const Profile& b) {
    bool has_trigonometry = false;
    bool has_filters = false;
    bool has_modulus = false;
    for (const Step& step : plan.steps) {
        const std::uint32_t glsl = step.code - kGlslCode;
        has_trigonometry = has_trigonometry || (step.code > kGlslCode && glsl >= GLSLstd450Sin &&
                                                glsl <= GLSLstd450Atan2);
        has_filters = has_filters ||
                      step.code == static_cast<std::uint32_t>(spv::Op::OpImageSampleExplicitLod);
        has_modulus = has_modulus || step.code == static_cast<std::uint32_t>(spv::Op::OpSMod);
    }
    Profile other = b;
    other.name = a.name;
    other.source = a.source;
    if (!has_trigonometry) {
        other.bounds_trigonometry = a.bounds_trigonometry;
        other.sine_absolute = a.sine_absolute;
        other.arc_tangent_ulp = a.arc_tangent_ulp;
    }
    if (!has_filters) {
        other.weight_absolute = a.weight_absolute;
    }
    if (!has_modulus) {
        other.defines_negative_modulus = a.defines_negative_modulus;
    }
    return other == a;
}

std::vector<Bound> BoundOutputs(std::shared_ptr<const Plan> plan,
                                const std::vector<Texture>& images, const Profile& profile,
                                std::uint32_t rows, std::span<const std::uint32_t> inputs,
                                std::uint32_t output_words, Limits limits) {
    const Held held(profile);
    std::vector<Bound> bounds(std::size_t{rows} * output_words);
    Bounder bounder(std::move(plan), images, {rows, inputs, {}, {}}, bounds, limits);
    bounder.RunAll();
    return bounds;
}

}  // namespace etalon::evaluate
