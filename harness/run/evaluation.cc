#include "run/evaluation.h"

#include <optional>
#include <utility>

#include "base/check.h"
#include "evaluate/big.h"
#include "evaluate/bound.h"
#include "evaluate/evaluate.h"
#include "numeric/number_text.h"
#include "spirv/read.h"

namespace etalon {
namespace {

Allowed AllowedOf(const evaluate::Bound& bound) {
    using Kind = evaluate::Bound::Kind;
    Allowed allowed;
    switch (bound.kind) {
        case Kind::kNumber:
            allowed.kind = Allowed::Kind::kNumber;
            allowed.low = bound.low;
            allowed.high = bound.high;
            allowed.quantum = bound.quantum;
            break;
        case Kind::kWord:
            allowed.kind = Allowed::Kind::kWord;
            allowed.word = bound.word;
            break;
        case Kind::kUnbounded:
            break;
    }
    return allowed;
}

}  // namespace

const evaluate::Profile& ProfileOf(const DeviceInfo& device) {
    const bool is_gl = device.name.starts_with("osmesa:") || device.name.starts_with("egl:");
    const evaluate::Profile* profile = evaluate::FindProfile(is_gl ? "glsl-4.60" : "vulkan-1.3");
    ETALON_CHECK(profile != nullptr);
    return *profile;
}

struct Evaluation::State {
    State(std::string why) : plan(Error{std::move(why)}) {}
    State(const Program& program, const Rows& given)
        : rows(given), output_words(program.output_words), plan(PlanOf(program)) {
        for (const BoundImage& image : program.images) {
            images.push_back({image.image, image.sampling});
        }
        if (plan && images.size() < (*plan)->images) {
            plan = Error{"the program names more images than it brings"};
        }
    }

    static Result<std::shared_ptr<const evaluate::Plan>> PlanOf(const Program& program) {
        ETALON_CHECK(program.form == Form::kSpirv && program.stage == Stage::kCompute);
        ETALON_TRY(module, spirv::ReadModule(program.spirv));
        return evaluate::MakePlan(std::move(module));
    }

    template <typename Number>
    Status<> Run(std::uint32_t count, std::span<const std::uint32_t> inputs,
                 std::span<std::uint32_t> outputs, std::span<Number> numbers) const {
        evaluate::Evaluator<Number> evaluator(*plan, images);
        return evaluator.Run({count, inputs, outputs, numbers});
    }

    Result<Values> Evaluate() const {
        if (!plan) {
            return plan.error();
        }
        const auto count = static_cast<std::uint32_t>(rows.rows);
        const std::size_t size = rows.rows * output_words;
        Values found;
        found.strict.resize(size);
        ETALON_TRY_STEP(Run<float>(count, rows.words, found.strict, {}));
        found.method.words.resize(size);
        found.method.numbers.resize(size);
        ETALON_TRY_STEP(Run<double>(count, rows.words, found.method.words, found.method.numbers));
        return found;
    }

    // `known` are the values where there are any.
    Result<Bounds> Bound(const evaluate::Profile& profile, const Result<Values>& known) const {
        if (!plan) {
            return plan.error();
        }
        const std::vector<evaluate::Bound> found =
            evaluate::BoundOutputs(*plan, images, profile, static_cast<std::uint32_t>(rows.rows),
                                   rows.words, output_words);
        Bounds made;
        made.allowed.reserve(found.size());
        made.is_void.resize(found.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            made.allowed.push_back(AllowedOf(found[i]));
            if (known && Excess(made.allowed[i], known->strict[i]) > 0) {
                made.allowed[i] = Allowed{};
                made.is_void[i] = true;
            }
        }
        return made;
    }

