#include "device/null/null_device.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <memory>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace etalon {
namespace {

DeviceResult<Nothing> Crash() {
    std::signal(SIGSEGV, SIG_DFL);  // a sanitizer would make an exit of it
    std::raise(SIGSEGV);
    return Ok();
}

DeviceResult<Nothing> Hang() {
    for (;;) {
        std::this_thread::sleep_for(std::chrono::hours(1));
    }
}

DeviceResult<Nothing> EatMemory() {
    constexpr std::size_t kBlock = 4u << 20;
    std::vector<std::vector<std::byte>> eaten;
    for (;;) {
        eaten.emplace_back(kBlock, std::byte{1});
    }
}

DeviceResult<Nothing> Lose() {
    return DeviceFailure{DeviceFailure::Kind::kLost, "the null device plays a lost device"};
}

DeviceResult<Nothing> Reject() {
    return DeviceFailure{DeviceFailure::Kind::kRejected,
                         "the null device rejects every program\n0:1: as it was told"};
}

DeviceResult<Nothing> Decline() {
    return DeviceFailure{DeviceFailure::Kind::kUnsupported, "the null device supports no program"};
}

enum class Moment : std::uint8_t { kOpen, kLoad, kRun, kNever };

struct Behaviour {
    std::string_view name;
    Moment moment;
    DeviceResult<Nothing> (*act)();
    bool once = false;  // not in the worker that tries again
};

// As echo; what it is like to be slow, Etalon takes from the device's word.
constexpr std::string_view kSlow = "slow";

// As echo, but one float comes back as its successor's successor.
constexpr std::string_view kFlaw = "flaw";
constexpr std::uint32_t kFlawedWord = 0x3f333333u;  // 0.7

constexpr Behaviour kBehaviours[] = {
    {"echo", Moment::kNever, nullptr},
    {kSlow, Moment::kNever, nullptr},
    {kFlaw, Moment::kNever, nullptr},
    {"crash", Moment::kRun, Crash},
    {"crash-once", Moment::kRun, Crash, true},
    {"crash-load", Moment::kLoad, Crash},
    {"crash-open", Moment::kOpen, Crash},
    {"hang", Moment::kRun, Hang},
    {"hang-once", Moment::kRun, Hang, true},
    {"memory", Moment::kRun, EatMemory},
    {"lost", Moment::kRun, Lose},
    {"rejects", Moment::kLoad, Reject},
    {"unsupported", Moment::kLoad, Decline},
};

class NullDevice : public Device {
  public:
    NullDevice(const Behaviour& behaviour, const Candidate& candidate)
        : behaviour_(behaviour), attempt_(candidate.attempt) {
        info_.name = "null:" + candidate.hint;
        if (!candidate.driver.empty()) {
            info_.name += "@" + candidate.driver;
        }
        info_.description = "no device: returns its inputs or plays a fault";
        info_.driver = "null";
        info_.version = "1";
        info_.api = "none";
        info_.features = {"compute", "fragment", "spirv", "glsl"};
        info_.glsl_version = 450;
        info_.on_host = true;
        info_.slow = behaviour.name == kSlow;
    }

    const DeviceInfo& info() const override { return info_; }

    DeviceResult<std::uint32_t> Load(const Program& program) override {
        ETALON_TRY_STEP(Play(Moment::kLoad));
        // A real device compiles here and keeps what it needs in Run.
        input_words_.push_back(program.input_words);
        return static_cast<std::uint32_t>(input_words_.size() - 1);
    }

    // Output word i of a row is its input word i modulo their number, or 0 where there are none.
    DeviceResult<Nothing> Run(std::uint32_t handle, std::uint32_t rows,
                              std::span<const std::uint32_t> inputs,
                              std::span<std::uint32_t> outputs, RunTime* time) override {
        ETALON_CHECK(handle < input_words_.size());
        const Stopwatch stopwatch;
        ETALON_TRY_STEP(Play(Moment::kRun));
        if (time != nullptr) {
            *time = stopwatch.Read();
        }
        const std::size_t input_words = input_words_[handle];
        if (input_words == 0) {
            std::fill(outputs.begin(), outputs.end(), 0u);
            return Ok();
        }
        for (std::size_t column = 0; column < outputs.size() / rows; ++column) {
            const auto source = inputs.subspan(column % input_words * rows, rows);
            std::copy(source.begin(), source.end(), outputs.subspan(column * rows).begin());
        }
        if (behaviour_.name == kFlaw) {
            std::replace(outputs.begin(), outputs.end(), kFlawedWord, kFlawedWord + 2);
        }
        return Ok();
    }

    DeviceResult<Nothing> Play(Moment moment) const {
        if (behaviour_.moment != moment || (behaviour_.once && attempt_ > 0)) {
            return Ok();
        }
        return behaviour_.act();
    }

  private:
    const Behaviour& behaviour_;
    std::uint32_t attempt_;
    DeviceInfo info_;
    std::vector<std::uint32_t> input_words_;  // by handle
};

}  // namespace

std::vector<Candidate> NullCandidates(const Driver& driver) {
    std::vector<Candidate> candidates;
    // It belongs to no driver, so it is offered once. A real backend looks for its files under
    // driver.prefix and names them in the candidate's environment.
    if (!driver.name.empty()) {
        return candidates;
    }
    for (const Behaviour& behaviour : kBehaviours) {
        Candidate candidate;
        candidate.backend = "null";
        candidate.hint = behaviour.name;
        candidates.push_back(std::move(candidate));
    }
    return candidates;
}

DeviceResult<std::unique_ptr<Device>> OpenNullDevice(const Candidate& candidate) {
    for (const Behaviour& behaviour : kBehaviours) {
        if (behaviour.name == candidate.hint) {
            auto device = std::make_unique<NullDevice>(behaviour, candidate);
            ETALON_TRY_STEP(device->Play(Moment::kOpen));
            return std::unique_ptr<Device>(std::move(device));
        }
    }
    return DeviceFailure{DeviceFailure::Kind::kUnsupported,
                         "the null device knows no '" + candidate.hint + "'"};
}

}  // namespace etalon
