#include "sim/run/equilibrate.hpp"

#include "sim/base/error.hpp"
#include "sim/physics/contact_value.hpp"
#include "sim/run/agents.hpp"
#include "sim/run/time_step.hpp"

#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {

double wanted_collisions(const Scene& scene, std::size_t particles) {
  return scene.initial.equilibrate_collisions * static_cast<double>(particles) / 2;
}

template <int D>
void equilibrate_monte_carlo(Particles<D>& particles, const Scene& scene, const Setup<D>& setup,
                             const Streams& streams) {
  dsmc::Parameters elastic = setup.parameters;
  elastic.restitution = 1;
  elastic.measure_transfer = false;
  dsmc::MotionParameters<D> motion = setup.motion;
  motion.gravity.setZero();
  dsmc::Dsmc<D> gas(setup.grid, elastic, motion, streams, Purpose::equilibration);
  gas.assign(particles);
  TimeStepper<D> stepper(scene, setup);
  const double wanted = wanted_collisions(scene, particles.phases.size());
  for (std::uint64_t step = 0; static_cast<double>(gas.tally().collisions) < wanted; ++step) {
    if (step > 1'000'000 && gas.tally().collisions == 0)
      throw InputError(
          "equilibration: no collision in a million steps; lower "
          "'initial.equilibrate-collisions-per-particle' or raise 'method.time-step'");
    gas.step(stepper.next(gas.view(), step), step);
  }
  const auto after = gas.view().particles;
  particles.phases.assign(after.begin(), after.end());
}

/// Hard particles without loss, spin or weight, and no fault planted into what they do.
template <int D>
Setup<D> elastic_setup(const Setup<D>& setup) {
  Setup<D> elastic = setup;
  event_driven::Parameters<D>& hard = elastic.hard;
  hard.surfaces.assign(hard.surfaces.size(), Surface{});
  hard.rough = false;
  hard.contact_time = 0;
  hard.gravity.setZero();
  hard.measure_transfer = false;
  hard.impact_bins = 0;
  hard.keep_ids = true;
  hard.planes = nullptr;
  hard.faults = {};
  return elastic;
}

/// Walls and obstacles at rest, smooth and elastic.
Scene elastic_scene(const Scene& scene) {
  Scene elastic = scene;
  elastic.walls.clear();
  for (Obstacle& obstacle : elastic.obstacles) obstacle.surface = {};
  elastic.method.guard = CollapseGuard::none;
  return elastic;
}

[[noreturn]] void refuse_standstill(double free_times) {
  throw InputError(
      fmt::format("equilibration: no collision in {} mean free times; lower "
                  "'initial.equilibrate-collisions-per-particle' or use more particles",
                  free_times));
}

template <int D>
void equilibrate_hard(Particles<D>& particles, const Scene& scene, const Setup<D>& setup,
                      const Streams& streams) {
  constexpr double kFreeTimes = 0.1;           // a step
  constexpr std::uint64_t kPatience = 100000;  // steps
  const Setup<D> elastic = elastic_setup(setup);
  const auto gas = event_driven::make_event_driven<D>(
      elastic.hard, make_agents<D>(elastic_scene(scene), elastic, nullptr), streams);
  gas->assign(particles);
  const double dt = kFreeTimes / enskog_rate(scene, scene.initial.temperature);
  const double wanted = wanted_collisions(scene, particles.phases.size());
  if (!std::isfinite(dt)) refuse_standstill(0);
  std::uint64_t seen = 0, last = 0;  // collisions, and the step of the last one
  for (std::uint64_t step = 0; static_cast<double>(gas->tally().collisions) < wanted; ++step) {
    gas->step(dt, step);
    if (gas->tally().collisions > seen) last = step;
    seen = gas->tally().collisions;
    if (step - last >= kPatience) refuse_standstill(kFreeTimes * kPatience);
  }
  const auto after = gas->view().particles;
  for (std::size_t i = 0; i < after.size(); ++i) particles.phases[gas->ids()[i]] = after[i];
}

}  // namespace

/// Relative speeds of a Maxwellian pair of reduced mass M: sqrt(pi T / 2 M) in two dimensions, sqrt(8 T / pi M) in three;
/// Chapman & Cowling, ch. 5.
double enskog_rate(const Scene& scene, double temperature) {
  const int dimension = scene.domain.dimension;
  const double count = static_cast<double>(particle_count(scene));
  double rate = 0;
  for (const Species& a : scene.species)
    for (const Species& b : scene.species) {
      const double reach = (a.diameter + b.diameter) / 2, mass = 1 / (1 / a.mass + 1 / b.mass);
      const double section = dimension == 2 ? 2 * reach : M_PI * reach * reach;
      const double speed = std::sqrt(squared_mean_speed(dimension) * temperature / mass);
      rate +=
          number_density(scene, a) * static_cast<double>(particle_count(scene, b)) / count * section * speed;
    }
  return contact_formula(dimension)(fraction(scene)).value * rate;
}

template <int D>
void equilibrate(Particles<D>& particles, const Scene& scene, const Setup<D>& setup, const Streams& streams) {
  if (is_event_driven(scene))
    equilibrate_hard(particles, scene, setup, streams);
  else
    equilibrate_monte_carlo(particles, scene, setup, streams);
}

template void equilibrate(Particles<2>&, const Scene&, const Setup<2>&, const Streams&);
template void equilibrate(Particles<3>&, const Scene&, const Setup<3>&, const Streams&);

}  // namespace sandglass
