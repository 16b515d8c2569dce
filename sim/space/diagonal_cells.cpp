#include "sim/space/diagonal_cells.hpp"

#include "sim/space/flight.hpp"

namespace sandglass {

DiagonalCells::DiagonalCells(const Vector<2>& box, const std::array<std::uint32_t, 2>& cells,
                             const std::array<bool, 2>& periodic)
    : box_(box),
      per_half_(2.0 * cells[0] / box[0], 2.0 * cells[1] / box[1]),
      periodic_(periodic),
      last_{2 * std::int64_t{cells[0]}, 2 * std::int64_t{cells[1]}},
      in_even_(cells[0] + !periodic[0]),
      in_odd_(cells[0]) {}

std::uint32_t DiagonalCells::size() const {
  const auto pairs_of_rows = static_cast<std::uint32_t>(last_[1] / 2);
  return pairs_of_rows * (in_even_ + in_odd_) + (periodic_[1] ? 0 : in_even_);
}

DiagonalCells::Middle DiagonalCells::middle(std::uint32_t cell) const {
  const std::int64_t pair = cell / (in_even_ + in_odd_), rest = cell % (in_even_ + in_odd_);
  if (rest < in_even_) return {2 * rest, 2 * pair};
  return {2 * (rest - in_even_) + 1, 2 * pair + 1};
}

/// Sideways to the nearer side, then towards the middle as little as rounding allows.
void DiagonalCells::put_into(std::uint32_t cell, Vector<2>& position) const {
  const Middle at = middle(cell);
  const Vector<2> centre(static_cast<double>(at.column), static_cast<double>(at.row));
  const auto into_box = [&](Vector<2> place) {
    for (int axis = 0; axis < 2; ++axis)
      place[axis] = periodic_[static_cast<std::size_t>(axis)] ? wrap(place[axis], box_[axis], 1 / box_[axis])
                                                              : std::clamp(place[axis], 0.0, box_[axis]);
    return place;
  };
  position = into_box(position);
  Vector<2> gap = position.cwiseProduct(per_half_) - centre;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto period = static_cast<double>(last_[axis]);
    double& along = gap[static_cast<int>(axis)];
    if (periodic_[axis]) along -= period * std::round(along / period);
  }
  for (double margin = 0; cell_of(position) != cell; margin = 2 * margin + 1e-16) {
    const double up = std::clamp(0.5 * (gap[1] + gap[0]), margin - 0.5, 0.5 - margin);
    const double down = std::clamp(0.5 * (gap[1] - gap[0]), margin - 0.5, 0.5 - margin);
    position = into_box((centre + Vector<2>(up - down, up + down)).cwiseQuotient(per_half_));
  }
}

double DiagonalCells::volume(std::uint32_t cell) const {
  const Middle at = middle(cell);
  double volume = 1;
  if (!periodic_[0] && (at.column == 0 || at.column == last_[0])) volume /= 2;
  if (!periodic_[1] && (at.row == 0 || at.row == last_[1])) volume /= 2;
  return volume;
}

double DiagonalCells::width() const { return 2 / per_half_.norm(); }

std::optional<std::uint32_t> DiagonalCells::neighbour(std::uint32_t cell, int axis, bool up) const {
  const Middle at = middle(cell);
  const std::int64_t column = at.column + (up == (axis == 0) ? 1 : -1), row = at.row + (up ? 1 : -1);
  if (behind_wall(column, 0) || behind_wall(row, 1)) return std::nullopt;
  return number(around(column, 0), around(row, 1));
}

Vector<2> DiagonalCells::direction(int axis) const {
  const Vector<2> half = per_half_.cwiseInverse();
  return Vector<2>(axis == 0 ? half[0] : -half[0], half[1]).normalized();
}

}  // namespace sandglass
