#pragma once

#include "sim/base/random.hpp"
#include "sim/space/lattice_of_cells.hpp"

#include <optional>
#include <vector>

// Lattices for tests, and the middles of diagonal cells counted out one by one.

namespace sandglass {

inline Random stream(std::uint64_t index) { return {StreamKey(3, Purpose::positions, 0, 0), index}; }

template <int D>
Vector<D> inside(const Vector<D>& box, Random& random) {
  Vector<D> position;
  for (int axis = 0; axis < D; ++axis) position[axis] = box[axis] * random.uniform();
  return position;
}

template <int D, class Function>
void for_each_periodicity(Function function) {
  for (unsigned bits = 0; bits < 1u << D; ++bits) {
    std::array<bool, D> periodic;
    for (unsigned axis = 0; axis < D; ++axis) periodic[axis] = (bits >> axis & 1) != 0;
    function(periodic);
  }
}

template <class Function>
void for_each_diagonal(Function function) {
  for (const std::array<std::uint32_t, 2> corners : {std::array{3u, 5u}, {4u, 2u}, {1u, 3u}, {1u, 1u}})
    for_each_periodicity<2>([&](const std::array<bool, 2>& periodic) {
      function(LatticeOfCells<2>::diagonal(Grid<2>(Vector<2>(2.3, 10.0 / 3), corners), periodic));
    });
}

template <int D, class Function>
void for_each_shifted(Function function) {
  const std::array<std::uint32_t, 3> several{4, 3, 2}, single{1, 5, 2};
  for (const auto& cells : {several, single})
    for (const double part : {-0.5, -0.2, 0.0, 0.4})
      for_each_periodicity<D>([&](const std::array<bool, D>& periodic) {
        std::array<std::uint32_t, D> numbers;
        std::copy_n(cells.begin(), D, numbers.begin());
        const Grid<D> grid(Vector<3>(2.3, 10.0 / 3, 1.9).template head<D>(), numbers);
        auto lattice = LatticeOfCells<D>::shifted(grid, periodic);
        lattice.shift(Vector<3>(part, -0.7 * part, 0.1).template head<D>());
        function(lattice);
      });
}

/// Whether the far edge is one with the near one.
template <int D>
bool is_periodic(const LatticeOfCells<D>& lattice, int axis) {
  if constexpr (D == 2)
    if (lattice.diagonal_cells())
      return lattice.diagonal_cells()->points()[static_cast<std::size_t>(axis)] == 2 * lattice.cells(axis);
  return lattice.shifted_cells()->periodic(axis);
}

template <int D>
std::array<bool, D> periodic_axes(const LatticeOfCells<D>& lattice) {
  std::array<bool, D> periodic;
  for (int axis = 0; axis < D; ++axis) periodic[static_cast<std::size_t>(axis)] = is_periodic(lattice, axis);
  return periodic;
}

inline Vector<2> half_diagonal(const LatticeOfCells<2>& lattice) {
  const Vector<2>& box = lattice.grid().box();
  return {box[0] / (2 * lattice.cells(0)), box[1] / (2 * lattice.cells(1))};
}

/// The shortest of a way and its images, in half diagonals.
inline Vector<2> half_diagonals(const LatticeOfCells<2>& lattice, Vector<2> way) {
  for (int axis = 0; axis < 2; ++axis) {
    const double length = lattice.grid().box()[axis];
    if (is_periodic(lattice, axis)) way[axis] -= length * std::round(way[axis] / length);
  }
  return way.cwiseQuotient(half_diagonal(lattice));
}

/// In the order of the cells.
inline std::vector<Vector<2>> middles_of_diagonal(const LatticeOfCells<2>& lattice) {
  const Vector<2> half = half_diagonal(lattice);
  std::vector<Vector<2>> middles;
  for (std::uint32_t row = 0; row <= 2 * lattice.cells(1) - is_periodic(lattice, 1); ++row)
    for (std::uint32_t column = row % 2; column <= 2 * lattice.cells(0) - is_periodic(lattice, 0);
         column += 2)
      middles.emplace_back(column * half[0], row * half[1]);
  return middles;
}

/// None behind a wall.
inline std::optional<Vector<2>> wrapped(const LatticeOfCells<2>& lattice, Vector<2> position) {
  for (int axis = 0; axis < 2; ++axis) {
    const double length = lattice.grid().box()[axis], rounding = 1e-12 * length;
    double& x = position[axis];
    if (is_periodic(lattice, axis)) {
      x -= length * std::floor((x + rounding) / length);
    } else if (x < -rounding || x > length + rounding) {
      return std::nullopt;
    }
  }
  return position;
}

}  // namespace sandglass
