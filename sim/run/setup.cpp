#include "sim/run/setup.hpp"

#include "sim/base/error.hpp"
#include "sim/method/reservoir/reservoir.hpp"
#include "sim/physics/collision.hpp"
#include "sim/run/agents.hpp"
#include "sim/run/mutation.hpp"
#include "sim/scene/catalogue.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {

/// Simulated particles in a cell where the scene does not say how large cells are.
constexpr double kParticlesPerCell = 10;

template <int D>
Grid<D> make_grid(const Scene& scene, std::uint64_t particles) {
  Vector<D> box;
  std::array<std::uint32_t, D> cells;
  const double edge = scene.method.cell_size.value_or(std::pow(
      volume(scene.domain) * kParticlesPerCell / static_cast<double>(std::max<std::uint64_t>(particles, 1)),
      1.0 / D));
  double total = 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    box[static_cast<int>(axis)] = scene.domain.size[axis];
    const double wanted = scene.method.cells.empty()
                              ? std::max(1.0, std::round(scene.domain.size[axis] / edge))
                              : static_cast<double>(scene.method.cells[axis]);
    total *= wanted;
    if (total > 2e9)
      throw InputError(fmt::format(
          "the scene asks for more than {:.3g} cells; raise 'method.cell-size' or lower 'method.cells'",
          total));
    cells[axis] = static_cast<std::uint32_t>(wanted);
  }
  return Grid<D>(box, cells);
}

dsmc::Offset offset_of(const Scene& scene) {
  const Species& species = scene.species.front();
  const double d = species.diameter, r = species.restitution;
  switch (scene.method.offset) {
    case Offset::none:
      return {};
    case Offset::consistent:
      return {d, 0};
    // The offset carries m d r |c_n| a collision after the kick, hard cores carry m d (1 + r)/2 |c_n|.
    case Offset::corrected:
      return {d * (1 + r) / (2 * r), 0};
    case Offset::random:
      return {d, d * scene.method.random_offset};
  }
  return {};
}

template <int D>
dsmc::Parameters parameters_of(const Scene& scene) {
  const Species& species = scene.species.front();
  dsmc::Parameters parameters;
  parameters.diameter = species.diameter;
  parameters.mass = species.mass;
  parameters.restitution = species.restitution;
  parameters.cross_section = cross_section(D, species.diameter);
  parameters.weight = scene.method.weight;
  parameters.offset = offset_of(scene);
  if (scene.method.contact_factor == ContactFactor::local || is_event_driven(scene))
    parameters.factor = {contact_formula(D), scene.method.density == DensityEstimate::smoothed};
  return parameters;
}

template <int D>
dsmc::MotionParameters<D> motion_of(const Scene& scene) {
  dsmc::MotionParameters<D> motion;
  for (std::size_t axis = 0; axis < D; ++axis) {
    motion.walled[axis] = scene.domain.sides[axis][0] == Side::specular;
    if (!scene.gravity.empty()) motion.gravity[static_cast<int>(axis)] = scene.gravity[axis];
  }
  return motion;
}

double stream_speed(const Scene& scene, int axis) {
  return scene.initial.velocity.empty() ? 0 : scene.initial.velocity[static_cast<std::size_t>(axis)];
}

/// Crossings: five thermal speeds either side of the stream, with a bin edge at rest.
std::array<double, 2> default_range(const Scene& scene, int axis) {
  const double edge = 5 * thermal_speed(scene) + std::abs(stream_speed(scene, axis));
  return {-edge, edge};
}

ObserverSpec spec_of(const Scene& scene, const Observe& observe) {
  ObserverSpec spec;
  spec.what = observe.what;
  spec.axis = observe.axis;
  spec.position = observe.position;
  spec.range = observe.range.value_or(default_range(scene, observe.axis));
  spec.bins = observe.bins;
  spec.grid.assign(observe.grid.begin(), observe.grid.end());
  if (scene.initial.shear_wave) spec.periods = scene.initial.shear_wave->periods;
  return spec;
}

}  // namespace

bool is_reservoir(const Scene& scene) { return scene.method.preset == reservoir_preset; }

double thermal_speed(const Scene& scene) {
  return std::sqrt(scene.initial.temperature / scene.species.front().mass);
}

template <int D>
Setup<D> set_up(const Scene& scene, const Mutation& mutation) {
  const std::uint64_t particles = is_reservoir(scene) ? 0 : particle_count(scene);
  Setup<D> setup{
      make_grid<D>(scene, particles), parameters_of<D>(scene), motion_of<D>(scene), {}, {}, particles};
  plant(mutation, D, setup.parameters);
  if (is_event_driven(scene)) {
    setup.hard = hard_parameters_of<D>(scene);
    plant(mutation, setup.hard);
  }
  for (const Observe& observe : scene.observe) {
    setup.observers.push_back(spec_of(scene, observe));
    const Needs needs = needs_of(setup.observers.back());
    setup.parameters.measure_transfer |= needs.transfer;
    setup.hard.measure_transfer |= needs.transfer;
    setup.hard.impact_bins = std::max(setup.hard.impact_bins, needs.impact_bins);
  }
  setup.motion.offsets = setup.parameters.offset.any();
  return setup;
}

std::vector<Plane> make_planes(const std::vector<ObserverSpec>& observers) {
  std::vector<Plane> planes;
  for (const ObserverSpec& spec : observers)
    if (needs_of(spec).plane) planes.emplace_back(spec.axis, spec.position, bin_edges(spec));
  return planes;
}

namespace {
template <int D>
reservoir::Parameters reservoir_of(const Scene& scene, const Setup<D>& setup) {
  const int axis = setup.observers.empty() ? 0 : setup.observers.front().axis;
  reservoir::Parameters parameters;
  parameters.number_density = number_density(scene, scene.species.front());
  parameters.area = volume(scene.domain) / scene.domain.size[static_cast<std::size_t>(axis)];
  parameters.stream = stream_speed(scene, axis);
  parameters.thermal = thermal_speed(scene);
  return parameters;
}
}  // namespace

template <int D>
std::unique_ptr<Simulator<D>> make_simulator(const Scene& scene, const Setup<D>& setup,
                                             const Mutation& mutation, const Streams& streams,
                                             std::vector<Plane>* planes, EventSink<D>* trace) {
  if (is_event_driven(scene)) {
    event_driven::Parameters<D> hard = setup.hard;
    hard.planes = planes;
    return event_driven::make_event_driven<D>(hard, make_agents(scene, setup, planes), streams, trace);
  }
  if (is_reservoir(scene)) {
    reservoir::Parameters parameters = reservoir_of(scene, setup);
    plant(mutation, parameters.faults);
    return std::make_unique<reservoir::Reservoir<D>>(parameters, streams, planes);
  }
  dsmc::MotionParameters<D> motion = setup.motion;
  motion.planes = planes;
  std::vector<ColumnInfo> columns;
  if (scene.output.ids) columns.push_back(column::id);
  return std::make_unique<dsmc::Dsmc<D>>(setup.grid, setup.parameters, motion, streams, Purpose::collisions,
                                         columns);
}

template Setup<2> set_up<2>(const Scene&, const Mutation&);
template Setup<3> set_up<3>(const Scene&, const Mutation&);
template std::unique_ptr<Simulator<2>> make_simulator(const Scene&, const Setup<2>&, const Mutation&,
                                                      const Streams&, std::vector<Plane>*, EventSink<2>*);
template std::unique_ptr<Simulator<3>> make_simulator(const Scene&, const Setup<3>&, const Mutation&,
                                                      const Streams&, std::vector<Plane>*, EventSink<3>*);

}  // namespace sandglass
