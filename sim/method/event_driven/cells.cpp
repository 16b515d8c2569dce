#include "sim/method/event_driven/cells.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::event_driven {

template <int D>
Cells<D>::Cells(const Geometry<D>& geometry, double edge) : geometry_(geometry) {
  std::uint32_t size = 1;
  for (int axis = 0; axis < D; ++axis) {
    const std::size_t a = index(axis);
    const double fewest = geometry.periodic[a] ? kFewestPeriodic : 1;
    const double fitting =
        std::clamp(std::floor(geometry.box[axis] / edge), fewest, static_cast<double>(kMask));
    count_[a] = static_cast<std::uint32_t>(fitting);
    edge_[axis] = geometry.box[axis] / fitting;
    per_edge_[axis] = 1 / edge_[axis];
    lowest_[axis] = geometry.periodic[a] ? 0 : -HUGE_VAL;
    highest_[axis] = geometry.periodic[a] ? geometry.box[axis] : HUGE_VAL;
    stride_[a] = size;
    before_first_[a] = geometry.periodic[a] ? count_[a] - 1 : 0;
    after_last_[a] = geometry.periodic[a] ? 0 : count_[a] - 1;
    size *= count_[a];
  }
  head_.resize(size);
}

template <int D>
void Cells<D>::clear() {
  std::fill(head_.begin(), head_.end(), kNobody);
}

template <int D>
std::uint32_t Cells<D>::cell_of(const Vector<D>& position) const {
  std::uint32_t cell = 0;
  for (int axis = 0; axis < D; ++axis) cell |= coordinate_at(position[axis], axis) << (kBits * axis);
  return cell;
}

template <int D>
std::uint32_t Cells<D>::step(std::uint32_t cell, int axis, bool up, double& shift) const {
  const std::uint32_t here = coordinate(cell, axis), last = count_[index(axis)] - 1;
  const bool leaves = here == (up ? last : 0);
  shift = leaves && geometry_.periodic[index(axis)] ? (up ? -1 : 1) * geometry_.box[axis] : 0;
  const std::uint32_t there = !leaves ? (up ? here + 1 : here - 1)
                              : up    ? after_last_[index(axis)]
                                      : before_first_[index(axis)];
  return (cell & ~(kMask << (kBits * axis))) | there << (kBits * axis);
}

template class Cells<2>;
template class Cells<3>;

}  // namespace sandglass::event_driven
