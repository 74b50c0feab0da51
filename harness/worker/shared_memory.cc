#include "worker/shared_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <new>
#include <utility>

namespace etalon {
namespace {

constexpr std::uint64_t kSmallest = 1u << 20;

// The outputs start on a page, as imports of host memory want it.
constexpr std::uint64_t kPageWords = 1024;

std::uint64_t OutputOffset(const Batch& batch) {
    return (batch.InputCount() + kPageWords - 1) / kPageWords * kPageWords;
}

std::uint64_t Bytes(const Batch& batch) {
    return (OutputOffset(batch) + batch.OutputCount()) * sizeof(std::uint32_t);
}

}  // namespace

Result<SharedMemory> SharedMemory::Create() {
    Descriptor file(memfd_create("etalon", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    // A worker that shrank the file would end this process at its next look (SIGBUS).
    if (!file || fcntl(file.number(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_SEAL) != 0) {
        return Error{std::string("no memory can be shared with a worker (") + std::strerror(errno) +
                     ")"};
    }
    return SharedMemory(std::move(file));
}

SharedMemory::SharedMemory(SharedMemory&& other) noexcept
    : file_(std::move(other.file_)),
      words_(std::exchange(other.words_, nullptr)),
      bytes_(std::exchange(other.bytes_, 0)) {}

SharedMemory::~SharedMemory() {
    if (words_ != nullptr) {
        munmap(words_, bytes_);
    }
}

void SharedMemory::Reserve(const Batch& batch) {
    const std::uint64_t wanted = Bytes(batch);
    if (wanted <= bytes_) {
        return;
    }
    struct stat state = {};
    if (fstat(file_.number(), &state) != 0) {
        throw std::bad_alloc();
    }
    auto size = static_cast<std::uint64_t>(state.st_size);
    // On the worker's side the file has its size already. Pages cost nothing before their first
    // use, so growing in powers of two is free.
    if (size < wanted) {
        size = std::bit_ceil(std::max(wanted, kSmallest));
        if (ftruncate(file_.number(), static_cast<off_t>(size)) != 0) {
            throw std::bad_alloc();
        }
    }
    void* place = words_ == nullptr
                      ? mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file_.number(), 0)
                      : mremap(words_, bytes_, size, MREMAP_MAYMOVE);
    if (place == MAP_FAILED) {
        throw std::bad_alloc();
    }
    words_ = static_cast<std::uint32_t*>(place);
    bytes_ = size;
}

std::span<std::uint32_t> SharedMemory::Inputs(const Batch& batch) const {
    ETALON_CHECK(Bytes(batch) <= bytes_);
    return {words_, batch.InputCount()};
}

std::span<std::uint32_t> SharedMemory::Outputs(const Batch& batch) const {
    ETALON_CHECK(Bytes(batch) <= bytes_);
    return {words_ + OutputOffset(batch), batch.OutputCount()};
}

}  // namespace etalon
