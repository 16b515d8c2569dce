#pragma once

#include "sim/base/vector.hpp"

#include <cstddef>

namespace sandglass::event_driven {

/// Everything of one particle at one moment. What changes it writes here, a spin where it is kept.
template <int D>
struct ParticleState {
  Vector<D> position, velocity;
  Spin<D>* spin = nullptr;  ///< null: smooth
  double radius = 0.5, mass = 1, inertia = 0;
  std::size_t species = 0;
  bool guarded = false;  ///< by the TC model: a dissipative contact is elastic
};

/// A particle that comes in.
template <int D>
struct Newcomer {
  Vector<D> position, velocity;
  Spin<D> spin = Spin<D>::Zero();
  std::size_t species = 0;
};

}  // namespace sandglass::event_driven
