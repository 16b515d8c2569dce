#include "sim/method/event_driven/event_driven.hpp"

#include "sim/method/event_driven/obstacle_agent.hpp"
#include "sim/method/event_driven/wall_agent.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <benchmark/benchmark.h>

// Collisions per second of the event-driven method: a periodic gas that has melted from a lattice, area fraction 0.25 or
// volume fraction 0.30, elastic; then a gas that cools, and the same gas with one feature at a time.

namespace sandglass::event_driven {
namespace {

struct Feature {
  double restitution = 1;
  bool mixture = false, rough = false, gravity = false, guard = false, impact = false, transfer = false,
       ids = false, walls = false, obstacles = false;
};

template <int D>
Parameters<D> parameters_of(double count, const Feature& feature) {
  Parameters<D> parameters;
  const double fraction = D == 2 ? 0.25 : 0.30;
  const double size = D == 2 ? M_PI / 4 : M_PI / 6;
  parameters.geometry.box.setConstant(std::pow(count * size / fraction, 1.0 / D));
  parameters.geometry.periodic.fill(true);
  if (feature.gravity) parameters.gravity[0] = 1e-6;
  if (feature.walls) parameters.geometry.periodic[0] = false;
  parameters.species[0].inertia = 0.1;
  parameters.rough = feature.rough;
  parameters.surfaces[0].normal.value = feature.restitution;
  if (feature.rough) parameters.surfaces[0].tangential = 1;
  if (feature.mixture) {
    parameters.species.assign(2, parameters.species[0]);
    parameters.surfaces.assign(4, parameters.surfaces[0]);
  }
  parameters.contact_time = feature.guard ? 1e-12 : 0;
  parameters.impact_bins = feature.impact ? 64 : 0;
  parameters.measure_transfer = feature.transfer;
  parameters.keep_ids = feature.ids;
  parameters.particles = static_cast<std::uint64_t>(count);
  return parameters;
}

/// Sum of uniform numbers: near enough to Maxwellian velocities, and the gas makes the rest.
double normal(Random& random) {
  double sum = -6;
  for (int draw = 0; draw < 12; ++draw) sum += random.uniform();
  return sum;
}

template <int D>
Particles<D> lattice(const Parameters<D>& parameters, std::uint64_t sites) {
  const StreamKey key(1, Purpose::velocities, 0, 0);
  const double spacing = parameters.geometry.box[0] / static_cast<double>(sites);
  Particles<D> particles;
  Vector<D> mean = Vector<D>::Zero();
  for (std::uint64_t i = 0; i < parameters.particles; ++i) {
    Random random(key, i);
    Phase<D> phase;
    std::uint64_t rest = i;
    for (int axis = 0; axis < D; ++axis, rest /= sites) {
      phase.position[axis] = spacing * (static_cast<double>(rest % sites) + 0.5);
      phase.velocity[axis] = normal(random);
    }
    mean += phase.velocity / static_cast<double>(parameters.particles);
    particles.phases.push_back(phase);
    if (parameters.species.size() > 1) particles.columns.append(column::species, i % 2);
  }
  for (Phase<D>& phase : particles.phases) phase.velocity -= mean;
  return particles;
}

/// Walls at both ends of axis 0; every 64th particle, where it is not near a side, fixed.
template <int D>
std::vector<std::unique_ptr<Agent<D>>> agents_of(const Parameters<D>& parameters, const Feature& feature,
                                                 Particles<D>& particles) {
  std::vector<std::unique_ptr<Agent<D>>> agents;
  for (const bool high : {false, true}) {
    const WallPlace<D> place{0, high, high ? parameters.geometry.box[0] : 0};
    if (feature.walls)
      agents.push_back(std::make_unique<WallAgent<D>>(place, WallRule{}, parameters.gravity));
  }
  if (!feature.obstacles) return agents;
  std::size_t number = 0;
  std::erase_if(particles.phases, [&](const Phase<D>& phase) {
    const bool inside = phase.position.minCoeff() > 2 &&
                        (parameters.geometry.box - phase.position).minCoeff() > 2 && number++ % 64 == 0;
    if (inside)
      agents.push_back(
          std::make_unique<ObstacleAgent<D>>(phase.position, 0.5, WallRule{}, parameters.gravity, 0.5));
    return inside;
  });
  return agents;
}

/// Time in which each particle collides once, at granular temperature one.
template <int D>
double collision_time(const Parameters<D>& parameters) {
  const double density = static_cast<double>(parameters.particles) / parameters.geometry.box.prod();
  const double contact = D == 2 ? (1 - 7 * 0.25 / 16) / (0.75 * 0.75) : (1 - 0.15) / (0.7 * 0.7 * 0.7);
  return 1 / ((D == 2 ? 2 : 4) * std::sqrt(M_PI) * density * contact);
}

/// An iteration is about one collision of every tenth particle, however far the gas has cooled.
template <int D>
void collisions(benchmark::State& state, Feature feature) {
  const auto sites =
      static_cast<std::uint64_t>(std::lround(std::pow(static_cast<double>(state.range(0)), 1.0 / D)));
  const Parameters<D> parameters = parameters_of<D>(std::pow(static_cast<double>(sites), D), feature);
  Particles<D> particles = lattice<D>(parameters, sites);
  const auto gas = make_event_driven<D>(parameters, agents_of(parameters, feature, particles), Streams{});
  gas->assign(particles);
  double dt = collision_time(parameters) / 10;
  std::uint64_t step = 0;
  for (; step < 40; ++step) gas->step(dt, step);
  const std::uint64_t before = gas->tally().collisions;
  std::uint64_t last = before;
  for (auto _ : state) {
    gas->step(dt, step++);
    const auto counted = static_cast<double>(gas->tally().collisions - last);
    last = gas->tally().collisions;
    dt *= std::clamp(static_cast<double>(parameters.particles) / 20 / counted, 0.9, 1.1);
  }
  const auto done = static_cast<double>(gas->tally().collisions - before);
  state.counters["collisions_per_second"] = benchmark::Counter(done, benchmark::Counter::kIsRate);
  state.counters["crossings_per_collision"] =
      gas->counters().at("cell-crossings") / static_cast<double>(gas->tally().collisions);
  state.counters["searches_per_collision"] =
      gas->counters().at("predictions") / static_cast<double>(gas->tally().collisions);
  state.counters["bytes_per_particle"] =
      static_cast<double>(gas->bytes()) / static_cast<double>(parameters.particles);
}

template <int D>
void register_features(const std::string& prefix) {
  const auto add = [&](const char* name, Feature feature, std::initializer_list<std::int64_t> sizes) {
    auto* bench = benchmark::RegisterBenchmark(
        (prefix + name).c_str(), [feature](benchmark::State& state) { collisions<D>(state, feature); });
    for (std::int64_t size : sizes) bench->Arg(size);
    bench->Unit(benchmark::kMillisecond);
  };
  add("elastic", {}, {10'000, 100'000, 1'000'000});
  const std::initializer_list<std::int64_t> one = {10'000};
  add("cooling", {.restitution = 0.9}, one);
  add("mixture", {.mixture = true}, one);
  add("rough", {.rough = true}, one);
  add("gravity", {.gravity = true}, one);
  add("guard", {.guard = true}, one);
  add("impact_parameters", {.impact = true}, one);
  add("virial", {.transfer = true}, one);
  add("ids", {.ids = true}, one);
  add("walls", {.walls = true}, one);
  add("obstacles", {.obstacles = true}, one);
}

const bool registered = [] {
  register_features<3>("3d_");
  register_features<2>("2d_");
  return true;
}();

}  // namespace
}  // namespace sandglass::event_driven
