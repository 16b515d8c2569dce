#include "sim/run/setup.hpp"

#include "sim/method/boundary_faults.hpp"
#include "sim/method/collision_rate.hpp"
#include "sim/run/families.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "sim/scene/observe/observers.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass {

namespace {

/// Velocities: five thermal speeds either side of the stream, with a bin edge at rest.
std::array<double, 2> default_range(const Scene& scene, int axis) {
  const std::vector<double>& stream = scene.initial.velocity;
  const double speed = stream.empty() ? 0 : std::abs(stream[static_cast<std::size_t>(axis)]);
  const double edge = 5 * thermal_speed(scene) + speed;
  return {-edge, edge};
}

void choose_ranges(Scene& scene) {
  for (Observe& observe : scene.observe)
    if (observer_uses(observe.what, "range") && !observe.range)
      observe.range = default_range(scene, observe.axis);
}

ObserverSpec spec_of(const Scene& scene, const Observe& observe) {
  ObserverSpec spec;
  spec.what = observe.what;
  spec.axis = observe.axis;
  spec.position = observe.position;
  spec.range = observe.range.value_or(spec.range);
  spec.bins = observe.bins;
  spec.grid.assign(observe.grid.begin(), observe.grid.end());
  for (std::size_t axis = 0; axis < scene.domain.sides.size(); ++axis)
    if (scene.domain.sides[axis][0] != Side::periodic) spec.bounded.push_back(static_cast<int>(axis));
  for (const Species& species : scene.species) spec.species.push_back(species.name);
  if (scene.initial.shear_wave) spec.periods = scene.initial.shear_wave->periods;
  return spec;
}

}  // namespace

Needs needs_of(const std::vector<ObserverSpec>& observers) {
  Needs all;
  for (const ObserverSpec& spec : observers) {
    const Needs needs = needs_of(spec);
    all.transfer |= needs.transfer;
    all.plane |= needs.plane;
    all.walls |= needs.walls;
    all.by_species |= needs.by_species;
    all.impact_bins = std::max(all.impact_bins, needs.impact_bins);
  }
  return all;
}

template <int D>
Setup<D> set_up(const Scene& scene, const std::string& planted_fault) {
  const Scene faulty = with_scene_fault(scene, planted_fault);
  Setup<D> setup{scene,
                 {},
                 nullptr,
                 capabilities(scene).particles ? particle_count(scene) : 0,
                 faulty.sources,
                 faulty.inflows,
                 faulty.method.time_step};
  choose_ranges(setup.scene);
  for (const Observe& observe : setup.scene.observe) setup.observers.push_back(spec_of(setup.scene, observe));
  setup.method = make_builder<D>({setup.scene, needs_of(setup.observers), planted_fault});
  setup.method->record_choices(setup.scene);
  if (!scene.regions.empty()) setup.weights.emplace(scene);
  return setup;
}

std::vector<Plane> make_planes(const std::vector<ObserverSpec>& observers) {
  std::vector<Plane> planes;
  for (const ObserverSpec& spec : observers)
    if (needs_of(spec).plane) planes.emplace_back(spec.axis, spec.position, bin_edges(spec));
  return planes;
}

template Setup<2> set_up<2>(const Scene&, const std::string&);
template Setup<3> set_up<3>(const Scene&, const std::string&);

}  // namespace sandglass
