#include "sim/run/equilibrate.hpp"

#include "sim/base/error.hpp"
#include "sim/base/stop_request.hpp"
#include "sim/run/time_step.hpp"

#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {

constexpr std::uint64_t kPatience = 1'000'000;  // steps without a collision

[[noreturn]] void refuse_standstill(double steps) {
  throw InputError(fmt::format(
      "equilibration: no collision in {} steps; lower "
      "'initial.equilibrate-collisions-per-particle', raise 'method.time-step' or use more particles",
      steps));
}

/// Ends after `wanted` collisions.
template <int D>
void collide(Simulator<D>& gas, const Setup<D>& setup, double wanted) {
  const double fixed = setup.method->elastic_step();
  if (!std::isfinite(fixed)) refuse_standstill(0);
  TimeStepper<D> stepper(setup);
  std::uint64_t seen = 0, last = 0;  // collisions, and the step of the last one
  for (std::uint64_t step = 0; static_cast<double>(gas.tally().collisions) < wanted; ++step) {
    stop_request.heed();
    gas.step(fixed > 0 ? fixed : stepper.next(gas.view(), step), step);
    if (gas.tally().collisions > seen) last = step;
    seen = gas.tally().collisions;
    if (step - last >= kPatience) refuse_standstill(kPatience);
  }
}

}  // namespace

template <int D>
void equilibrate(Particles<D>& particles, const Setup<D>& setup, const Streams& streams) {
  const auto gas = setup.method->build_elastic(streams);
  gas->assign(particles);
  const double count = static_cast<double>(particles.phases.size());
  collide(*gas, setup, setup.scene.initial.equilibrate_collisions * count / 2);
  const auto after = gas->view().particles;
  const auto ids = gas->ids();
  for (std::size_t i = 0; i < after.size(); ++i) particles.phases[ids.empty() ? i : ids[i]] = after[i];
}

template void equilibrate(Particles<2>&, const Setup<2>&, const Streams&);
template void equilibrate(Particles<3>&, const Setup<3>&, const Streams&);

}  // namespace sandglass
