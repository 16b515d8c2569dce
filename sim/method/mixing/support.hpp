#pragma once

#include "sim/base/vector.hpp"
#include "sim/method/mixing/filled_rows.hpp"
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
/// through all. Particles of a column are taken by height too, so that what lies below them only grows.
class Support {
 public:
  explicit Support(const SupportParameters& parameters);
  /// Takes the particles of a step.
  void prepare(std::span<const Phase<2>> particles);
  double share(std::size_t particle) const { return shares_[particle]; }
  std::size_t bytes() const;

 private:
  struct Square {
    double x, height;                             ///< of its centre
    std::uint32_t particle, first_row, last_row;  ///< rows that it has a part in
  };
  struct Strip {
    double left, right, top;
    std::uint32_t rows;       ///< that must not be empty
    std::size_t first, last;  ///< columns with squares that may reach into it
  };
  /// Squares of a column from its first one on, for the particle at work.
  struct Below {
    std::size_t of = 0;  ///< whose particles are at work: a column, from 1 on
    std::uint32_t
        whole = 0,
        end = 0;  ///< those that end below the top of the strip; all that begin there and are not higher
  };

  Square square_of(const Vector<2>& position, std::uint32_t particle) const;
  std::uint32_t row_of(double height) const;
  std::size_t column_of(double x) const;
  void sort_into_columns(std::span<const Phase<2>> particles);
  void take_apart();
  Strip strip_of(const Square& square) const;
  double share_of(const Square& square, std::size_t column);
  void find_below(const Square& square, const Strip& strip, std::size_t own);
  bool is_carried(const Square& square, const Strip& strip);
  std::uint32_t count_filled(const Square& square, const Strip& strip, std::uint32_t from_row);
  bool counts(const Square& square, const Square& other) const {
    return other.particle != square.particle || parameters_.counts_itself;
  }
  double area_below(const Square& square, const Strip& strip) const;
  double add_whole(double area, std::uint32_t first, std::uint32_t last, const Strip& strip) const;
  double width_in(const Square& square, const Strip& strip) const {
    return std::min(square.x + radius_, strip.right) - std::max(square.x - radius_, strip.left);
  }
  double low_edge(double height) const { return std::max(0.0, height - radius_); }
  double high_edge(double height) const { return std::min(parameters_.box[1], height + radius_); }

  SupportParameters parameters_;
  double radius_;
  std::size_t columns_;
  std::uint32_t rows_above_;  ///< into which a square reaches down that stands above the strip
  FilledRows filled_;
  std::vector<Square> squares_;              ///< by column, then by height
  std::vector<double> left_, right_, tall_;  ///< of each square: its edges, and how high it is
  std::vector<std::uint32_t> first_;         ///< of each column, and the end
  std::vector<Below> below_;                 ///< of each column
  std::vector<std::uint64_t> marked_;        ///< by row: the search that found it filled last
  std::uint64_t search_ = 0;
  std::vector<double> shares_;
};

}  // namespace sandglass::mixing
