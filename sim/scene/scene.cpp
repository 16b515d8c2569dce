#include "sim/scene/scene.hpp"

#include "sim/base/error.hpp"
#include "sim/base/maxwellian_flux.hpp"
#include "sim/scene/method/family.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace sandglass {

namespace {
bool rough(double tangential_restitution) { return tangential_restitution != -1; }

std::uint64_t count_given(const Scene& scene, const Species& species) {
  const auto match = [&](const GivenParticle& particle) {
    return particle.species < scene.species.size() && scene.species[particle.species].name == species.name;
  };
  return static_cast<std::uint64_t>(std::count_if(scene.given.begin(), scene.given.end(), match));
}
}  // namespace

std::string method_family(const Scene& scene) { return family_of(scene.method).name; }

bool is_rough(const Scene& scene) {
  const auto surface_rough = [](const auto& item) { return rough(item.surface.tangential_restitution); };
  return std::any_of(scene.species.begin(), scene.species.end(),
                     [](const Species& species) { return rough(species.tangential_restitution); }) ||
         std::any_of(scene.walls.begin(), scene.walls.end(), surface_rough) ||
         std::any_of(scene.obstacles.begin(), scene.obstacles.end(), surface_rough);
}

double volume(const Domain& domain) {
  return std::accumulate(domain.size.begin(), domain.size.end(), 1.0, std::multiplies<>());
}

bool has_open_side(const Domain& domain) {
  return std::any_of(domain.sides.begin(), domain.sides.end(), [](const std::array<Side, 2>& sides) {
    return sides[0] == Side::open || sides[1] == Side::open;
  });
}

double particle_volume(const Species& species, int dimension) {
  SANDGLASS_EXPECT(dimension == 2 || dimension == 3);
  const double d = species.diameter;
  return dimension == 2 ? std::numbers::pi / 4 * d * d : std::numbers::pi / 6 * d * d * d;
}

double largest_diameter(const Scene& scene) {
  double largest = 0;
  for (const Species& species : scene.species) largest = std::max(largest, species.diameter);
  return largest;
}

double inertia_factor(const Species& species, int dimension) {
  return species.inertia_factor.value_or(dimension == 2 ? 0.5 : 0.4);
}

std::uint64_t particle_count(const Scene& scene, const Species& species) {
  if (!scene.given.empty()) return count_given(scene, species);
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

std::uint64_t particle_count(const Scene& scene) {
  constexpr std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t total = 0;
  for (const Species& species : scene.species) {
    const std::uint64_t count = particle_count(scene, species);
    total = count > largest - total ? largest : total + count;
  }
  return total;
}

double fraction(const Scene& scene) {
  double total = 0;
  for (const Species& species : scene.species) total += fraction(scene, species);
  return total;
}

double lightest_weight(const Scene& scene) {
  double lightest = scene.method.weight;
  for (const Region& region : scene.regions) lightest = std::min(lightest, region.weight);
  return lightest;
}

double duration_of(const Scene& scene) {
  if (scene.run.duration.time) return *scene.run.duration.time;
  if (scene.run.duration.steps && scene.method.time_step.fixed)
    return static_cast<double>(*scene.run.duration.steps) * *scene.method.time_step.fixed;
  return std::numeric_limits<double>::infinity();
}

std::uint64_t poured_count(const Scene& scene) {
  double total = 0;
  for (const Source& source : scene.sources) {
    const double in_time = std::floor(source.rate * duration_of(scene));
    const double poured = source.count ? std::min(in_time, static_cast<double>(*source.count)) : in_time;
    if (std::isfinite(poured)) total += poured;
  }
  constexpr double largest = 9.2e18;
  return static_cast<std::uint64_t>(std::min(total, largest));
}

std::uint64_t added_count(const Scene& scene) {
  double filled = 0;
  for (const Inflow& inflow : scene.inflows) filled += inflow.number_density;
  filled *= volume(scene.domain) / scene.method.weight;
  const double missing = filled - static_cast<double>(particle_count(scene));
  constexpr double largest = 9.2e18;
  return poured_count(scene) + static_cast<std::uint64_t>(std::clamp(missing, 0.0, largest / 2));
}

namespace {
/// Of the inflow's particles per area and time that move inwards through a side with that inward normal.
double flux_into(const Scene& scene, const Inflow& inflow, std::size_t axis, bool high) {
  const double stream = inflow.velocity.empty() ? 0 : inflow.velocity[axis];
  const double thermal = std::sqrt(inflow.temperature / scene.species[inflow.species].mass);
  return inflow.number_density * maxwellian_flux(high ? -stream : stream, thermal);
}
}  // namespace

double inflow_rate(const Scene& scene, const Inflow& inflow) {
  const auto axis = static_cast<std::size_t>(inflow.axis);
  if (inflow.entry == InflowEntry::dispenser) {
    const double along = inflow.velocity.empty() ? 0 : inflow.velocity[axis];
    return inflow.number_density * std::fabs(along) * volume(scene.domain) / scene.domain.size[axis];
  }
  return flux_into(scene, inflow, axis, inflow.high) * volume(scene.domain) / scene.domain.size[axis] /
         scene.method.weight;
}

double layer_count(const Scene& scene, const Inflow& inflow) {
  const double side = volume(scene.domain) / scene.domain.size[static_cast<std::size_t>(inflow.axis)];
  return std::max(1.0, std::ceil(inflow.number_density * scene.species[inflow.species].diameter * side));
}

double neglected_return(const Scene& scene, std::size_t axis, bool high) {
  double entering = 0, missing = 0;
  for (const Inflow& inflow : scene.inflows) {
    entering += flux_into(scene, inflow, static_cast<std::size_t>(inflow.axis), inflow.high);
    missing += flux_into(scene, inflow, axis, high);
  }
  return missing / entering;
}

std::optional<std::size_t> gravity_axis(const Scene& scene) {
  std::optional<std::size_t> found;
  for (std::size_t axis = 0; axis < scene.gravity.size(); ++axis) {
    if (scene.gravity[axis] == 0) continue;
    if (found) return std::nullopt;
    found = axis;
  }
  return found;
}

double pouring_speed(const Scene& scene, const Source& source) {
  const std::optional<std::size_t> axis = gravity_axis(scene);
  if (!axis || *axis >= source.velocity.size()) return 0;
  return scene.gravity[*axis] < 0 ? -source.velocity[*axis] : source.velocity[*axis];
}

double falling_speed(const Scene& scene, const Source& source) {
  const std::optional<std::size_t> axis = gravity_axis(scene);
  const double pull = axis ? std::fabs(scene.gravity[*axis]) : 0;
  return std::max(pouring_speed(scene, source), std::sqrt(2 * pull * largest_diameter(scene)));
}

}  // namespace sandglass
