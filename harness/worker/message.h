// What a client and its worker say to each other, as bytes. Both are the same program on the same
// machine, so numbers travel in its own representation.
//
// A frame is the size of the message (8 bytes) and the message. Encode yields a frame, Decode takes
// a message.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "device/backends.h"
#include "device/device.h"
#include "probe/program.h"
#include "worker/shared_memory.h"

namespace etalon {

inline constexpr std::size_t kFrameBytes = sizeof(std::uint64_t);

// Of text that starts with a frame's size.
std::uint64_t FramedSize(std::string_view text);

// The first request, answered by a DeviceResult<DeviceInfo>.
struct OpenRequest {
    Candidate candidate;
    std::uint64_t memory_bytes = 0;  // beyond which the worker's allocations fail
};

// Answered by a DeviceResult<RunTime> when the outputs lie in the shared memory; the time is that
// of the run where it `is_timed`, else 0.
struct RunRequest {
    std::uint32_t handle = 0;
    Batch batch;
    bool is_timed = false;
};

// A Program is loaded; answered by a DeviceResult<std::uint32_t>.
using Request = std::variant<OpenRequest, Program, RunRequest>;

std::string Encode(const OpenRequest& request);
std::string Encode(const Program& request);
std::string Encode(const RunRequest& request);
// Nothing, too, where an image's values are not those that its numbers tell of.
std::optional<Request> DecodeRequest(std::string_view message);

// An answer is not believed: a driver may have written over its worker's memory. A reason is cut at
// kLongestReason, an answer beyond kLongestAnswer cannot be true, and Decode leaves only printable
// text.
inline constexpr std::size_t kLongestReason = 1u << 16;
inline constexpr std::uint64_t kLongestAnswer = 1u << 20;

template <typename T>
std::string EncodeAnswer(const DeviceResult<T>& answer);
template <typename T>
std::optional<DeviceResult<T>> DecodeAnswer(std::string_view message);

// The text with "?" for each byte that is neither printable ASCII nor a line's end or tab.
std::string Printable(std::string_view text);

}  // namespace etalon
