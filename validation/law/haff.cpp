#include "validation/law/haff.hpp"

#include "validation/law/enskog.hpp"
#include "validation/law/sonine.hpp"

namespace sandglass::law {

namespace {
/// Share of the energy that a particle loses per collision, relative to T: (1-r^2)/D.
double loss_per_collision(int dimension, double restitution) {
  return (1 - restitution) * (1 + restitution) / dimension;
}
}  // namespace

double cooling_rate(const Gas& gas) {
  return loss_per_collision(gas.dimension, gas.restitution) * collision_rate(gas);
}

double cooling_rate_sonine(const Gas& gas) {
  return cooling_rate(gas) * sonine_cooling_factor(sonine_a2(gas.dimension, gas.restitution));
}

double haff_time_scale(const Gas& gas) { return 2 / cooling_rate(gas); }

double haff_time_scale_sonine(const Gas& gas) { return 2 / cooling_rate_sonine(gas); }

double haff_energy_ratio(double time, double time_scale) {
  const double slowing = 1 + time / time_scale;
  return 1 / (slowing * slowing);
}

double haff_collisions(double initial_rate, double time, double time_scale) {
  return initial_rate * time_scale * std::log1p(time / time_scale);
}

double haff_energy_ratio_of_collisions(int dimension, double restitution, double collisions) {
  return std::exp(-loss_per_collision(dimension, restitution) * collisions);
}

}  // namespace sandglass::law
