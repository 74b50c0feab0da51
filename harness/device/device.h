// Device: one implementation (an API and a driver) that can run probes. A device executes and never
// judges.
//
// Objects of this class live in worker processes only (worker/): a driver may crash, hang or eat
// memory.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/result.h"
#include "device/device_info.h"
#include "device/run_time.h"
#include "probe/program.h"

namespace etalon {

// Why a device did not do what it was asked.
struct DeviceFailure {
    enum class Kind : std::uint8_t {
        kUnsupported,  // the device cannot run this: a skip
        kRejected,  // the device's compiler refused a valid program: a fail, its log is the reason
        kStopped,   // the program has no result at some row, as one whose loop has no end: a fail
        kLost,      // the device is gone: a crash
    };
    Kind kind = Kind::kUnsupported;
    std::string reason;  // one sentence; a compiler's log may follow on further lines
};

template <typename T>
using DeviceResult = Result<T, DeviceFailure>;

class Device {
  public:
    virtual ~Device() = default;

    virtual const DeviceInfo& info() const = 0;

    // Compiles and keeps the program; returns its handle. Programs stay until the device ends.
    virtual DeviceResult<std::uint32_t> Load(const Program& program) = 0;

    // Evaluates `rows` rows (1..max_rows). `inputs` holds input_words * rows words, `outputs` takes
    // output_words * rows words, both by columns. Returns when the outputs are complete. Where
    // `time` is not null the run is timed, by the device's own clock if it has one: how long the
    // program itself ran, without the way of its inputs and outputs to it and back.
    virtual DeviceResult<Nothing> Run(std::uint32_t handle, std::uint32_t rows,
                                      std::span<const std::uint32_t> inputs,
                                      std::span<std::uint32_t> outputs, RunTime* time) = 0;
};

}  // namespace etalon
