#pragma once

#include "sim/base/random.hpp"
#include "sim/observe/view.hpp"
#include "sim/physics/wall.hpp"

#include <array>
#include <vector>

namespace sandglass::motion {

/// One side of the box. Its plane stands at edge + velocity[axis] t + amplitude sin(2 pi frequency t); particles touch it
/// with their centre.
template <int D>
struct WallPlace {
  int axis = 0;
  bool high = false;
  double edge = 0;                         ///< coordinate at time zero
  Vector<D> velocity = Vector<D>::Zero();  ///< constant; its part along the axis moves the plane
  double amplitude = 0, frequency = 0;     ///< of a vibration along the axis; cycles per time
  WallRule rule = {};

  bool vibrates() const { return amplitude != 0 && frequency != 0; }
  bool moves() const { return velocity[axis] != 0 || vibrates(); }
};

/// A disk or sphere that stands still inside the box, touched with the particle's centre.
template <int D>
struct ObstaclePlace {
  Vector<D> centre;
  double radius;
  WallRule rule = {};
};

/// What particles do between collisions.
template <int D>
struct MotionParameters {
  Vector<D> gravity = Vector<D>::Zero();
  double mass = 1;  ///< of each particle; thermal walls ask
  /// Of each species, where there are several or particles spin; then columns of the particles tell the rest.
  std::vector<SpeciesTraits> species = {};
  std::array<bool, D>
      walled{};          ///< per axis: not periodic; at each end stands a wall, unless that side is open
  bool offsets = false;  ///< collisions may have put particles outside the walls or into obstacles
  std::array<std::array<bool, 2>, D>
      open{};  ///< per walled axis: the low, the high side lets particles out for good
  std::vector<WallPlace<D>> walls = {};  ///< a walled side not named here is smooth, elastic and at rest
  std::vector<ObstaclePlace<D>> obstacles = {};
  std::vector<Plane>* planes = nullptr;
  WallImpulses<D>* impulses = nullptr;  ///< null: what walls take is not counted

  bool has_open_side() const {
    for (const auto& [low, high] : open)
      if (low || high) return true;
    return false;
  }
  /// What walls take depends on the species of the particle.
  bool weighs() const { return species.size() > 1 && impulses != nullptr; }
  bool counts() const { return (planes != nullptr && !planes->empty()) || impulses != nullptr; }
  bool walls_move() const {
    for (const WallPlace<D>& wall : walls)
      if (wall.moves()) return true;
    return false;
  }
};

/// The same surroundings at rest, closed, smooth and elastic, without gravity: they keep the energy of a gas that comes to
/// equilibrium.
template <int D>
MotionParameters<D> conserving(MotionParameters<D> parameters) {
  parameters.gravity.setZero();
  parameters.walls.clear();
  parameters.open = {};
  for (ObstaclePlace<D>& obstacle : parameters.obstacles) obstacle.rule = {};
  return parameters;
}

/// When a flight happens, and the key of what walls draw in it.
struct MotionStep {
  double dt = 0;
  double time = 0;     ///< at the start of the step: moving walls ask
  StreamKey key = {};  ///< Purpose::walls of this step
};

}  // namespace sandglass::motion
