#include "sim/method/collision_rate.hpp"

#include "sim/physics/contact_value.hpp"

namespace sandglass {

double mean_speed(int dimension, double thermal_speed) {
  return thermal_speed * std::sqrt(squared_mean_speed(dimension));
}

double thermal_speed(const Scene& scene) {
  if (scene.initial.uniform_velocity) return *scene.initial.uniform_velocity / std::sqrt(3);
  return std::sqrt(scene.initial.temperature / scene.species.front().mass);
}

/// Relative speeds of a Maxwellian pair of reduced mass M: sqrt(pi T / 2 M) in two dimensions, sqrt(8 T / pi M) in three;
/// Chapman & Cowling, ch. 5.
double rate_of_points(const Scene& scene, double temperature) {
  const int dimension = scene.domain.dimension;
  const double count = static_cast<double>(particle_count(scene));
  if (count == 0) return 0;
  double rate = 0;
  for (const Species& a : scene.species)
    for (const Species& b : scene.species) {
      const double reach = (a.diameter + b.diameter) / 2, mass = 1 / (1 / a.mass + 1 / b.mass);
      const double section = dimension == 2 ? 2 * reach : M_PI * reach * reach;
      const double speed = std::sqrt(squared_mean_speed(dimension) * temperature / mass);
      rate +=
          number_density(scene, a) * static_cast<double>(particle_count(scene, b)) / count * section * speed;
    }
  return rate;
}

double enskog_rate(const Scene& scene, double temperature) {
  return contact_formula(scene.domain.dimension)(fraction(scene)).value * rate_of_points(scene, temperature);
}

}  // namespace sandglass
