// GlProgram: one loaded program and its way of evaluating rows.
#pragma once

#include <cstdint>

#include "device/device.h"
#include "device/gl/gl_timer.h"

namespace etalon {

// The rows [begin, begin + rows) of a run of `stride` rows, whose words lie by columns.
struct Batch {
    const std::uint32_t* inputs = nullptr;
    std::uint32_t* outputs = nullptr;
    std::uint32_t stride = 0;
    std::uint32_t begin = 0;
    std::uint32_t rows = 0;

    const std::uint32_t* Input(std::uint32_t column) const {
        return inputs + std::size_t{column} * stride + begin;
    }
    std::uint32_t* Output(std::uint32_t column) const {
        return outputs + std::size_t{column} * stride + begin;
    }
};

class GlProgram {
  public:
    virtual ~GlProgram() = default;

    // The most rows that one batch may have; 0 if the device's limits do not even take one.
    virtual std::uint32_t max_rows() const = 0;

    // What the program itself takes is told to `timer`.
    virtual DeviceResult<Nothing> Evaluate(const Batch& batch, GlTimer& timer) = 0;
};

}  // namespace etalon
