#pragma once

#include "sim/method/event_driven/candidates.hpp"
#include "sim/space/scatter.hpp"

#include <algorithm>
#include <array>

namespace sandglass::event_driven {

/// The box and which of its axes are periodic.
template <int D>
struct Geometry {
  Vector<D> box = Vector<D>::Ones();
  std::array<bool, D> periodic{};
};

/// Particles linked by cell. A cell number holds its coordinates side by side in 32 bits, so that a step to a neighbour
/// needs no division.
template <int D>
class Cells {
 public:
  /// `edge` is the least edge of a cell. A periodic axis has four at least: in fewer, particles of neighbouring cells may
  /// stand more than half a box apart, and it is not the nearest image that they will touch.
  Cells(const Geometry<D>& geometry, double edge);

  void clear();
  void enter(Particle<D>* particles, std::uint32_t particle, std::uint32_t cell) {
    std::uint32_t& head = head_[linear(cell)];
    particles[particle].below = head;
    head = particle;
  }
  void leave(Particle<D>* particles, std::uint32_t particle, std::uint32_t cell) {
    std::uint32_t* link = &head_[linear(cell)];
    while (*link != particle) link = &particles[*link].below;
    *link = particles[particle].below;
  }

  std::uint32_t cell_of(const Vector<D>& position) const;
  /// Place of a cell in storage.
  std::uint32_t linear(std::uint32_t cell) const {
    std::uint32_t place = coordinate(cell, 0);
    for (int axis = 1; axis < D; ++axis) place += coordinate(cell, axis) * stride_[index(axis)];
    return place;
  }
  std::uint32_t size() const { return static_cast<std::uint32_t>(head_.size()); }
  /// Whether a number is that of a cell.
  bool has(std::uint32_t cell) const {
    bool inside = std::uint64_t{cell} >> (D * kBits) == 0;
    for (int axis = 0; axis < D; ++axis) inside &= coordinate(cell, axis) < count_[index(axis)];
    return inside;
  }
  /// Calls `visit` with every cell between two corners, which may be infinite, and with some beside them.
  template <class Visit>
  void for_each_between(const Vector<D>& low, const Vector<D>& high, Visit visit) const;

  static std::uint32_t coordinate(std::uint32_t cell, int axis) { return (cell >> (kBits * axis)) & kMask; }
  /// Edges of a cell. Beside a wall it is open: only the wall holds particles back, and it may move.
  double edge(std::uint32_t cell, int axis, bool up) const {
    const std::uint32_t face = coordinate(cell, axis) + up;
    double edge = face * edge_[axis];
    edge = face > 0 ? edge : lowest_[axis];
    return face < count_[index(axis)] ? edge : highest_[axis];
  }
  Vector<D> low_corner(std::uint32_t cell) const { return corner(cell, false); }
  Vector<D> high_corner(std::uint32_t cell) const { return corner(cell, true); }

  /// The next cell along an axis; `shift` is what the position changes by when the way leads through a periodic
  /// boundary. Behind a wall there is no cell: the same one again.
  std::uint32_t step(std::uint32_t cell, int axis, bool up, double& shift) const;

  /// Finds the first particle of the cell and of each of its neighbours, some more than once beside a wall.
  void heads_around(std::uint32_t cell, Candidates& found) const {
    Offsets offsets;
    for (int axis = 0; axis < D; ++axis) offsets[index(axis)] = around(cell, axis);
    heads<3>(offsets, found);
  }
  /// Finds those of the cells that have become neighbours by a step along `axis` into `cell`.
  void heads_ahead(std::uint32_t cell, int axis, bool up, Candidates& found) const {
    Offsets offsets;
    offsets[0] = around(cell, axis);
    offsets[0][0] = offsets[0][up ? 2 : 0];
    for (int other = 0, place = 1; other < D; ++other)
      if (other != axis) offsets[index(place++)] = around(cell, other);
    heads<1>(offsets, found);
  }
  /// Fetches the places that heads_around() will read.
  void prefetch_around(std::uint32_t cell) const {
    Offsets offsets;
    for (int axis = 0; axis < D; ++axis) offsets[index(axis)] = around(cell, axis);
    for (std::uint32_t row : offsets[1])
      if constexpr (D == 2)
        __builtin_prefetch(&head_[row + offsets[0][1]]);
      else
        for (std::uint32_t layer : offsets[2]) __builtin_prefetch(&head_[layer + row + offsets[0][1]]);
  }

  std::size_t bytes() const { return head_.capacity() * sizeof(std::uint32_t); }

 private:
  static constexpr int kBits = D == 2 ? 16 : 10;
  static constexpr std::uint32_t kMask = (1u << kBits) - 1;
  static constexpr double kFewestPeriodic = 4;
  static constexpr std::size_t index(int axis) { return static_cast<std::size_t>(axis); }

  Vector<D> corner(std::uint32_t cell, bool up) const {
    Vector<D> corner;
    for (int axis = 0; axis < D; ++axis) corner[axis] = edge(cell, axis, up);
    return corner;
  }
  /// Coordinate of the cell at `x` or, outside the box, of the nearest one.
  std::uint32_t coordinate_at(double x, int axis) const {
    return static_cast<std::uint32_t>(std::clamp(x * per_edge_[axis], 0.0, count_[index(axis)] - 1.0));
  }

  /// Places of the three neighbours along each axis, to be added up.
  using Offsets = std::array<std::array<std::uint32_t, 3>, D>;

  [[gnu::always_inline]] std::array<std::uint32_t, 3> around(std::uint32_t cell, int axis) const {
    const std::uint32_t here = coordinate(cell, axis), stride = stride_[index(axis)];
    const std::uint32_t low = here > 0 ? here - 1 : before_first_[index(axis)];
    const std::uint32_t high = here + 1 < count_[index(axis)] ? here + 1 : after_last_[index(axis)];
    return {low * stride, here * stride, high * stride};
  }

  template <int First>
  void heads(const Offsets& offsets, Candidates& found) const {
    found.clear();
    for (std::size_t i = 0; i < First; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if constexpr (D == 2) {
          found.add(head_[offsets[0][i] + offsets[1][j]]);
        } else {
          for (std::size_t k = 0; k < 3; ++k) found.add(head_[offsets[0][i] + offsets[1][j] + offsets[2][k]]);
        }
  }

  Geometry<D> geometry_;
  Vector<D> edge_, per_edge_, lowest_, highest_;
  std::array<std::uint32_t, D> count_, stride_, before_first_, after_last_;
  Column<std::uint32_t> head_;
};

/// One cell more to either side: rounding does not hide any.
template <int D>
template <class Visit>
void Cells<D>::for_each_between(const Vector<D>& low, const Vector<D>& high, Visit visit) const {
  if (!(low.array() <= high.array()).all()) return;
  std::array<std::uint32_t, D> first, last, here;
  for (int axis = 0; axis < D; ++axis) {
    first[index(axis)] = coordinate_at(low[axis] - edge_[axis], axis);
    last[index(axis)] = coordinate_at(high[axis] + edge_[axis], axis);
  }
  here = first;
  for (std::size_t axis = 0; axis < D;) {
    std::uint32_t cell = 0;
    for (std::size_t a = 0; a < D; ++a) cell |= here[a] << (kBits * a);
    visit(cell);
    for (axis = 0; axis < D && here[axis]++ == last[axis]; ++axis) here[axis] = first[axis];
  }
}

extern template class Cells<2>;
extern template class Cells<3>;

}  // namespace sandglass::event_driven
