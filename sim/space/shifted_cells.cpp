#include "sim/space/shifted_cells.hpp"

#include "sim/space/flight.hpp"

namespace sandglass {

template <int D>
void ShiftedCells<D>::shift(const Vector<D>& part) {
  for (int axis = 0; axis < D; ++axis)
    part_[axis] = !periodic(axis) && grid_.cells(axis) == 1 ? 0 : part[axis];
}

template <int D>
void ShiftedCells<D>::put_into(std::uint32_t cell, Vector<D>& position) const {
  for (int axis = 0; axis < D; ++axis) {
    position[axis] = put_along(axis, cell % grid_.cells(axis), position[axis]);
    cell /= grid_.cells(axis);
  }
}

/// Towards the middle of the cell, as little as rounding allows.
template <int D>
double ShiftedCells<D>::put_along(int axis, std::uint32_t place, double x) const {
  const double length = grid_.box()[axis], per_length = grid_.cells_per_length(axis);
  const auto into_box = [&](double y) {
    return periodic(axis) ? wrap(y, length, 1 / length) : std::clamp(y, 0.0, length);
  };
  x = into_box(x);
  const double middle = place + 0.5 + part_[axis];
  double gap = x * per_length - middle;
  if (periodic(axis)) gap -= grid_.cells(axis) * std::round(gap / grid_.cells(axis));
  for (double margin = 0; coordinate(x, axis) != place; margin = 2 * margin + 1e-16)
    x = into_box((middle + std::clamp(gap, margin - 0.5, 0.5 - margin)) / per_length);
  return x;
}

template <int D>
double ShiftedCells<D>::volume(std::uint32_t cell) const {
  double volume = 1;
  for (int axis = 0; axis < D; ++axis) {
    const std::uint32_t place = cell % grid_.cells(axis), last = grid_.cells(axis) - 1;
    cell /= grid_.cells(axis);
    if (periodic(axis) || last == 0) continue;
    if (place == 0) volume *= 1 + part_[axis];
    if (place == last) volume *= 1 - part_[axis];
  }
  return volume;
}

template class ShiftedCells<2>;
template class ShiftedCells<3>;

}  // namespace sandglass
