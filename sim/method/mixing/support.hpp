#pragma once

#include "sim/base/vector.hpp"
#include "sim/space/phase.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace sandglass::mixing {

/// What the share of gravity is made from (SUPORT and ARINT of the listing in Greenspan 1972): blocks, and the squares
/// that stand for the particles.
struct SupportParameters {
  Vector<2> box = Vector<2>::Zero();
  std::uint32_t columns = 1, rows = 2;  ///< blocks along x and along y
  double diameter = 1;                  ///< edge of the square of a particle
  double smallest_length = 1e-3;        ///< EPS of the listing, added to the area of the strip
  bool counts_itself = false;           ///< a fault

  double strip() const { return box[0] / columns; }
  double row_height() const { return box[1] / rows; }
};

/// Share of gravity that a particle feels: 1 - A / (area of the strip below it), with A the area of the squares below it in
/// a strip a block wide, from the floor up to the row of blocks where its centre is. 1 when a row of that strip is empty.
/// In the lowest row the strip ends at the centre, and up to a diameter above the floor the share is 0. Below zero where
/// squares overlap: then the particle rises.
///
/// The squares stand in columns, by height, and a particle looks through those of its strip only: the listing looks
/// through all.
class Support {
 public:
  explicit Support(const SupportParameters& parameters);
  /// Takes the particles of a step.
  void prepare(std::span<const Phase<2>> particles);
  double share(std::size_t particle);
  std::size_t bytes() const;

 private:
  struct Square {
    double x, height;                             ///< of its centre
    std::uint32_t particle, first_row, last_row;  ///< rows that it has a part in
  };
  struct Strip {
    double left, right, top;
    std::uint32_t rows;  ///< that must not be empty
  };

  Square square_of(const Vector<2>& position, std::uint32_t particle) const;
  std::uint32_t row_of(double height) const;
  std::size_t column_of(double x) const;
  void sort_columns();
  /// Area of the squares in the strip that are not above the particle; nothing when a row is empty.
  double area_below(std::size_t particle, const Strip& strip);
  void mark_rows(const Square& square, const Strip& strip);
  double low_edge(double height) const { return std::max(0.0, height - 0.5 * parameters_.diameter); }
  double high_edge(double height) const {
    return std::min(parameters_.box[1], height + 0.5 * parameters_.diameter);
  }

  SupportParameters parameters_;
  std::size_t columns_;
  std::vector<Square> squares_;        ///< by column, then by height
  std::vector<std::uint32_t> first_;   ///< of each column, and the end
  std::vector<Vector<2>> positions_;   ///< as given
  std::vector<std::uint64_t> marked_;  ///< by row: the search that found it filled last
  std::uint64_t search_ = 0;
  std::uint32_t filled_ = 0;
};

}  // namespace sandglass::mixing