    Method ExactAt(std::uint64_t row) const {
        std::vector<std::uint32_t> inputs;
        for (std::size_t column = 0; column < rows.columns; ++column) {
            inputs.push_back(rows.words[column * rows.rows + row]);
        }
        Method method;
        method.words.resize(output_words);
        std::vector<evaluate::Big> numbers(output_words);
        if (Run<evaluate::Big>(1, inputs, method.words, numbers)) {
            for (const evaluate::Big& number : numbers) {
                method.numbers.push_back(number.ToDouble());
            }
            return method;
        }
        const Method& coarse = (*values)->method;
        for (std::size_t column = 0; column < output_words; ++column) {
            method.words[column] = coarse.words[column * rows.rows + row];
            method.numbers.push_back(coarse.numbers[column * rows.rows + row]);
        }
        return method;
    }

    struct Bounded {
        std::once_flag once;
        std::optional<Result<Bounds>> bounds;
    };

    Rows rows;
    std::uint32_t output_words = 0;
    Result<std::shared_ptr<const evaluate::Plan>> plan;
    std::vector<evaluate::Texture> images;
    std::once_flag values_once;
    std::optional<Result<Values>> values;
    std::mutex mutex;  // of what follows, but not of what a Bounded holds
    std::map<const evaluate::Profile*, Bounded> bounds;
    std::map<std::uint64_t, Method> exact;  // by row
};

Evaluation::Evaluation(const Program& program, const Rows& inputs)
    : state_(std::make_unique<State>(program, inputs)) {}
Evaluation::Evaluation(std::string reason) : state_(std::make_unique<State>(std::move(reason))) {}
Evaluation::~Evaluation() = default;

double Evaluation::Method::At(std::size_t index, Scalar scalar) const {
    return scalar == Scalar::kFloat ? numbers[index] : WordValue(scalar, words[index]);
}

const Result<Evaluation::Values>& Evaluation::Get() {
    std::call_once(state_->values_once, [this] { state_->values = state_->Evaluate(); });
    return *state_->values;
}

const Result<Evaluation::Bounds>& Evaluation::BoundsBy(const evaluate::Profile& profile) {
    State::Bounded* bounded = nullptr;
    {
        const std::lock_guard lock(state_->mutex);
        const auto alike =
            std::find_if(state_->bounds.begin(), state_->bounds.end(), [&](const auto& known) {
                return state_->plan && evaluate::BoundAlike(**state_->plan, *known.first, profile);
            });
        bounded = alike != state_->bounds.end() ? &alike->second : &state_->bounds[&profile];
    }
    std::call_once(bounded->once, [&] { bounded->bounds = state_->Bound(profile, Get()); });
    return *bounded->bounds;
}

double Evaluation::MethodAt(std::uint64_t row, std::size_t column, Scalar scalar) {
    const std::lock_guard lock(state_->mutex);
    auto [known, is_new] = state_->exact.try_emplace(row);
    if (is_new) {
        known->second = state_->ExactAt(row);
    }
    return known->second.At(column, scalar);
}

Evaluations::Evaluations(std::shared_ptr<Programs> programs) : programs_(std::move(programs)) {}

Evaluation& Evaluations::Of(const Call& call, const Signature& signature, const Recipe& recipe,
                            const Rows& rows) {
    Recipe plain;
    plain.precise = recipe.precise && recipe.form == Form::kSpirv;
    const std::string key = Programs::KeyOf(call, plain);
    const Programs::Compiled* compiled = nullptr;
    if (signature.stage == Stage::kCompute) {
        compiled = &programs_->Get(call, signature, plain, Target{}, {});
    }
    const std::lock_guard lock(mutex_);
    auto& entry = entries_[rows.words.data()][key];
    if (!entry && compiled == nullptr) {
        entry = std::make_unique<Evaluation>("its sources compile for fragment shaders only");
    } else if (!entry && !*compiled) {
        entry = std::make_unique<Evaluation>(compiled->error().reason);
    } else if (!entry) {
        entry = std::make_unique<Evaluation>(**compiled, rows);
    }
    return *entry;
}

void Evaluations::Forget(std::span<const std::uint32_t> words) {
    const std::lock_guard lock(mutex_);
    entries_.erase(words.data());
}

}  // namespace etalon
