#pragma once

#include "sim/motion/parameters.hpp"
#include "sim/space/particle_store.hpp"

namespace sandglass::motion {

/// What walls and obstacles ask of a particle beside its phase.
template <int D>
struct Body {
  double mass = 1;
  Spin<D>* spin = nullptr;         ///< null: it has none
  double radius = 0, inertia = 1;  ///< of what spins
};

/// Kinetic energy, that of the spin included.
template <int D>
double energy_of(const Vector<D>& velocity, const Body<D>& body) {
  Vector<D> own = velocity;
  return energy_beside<D>(Vector<D>::Zero(), {own, body.spin, body.mass, body.radius, body.inertia});
}

/// The bodies of the particles of a store: all alike, or by their columns.
template <int D>
class Bodies {
 public:
  Bodies(const MotionParameters<D>& parameters, ParticleStore<D>& store)
      : Bodies(parameters, static_cast<const ParticleStore<D>&>(store)) {
    if (!parameters.species.empty()) spins_ = store.column(column::spin<D>).data();
  }
  /// Of particles whose spin nobody may change.
  Bodies(const MotionParameters<D>& parameters, const ParticleStore<D>& store)
      : mass_(parameters.mass), traits_(parameters.species) {
    if (!traits_.empty()) species_ = store.columns().get(column::species).data();
  }

  /// Of particles outside a store; null: all of the first species, or without spin.
  Bodies(const MotionParameters<D>& parameters, const std::uint8_t* species, Spin<D>* spins)
      : mass_(parameters.mass), traits_(parameters.species), species_(species), spins_(spins) {}

  Body<D> operator[](std::size_t i) const {
    if (traits_.empty()) return {mass_};
    const SpeciesTraits& kind = traits_[species_ == nullptr ? 0 : species_[i]];
    if (spins_ == nullptr) return {kind.mass};
    return {kind.mass, spins_ + i, kind.diameter / 2, kind.inertia};
  }

 private:
  double mass_;
  std::span<const SpeciesTraits> traits_;
  const std::uint8_t* species_ = nullptr;
  Spin<D>* spins_ = nullptr;
};

}  // namespace sandglass::motion
