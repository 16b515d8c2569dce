#pragma once

#include "sim/method/event_driven/particle.hpp"
#include "sim/method/event_driven/particle_state.hpp"
#include "sim/method/simulator.hpp"
#include "sim/space/scatter.hpp"

namespace sandglass::event_driven {

/// Columns beside those that every gas has.
struct OptionalColumns {
  bool spins = false, species = false, last_contact = false, ids = false;
};

/// The particles, sorted by cell at the beginning of each era. Columns that the scene does not need stay empty.
template <int D>
struct Gas {
  Column<Particle<D>> particles;
  Column<Next> next;
  Column<Spin<D>> spins;           ///< rough particles
  Column<std::uint8_t> species;    ///< several species
  Column<double> last_contact;     ///< TC model
  std::vector<std::uint64_t> ids;  ///< if they are kept
  OptionalColumns kept;
  std::uint32_t gone = 0;  ///< particles that have left and whose places are still there

  /// Places, those of particles that have left included.
  std::uint32_t size() const { return static_cast<std::uint32_t>(particles.size()); }
  std::size_t kind(std::uint32_t particle) const { return species.empty() ? 0 : species[particle]; }

  void assign(const Particles<D>& start, const OptionalColumns& columns);
  /// A new particle, at the last place, in no cell yet.
  void append(const Newcomer<D>& newcomer, double time, std::uint64_t id);
  /// It has left. Whoever expects it finds it changed.
  void drop(std::uint32_t particle);
  bool is_here(std::uint32_t particle) const { return next[particle].exit != kNobody; }
  /// Places of those who are here, in their order.
  std::vector<std::uint32_t> places() const;
  /// Gives up the places of those who have left.
  void close_ranks();
  /// Puts the particle of place `order[i]` at place i, and renames the partners.
  void reorder(const std::vector<std::uint32_t>& order);
  /// Lets all times count from `origin`.
  void rebase(double origin);
  std::size_t bytes() const;
};

extern template struct Gas<2>;
extern template struct Gas<3>;

}  // namespace sandglass::event_driven
