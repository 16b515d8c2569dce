#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace sandglass {

/// barometric: as a gas at rest under gravity, exp(-m g z / T) between two walls. layers: a lattice with the species in
/// their order from the top down.
enum class Positions { random, lattice, random_without_overlap, barometric, layers };

struct ShearWave {
  double amplitude = 0;  ///< velocity along axis 0, as a sine of the position along axis 1
  int periods = 1;       ///< whole periods over the domain
  bool operator==(const ShearWave&) const = default;
};

/// The initial state, unless `Scene::given` lists the particles: then all but the last keeps its defaults, unused.
struct Initial {
  Positions positions = Positions::random;
  double temperature = 1;        ///< granular temperature m<C^2>/D
  std::vector<double> velocity;  ///< stream velocity; empty: at rest
  bool exact = true;             ///< remove the sampled mean velocity and scale to exactly `temperature`
  std::optional<ShearWave> shear_wave;
  double equilibrate_collisions = 0;  ///< elastic collisions per particle before time zero
  double spin_temperature = 0;        ///< rotational granular temperature I<w^2>/(degrees of freedom)
  std::optional<double> uniform_velocity = {};  ///< components even over +- this, instead of a temperature
  double velocity_rounding = 0;  ///< of given particles: components even over what is given +- this
  bool operator==(const Initial&) const = default;
};

/// A particle that the scene places itself.
struct GivenParticle {
  std::vector<double> position;
  std::vector<double> velocity;
  std::vector<double> spin;  ///< angular velocity: one component in 2D, three in 3D; empty: none
  std::size_t species = 0;   ///< index into Scene::species
  bool operator==(const GivenParticle&) const = default;
};

}  // namespace sandglass
