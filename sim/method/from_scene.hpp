#pragma once

#include "sim/base/vector.hpp"
#include "sim/observe/view.hpp"
#include "sim/physics/wall.hpp"
#include "sim/scene/scene.hpp"

#include <array>
#include <vector>

// Values of a scene in the terms of sim/physics, for every family that takes them.

namespace sandglass {

/// Zero for an empty list.
template <int D>
Vector<D> vector_of(const std::vector<double>& values) {
  return values.empty() ? Vector<D>(Vector<D>::Zero())
                        : Vector<D>(Eigen::Map<const Vector<D>>(values.data()));
}

template <int D>
std::array<bool, D> periodic_axes(const Scene& scene) {
  std::array<bool, D> periodic{};
  for (std::size_t axis = 0; axis < D; ++axis) periodic[axis] = scene.domain.sides[axis][0] == Side::periodic;
  return periodic;
}

/// Of the velocity-dependent collapse guard; zero without.
double reference_speed(const Scene& scene);
/// Surface of a particle. The velocity-dependent guard holds for it.
Surface surface_of(const Scene& scene, const Species& species);
/// Diameter, mass and moment of inertia of each species.
std::vector<SpeciesTraits> traits_of(const Scene& scene);
/// Of species a with species b at [a * number of species + b].
std::vector<Surface> surfaces_of(const Scene& scene);
/// Rule of a wall or obstacle. The velocity-dependent guard holds there as well: a ball on the floor collapses as a row
/// of particles does.
WallRule wall_rule_of(const Scene& scene, const SurfaceRule& surface);
/// What the scene says of a side, or a smooth elastic wall at rest.
Wall wall_of(const Scene& scene, int axis, bool high);

}  // namespace sandglass
