#include "validation/check/free_flight.hpp"

#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/law/enskog.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
law::Gas gas_of(const Scene& scene) {
  const Species& species = scene.species.front();
  return {scene.domain.dimension,    species.diameter,         species.mass,
          scene.initial.temperature, fraction(scene, species), species.restitution};
}

[[noreturn]] void too_short(const std::string& quantity, double from) {
  throw InputError(
      fmt::format("no sample of '{}' from time {} on: run longer, sample more often or lower 'settle-time'",
                  quantity, from));
}
}  // namespace

double collisions_in(const Scene& scene, double time) {
  return capabilities(scene).collisions ? law::collision_rate(gas_of(scene)) * time : 0;
}

double collisions_along(const Scene& scene, double length) {
  return collisions_in(scene, length / law::thermal_speed(gas_of(scene)));
}

bool is_plain_gas(const Scene& scene) {
  return capabilities(scene).particles && scene.species.size() == 1 && !is_rough(scene) &&
         scene.species.front().restitution == 1 && scene.given.empty() && !scene.initial.shear_wave &&
         scene.sources.empty() && !has_open_side(scene.domain);
}

bool is_weightless(const Scene& scene) {
  return std::all_of(scene.gravity.begin(), scene.gravity.end(), [](double g) { return g == 0; });
}

int vertical_axis(const Scene& scene) {
  int found = -1;
  for (std::size_t axis = 0; axis < scene.gravity.size(); ++axis) {
    if (scene.gravity[axis] == 0) continue;
    if (scene.gravity[axis] > 0 || found >= 0) return -1;
    found = static_cast<int>(axis);
  }
  return found;
}

bool is_periodic_along(const Scene& scene, std::size_t axis) {
  return scene.domain.sides[axis][0] == Side::periodic;
}

Wall wall_at(const Scene& scene, std::size_t axis, bool high) {
  for (const Wall& wall : scene.walls)
    if (wall.axis == static_cast<int>(axis) && wall.high == high) return wall;
  return {};
}

bool is_still(const Wall& wall) {
  return wall.amplitude == 0 &&
         std::all_of(wall.velocity.begin(), wall.velocity.end(), [](double v) { return v == 0; });
}

bool is_thermal_at_rest(const Wall& wall) {
  return is_still(wall) && wall.surface.rule == SurfaceKind::thermal;
}

bool is_mirror(const Wall& wall) {
  const SurfaceRule& rule = wall.surface;
  return is_still(wall) && rule.rule == SurfaceKind::specular && rule.restitution == 1 &&
         rule.tangential_restitution == -1;
}

double reach(const Scene& scene) { return touches(scene) ? scene.species.front().diameter / 2 : 0; }

Profile profile_along(const Subject& subject, std::size_t replica, std::size_t axis, double from, double to) {
  const Series& series = subject.series(replica, "fields");
  const std::size_t width = subject.scene().domain.size.size() + 2;
  const std::size_t bins = series.quantity.shape.at(axis);
  if (series.quantity.size() != bins * width)
    throw InputError("'fields' has more than one bin across the profile: give 1 along the other axes");
  const double particles_per_density =
      volume(subject.scene().domain) / static_cast<double>(bins) / subject.scene().method.weight;
  Profile profile{std::vector<double>(bins), std::vector<double>(bins)};
  std::vector<double> weights(bins);
  std::size_t samples = 0;
  for (std::size_t sample = 0; sample < series.samples(); ++sample) {
    if (series.time[sample] < from || series.time[sample] > to) continue;
    ++samples;
    for (std::size_t bin = 0; bin < bins; ++bin) {
      const double* values = &series.value[(sample * bins + bin) * width];
      const double weight = std::max(0.0, values[0] * particles_per_density - 1);
      profile.density[bin] += values[0];
      profile.temperature[bin] += weight * values[width - 1];
      weights[bin] += weight;
    }
  }
  if (samples == 0) too_short("fields", from);
  for (std::size_t bin = 0; bin < bins; ++bin) {
    profile.density[bin] /= static_cast<double>(samples);
    profile.temperature[bin] /= weights[bin];
  }
  return profile;
}

std::vector<double> late_samples(const Subject& subject, std::size_t replica, const std::string& quantity,
                                 const std::string& component, double from) {
  const std::vector<double>& time = subject.series(replica, quantity).time;
  const auto first = std::lower_bound(time.begin(), time.end(), from) - time.begin();
  std::vector<double> values = subject.column(replica, quantity, component);
  values.erase(values.begin(), values.begin() + first);
  if (values.empty()) too_short(quantity, from);
  return values;
}

}  // namespace sandglass
