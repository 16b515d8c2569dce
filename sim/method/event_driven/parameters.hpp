#pragma once

#include "sim/method/event_driven/cells.hpp"
#include "sim/method/event_driven/faults.hpp"
#include "sim/observe/view.hpp"
#include "sim/physics/contact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace sandglass::event_driven {

/// Species of those behind a filter, of a scene with one species of its own.
inline constexpr std::size_t kHeavy = 1;

/// Particles that have passed a filter: to all others a wall that moves with the stream.
template <int D>
struct HeavyParticles {
  Vector<D> velocity = Vector<D>::Zero();
  std::size_t side = 0;  ///< takes what others give them
};

template <int D>
struct Parameters {
  Geometry<D> geometry;
  std::vector<SpeciesTraits> species{{}};
  std::vector<Surface> surfaces{{}};  ///< of species a with species b at [a * number of species + b]
  bool rough = false;                 ///< particles have spin
  double contact_time = 0;            ///< TC model: elastic sooner than this after the last collision; 0: off
  Vector<D> gravity = Vector<D>::Zero();
  bool measure_transfer = false;
  std::size_t impact_bins = 0;
  bool count_by_species = false;  ///< Tally::by_species
  bool keep_ids = false;
  std::uint64_t particles = 0;             ///< how many there will be, for the size of the cells
  std::uint64_t obstacles = 0;             ///< likewise
  std::vector<Plane>* planes = nullptr;    ///< those that agents count for
  WallImpulses<D>* impulses = nullptr;     ///< takes what comes in by the sides
  std::optional<HeavyParticles<D>> heavy;  ///< behind a filter; the last of `species`, unknown to the scene
  Faults faults;

  const Surface& surface(std::size_t a, std::size_t b) const { return surfaces[a * species.size() + b]; }
  /// Species of the scene.
  std::size_t own_species() const { return species.size() - (heavy ? 1 : 0); }
  double largest_diameter() const {
    double largest = 0;
    for (const SpeciesTraits& kind : species) largest = std::max(largest, kind.diameter);
    return largest;
  }
  /// Contacts reach into the neighbouring cells only. In a thin gas larger cells, with about two particles in three of
  /// them, balance the crossings against the candidates of a search; but six along a periodic axis if they fit, so that
  /// particles of neighbouring cells stay clear of half a box apart, where rounding would choose between two images.
  /// Among many obstacles smaller ones, with about ten of these.
  double cell_edge() const {
    const double count = static_cast<double>(std::max({particles, obstacles / 16, std::uint64_t{1}}));
    double edge = 0.8 * std::pow(geometry.box.prod() / count, 1.0 / D);
    for (int axis = 0; axis < D; ++axis)
      if (geometry.periodic[static_cast<std::size_t>(axis)]) edge = std::min(edge, geometry.box[axis] / 6);
    return std::max(largest_diameter() * (1 + 1e-9), edge);
  }
};

}  // namespace sandglass::event_driven
