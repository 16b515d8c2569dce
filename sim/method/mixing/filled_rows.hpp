#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sandglass::mixing {

/// Which rows of blocks hold part of a square, a bit for each, in columns much finer than a strip: most strips show here
/// already that none of their rows is empty, or that one is.
class FilledRows {
 public:
  FilledRows(double width, std::uint32_t columns, std::uint32_t rows);

  /// Empties all rows. So many squares will come: the columns take no more memory than these.
  void begin(std::size_t squares);
  /// A square with its centre at x has part in these rows.
  void add(double x, std::uint32_t first_row, std::uint32_t last_row);

  /// Rows from the floor up to the first one that is empty in all columns that the interval touches.
  std::uint32_t touched(double low, double high) const {
    return rows_filled(column_of(low), column_of(high));
  }
  /// The same of columns that lie in the interval, edges of it left out by more than rounding.
  std::uint32_t within(double low, double high) const {
    return rows_filled(column_of(low + margin_) + 1, column_of(high - margin_) - 1);
  }
  std::size_t bytes() const { return filled_.capacity() * sizeof(std::uint64_t); }

 private:
  std::int64_t column_of(double x) const;
  std::uint32_t rows_filled(std::int64_t first, std::int64_t last) const;

  double width_, margin_;
  std::int64_t wanted_, columns_;
  std::uint32_t rows_;
  std::size_t words_;                  ///< of 64 rows
  std::vector<std::uint64_t> filled_;  ///< of row 64 w + b in column c: bit b of [w * columns_ + c]
};

}  // namespace sandglass::mixing
