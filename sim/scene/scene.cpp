#include "sim/scene/scene.hpp"

#include "sim/base/error.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace sandglass {

double volume(const Domain& domain) {
  return std::accumulate(domain.size.begin(), domain.size.end(), 1.0, std::multiplies<>());
}

double particle_volume(const Species& species, int dimension) {
  SANDGLASS_EXPECT(dimension == 2 || dimension == 3);
  const double d = species.diameter;
  return dimension == 2 ? std::numbers::pi / 4 * d * d : std::numbers::pi / 6 * d * d * d;
}

std::uint64_t particle_count(const Scene& scene, const Species& species) {
  if (species.count) return *species.count;
  const double density = species.number_density ? *species.number_density
                                                : species.fraction.value_or(0) /
                                                      particle_volume(species, scene.domain.dimension);
  const double wanted = std::round(density * volume(scene.domain) / scene.method.weight);
  if (!(wanted > 0)) return 0;
  constexpr double largest = 9.2e18;  // below 2^63: what a TOML integer can hold
  return wanted < largest ? static_cast<std::uint64_t>(wanted) : static_cast<std::uint64_t>(largest);
}

double number_density(const Scene& scene, const Species& species) {
  const double count = static_cast<double>(particle_count(scene, species));
  return count * scene.method.weight / volume(scene.domain);
}

double fraction(const Scene& scene, const Species& species) {
  return number_density(scene, species) * particle_volume(species, scene.domain.dimension);
}

}  // namespace sandglass
