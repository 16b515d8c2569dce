#include "sim/method/mixing/filled_rows.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace sandglass::mixing {

namespace {
constexpr std::uint32_t kBits = 64;
/// Words that rows of bits may take, whatever the number of squares, and for each of them.
constexpr std::size_t kMostWords = 1024, kWordsPerSquare = 4;
}  // namespace

FilledRows::FilledRows(double width, std::uint32_t columns, std::uint32_t rows)
    : width_(width),
      margin_(1e-12 * width),
      wanted_(columns),
      columns_(columns),
      rows_(rows),
      words_((rows + kBits - 1) / kBits) {}

void FilledRows::begin(std::size_t squares) {
  const std::size_t most = (kMostWords + kWordsPerSquare * squares) / words_;
  columns_ = std::clamp<std::int64_t>(static_cast<std::int64_t>(most), 1, wanted_);
  filled_.assign(words_ * static_cast<std::size_t>(columns_), 0);
}

void FilledRows::add(double x, std::uint32_t first_row, std::uint32_t last_row) {
  const auto column = static_cast<std::size_t>(column_of(x));
  for (std::uint32_t row = first_row; row <= last_row; ++row)
    filled_[row / kBits * static_cast<std::size_t>(columns_) + column] |= std::uint64_t{1} << row % kBits;
}

std::int64_t FilledRows::column_of(double x) const {
  const double column = x / width_ * static_cast<double>(columns_);
  return static_cast<std::int64_t>(std::clamp(column, 0.0, static_cast<double>(columns_ - 1)));
}

std::uint32_t FilledRows::rows_filled(std::int64_t first, std::int64_t last) const {
  for (std::size_t word = 0; word < words_; ++word) {
    const std::uint64_t* row = filled_.data() + word * static_cast<std::size_t>(columns_);
    std::uint64_t bits = 0;
    for (std::int64_t column = first; column <= last; ++column) bits |= row[column];
    if (~bits != 0)
      return static_cast<std::uint32_t>(word) * kBits + static_cast<std::uint32_t>(std::countr_one(bits));
  }
  return rows_;
}

}  // namespace sandglass::mixing
