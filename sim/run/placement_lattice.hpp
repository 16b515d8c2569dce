#pragma once

#include "sim/base/vector.hpp"
#include "sim/run/placement_room.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace sandglass {

/// Layers of sites along each axis of the box; all of them, or those of one colour of a checkerboard: a triangular lattice
/// in 2D and a face-centred cubic one in 3D, stretched to fit the box.
template <int D>
struct Lattice {
  Vector<D> box;
  std::array<std::uint64_t, D> layers;
  bool checkered = false;
  Vector<D> margin = Vector<D>::Zero();  ///< of the outermost layers to a wall; 0: half a spacing

  std::uint64_t points() const;
  bool has(std::uint64_t point) const;
  Vector<D> at(std::uint64_t point) const;
  /// Shortest way from one site to another, images included. Checkered lattices only.
  double nearest(const std::array<bool, D>& periodic) const;
};

/// Rectangular lattice of at least `count` sites with as square a cell as whole numbers allow.
template <int D>
Lattice<D> square_lattice(const Vector<D>& box, std::uint64_t count);

/// The same where no two sites, and no site and wall, are nearer than a diameter or a radius; none if there is none.
template <int D>
std::optional<Lattice<D>> fitting_square_lattice(const Vector<D>& box, std::uint64_t count, double diameter);

/// The checkered lattice of at least `count` sites whose sites are farthest apart, if that is a diameter.
template <int D>
std::optional<Lattice<D>> fitting_checkered_lattice(const Room<D>& room, std::uint64_t count,
                                                    double diameter);

/// Places for hard particles, spread over the sites that no obstacle covers. Throws InputError when they do not fit.
template <int D>
std::vector<Vector<D>> fitting_sites(const Room<D>& room, std::uint64_t count, double diameter);

}  // namespace sandglass
