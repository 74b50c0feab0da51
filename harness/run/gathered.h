// The results of one evaluation, by columns over all rows.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace etalon {

class Gathered {
  public:
    Gathered(std::uint64_t rows, std::size_t columns) : rows_(rows), words_(rows * columns) {}

    // As Runner::Sink has them.
    void Take(std::uint64_t first, std::uint32_t rows, std::span<const std::uint32_t> words) {
        const std::size_t columns = words_.size() / rows_;
        for (std::size_t c = 0; c < columns; ++c) {
            const auto from = words.subspan(c * rows, rows);
            std::copy(from.begin(), from.end(),
                      words_.begin() + static_cast<std::ptrdiff_t>(c * rows_ + first));
        }
    }
    std::span<const std::uint32_t> Column(std::size_t column) const {
        return std::span(words_).subspan(column * rows_, rows_);
    }

  private:
    std::uint64_t rows_;
    std::vector<std::uint32_t> words_;
};

}  // namespace etalon
