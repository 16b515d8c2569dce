#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/worst.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// Rounding, not statistics: the bound is derived, no error bar enters.
//
// With e the machine epsilon, a sum of N numbers is off by at most N e times the sum of their magnitudes,
// twice (first and later sample). One collision changes two velocities with three rounded operations each;
// tau collisions per particle make N tau/2 collisions, so the rounding adds up to at most 3 e tau times the
// sum of magnitudes when the colliding particles are as fast as the average. Fast particles collide more
// often and have more to round: a factor 4. Energy is quadratic, so every relative error counts twice.

namespace sandglass {

namespace {
constexpr double epsilon = std::numeric_limits<double>::epsilon();

double rounding_bound(const Subject& subject, double collisions) {
  return epsilon * (2 * subject.particles() + 4 * 3 * collisions);
}

double largest_collisions(const Subject& subject) {
  double largest = 0;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    largest = std::max(
        largest, subject.collisions_per_particle(replica, subject.series(replica, "collisions")).back());
  return largest;
}

/// Largest drift since the first sample, over samples, components and replicas, relative to `scale` at the
/// start. Stays NaN when any sample is.
double largest_drift(const Subject& subject, const std::string& quantity, const std::string& scale) {
  double largest = 0;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Series& series = subject.series(replica, quantity);
    const double unit = std::abs(subject.series(replica, scale).value.front());
    const std::size_t width = series.quantity.size();
    for (std::size_t i = width; i < series.value.size(); ++i)
      keep_worst(largest, std::abs(series.value[i] - series.value[i % width]) / unit);
  }
  return largest;
}

Evidence drift_evidence(double drift, double bound) {
  Evidence evidence;
  evidence.value = drift;
  evidence.budget.systematic = bound;
  evidence.budget.reason = "rounding of sums and collisions";
  return evidence;
}

Evidence momentum_conservation(const Subject& subject, const law::Arguments&) {
  return drift_evidence(largest_drift(subject, "momentum", "momentum-scale"),
                        rounding_bound(subject, largest_collisions(subject)));
}

Evidence energy_conservation(const Subject& subject, const law::Arguments&) {
  return drift_evidence(largest_drift(subject, "energy", "energy"),
                        2 * rounding_bound(subject, largest_collisions(subject)));
}

bool is_elastic(const Scene& scene) {
  return is_uniform(scene) && scene.species.front().restitution == 1 && capabilities(scene).particles;
}

bool has_particles(const Scene& scene) { return is_uniform(scene) && capabilities(scene).particles; }
}  // namespace

std::vector<CheckInfo> conservation_checks() {
  return {{"momentum-conservation",
           "largest drift of the total momentum, relative to the sum of all momenta",
           "",
           {"momentum", "momentum-scale", "collisions"},
           false,
           {},
           has_particles,
           momentum_conservation},
          {"energy-conservation",
           "largest relative drift of the total energy of an elastic gas",
           "",
           {"energy", "collisions"},
           false,
           {},
           is_elastic,
           energy_conservation}};
}

}  // namespace sandglass
