// The words of one batch, mapped by the client and its worker: no copy on the way.
#pragma once

#include <cstdint>
#include <span>

#include "base/result.h"
#include "worker/descriptor.h"

namespace etalon {

// The size of a batch, from which both sides derive where its words lie.
struct Batch {
    std::uint32_t rows = 0;
    std::uint32_t input_words = 0;  // per row
    std::uint32_t output_words = 0;

    std::uint64_t InputCount() const { return std::uint64_t{rows} * input_words; }
    std::uint64_t OutputCount() const { return std::uint64_t{rows} * output_words; }
};

class SharedMemory {
  public:
    // The client's side: new memory without a name, which the worker's side cannot shrink.
    static Result<SharedMemory> Create();

    // The worker's side.
    explicit SharedMemory(Descriptor file) : file_(std::move(file)) {}

    SharedMemory(SharedMemory&& other) noexcept;
    SharedMemory& operator=(SharedMemory&&) = delete;
    ~SharedMemory();

    int descriptor() const { return file_.number(); }

    // Makes room for the batch; earlier spans end. Throws std::bad_alloc where the address space
    // is full.
    void Reserve(const Batch& batch);

    // Of a batch no larger than the last one reserved.
    std::span<std::uint32_t> Inputs(const Batch& batch) const;
    std::span<std::uint32_t> Outputs(const Batch& batch) const;

  private:
    Descriptor file_;
    std::uint32_t* words_ = nullptr;
    std::uint64_t bytes_ = 0;
};

}  // namespace etalon
