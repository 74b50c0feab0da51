// How often which error occurred: errors in ulp, counted by binades.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace etalon {

class UlpHistogram {
  public:
    // Bin 0 holds what is exact, the bins from 1 on the errors up to Upper(bin) and above that of
    // the bin before; the last one holds those that are infinite (from 2^1023 on, which
    // no finite error in ulp of a float comes near), and NaN.
    static constexpr int kLeast = -6;  // the first bin of inexact values reaches up to 2^-6
    static constexpr int kMost = 24;   // the last but two up to 2^24; the last but one beyond
    static constexpr std::size_t kBins = kMost - kLeast + 4;

    static double Upper(std::size_t bin);

    // Of an error that is not negative.
    static std::size_t BinOf(double ulp_error) {
        // One bit less leaves a power of two in the binade below; of zero it makes the largest.
        const auto binade =
            static_cast<int>((std::bit_cast<std::uint64_t>(ulp_error) - 1) >> 52 & 0xfff) - 1022;
        constexpr int kOfZero = 0xfff - 1022;
        constexpr int kOfLargest = 0x7fe - 1022;
        if (binade >= kOfLargest) {
            return binade == kOfZero ? 0 : kBins - 1;
        }
        return static_cast<std::size_t>(std::clamp(binade, kLeast, kMost + 1) - kLeast + 1);
    }

    void Add(double ulp_error) { ++counts_[BinOf(ulp_error)]; }
    void Add(const UlpHistogram& other);

    std::array<std::uint64_t, kBins>& counts() { return counts_; }
    const std::array<std::uint64_t, kBins>& counts() const { return counts_; }
    std::uint64_t Total() const;

  private:
    std::array<std::uint64_t, kBins> counts_ = {};
};

}  // namespace etalon
