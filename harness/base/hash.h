// A short hash that is the same on every machine; no protection against anybody.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace etalon {

// FNV-1a in 64 bits over the bytes given, piece by piece.
class Hash {
  public:
    void Add(std::string_view bytes) {
        for (const char c : bytes) {
            value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
        }
    }
    // The words' bytes, the lowest first.
    void Add(std::span<const std::uint32_t> words) {
        for (const std::uint32_t word : words) {
            for (unsigned shift = 0; shift < 32; shift += 8) {
                value_ = (value_ ^ (word >> shift & 0xff)) * 0x100000001b3u;
            }
        }
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace etalon
