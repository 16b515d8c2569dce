#include "sim/run/time_step.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/sums.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

template <int D>
TimeStepper<D>::TimeStepper(const Setup<D>& setup) {
  const Scene& scene = setup.scene;
  const TimeStep& step = scene.method.time_step;
  fixed_ = step.fixed.value_or(0);
  if (step.fixed) return;
  wanted_ = step.collisions.value();
  rate_at_one_ = setup.method->collision_rate(1);
  particles_ = static_cast<double>(setup.particles);
  // Without a drive the temperature falls by (1 - r^2)/D per collision of each particle: look again every half per cent.
  const double loss =
      (1 - scene.species.front().restitution * scene.species.front().restitution) / D * wanted_;
  if (scene.gravity.empty())
    refresh_ = static_cast<std::uint64_t>(std::clamp(0.005 / std::max(loss, 1e-9), 1.0, 100.0));
}

/// The rate goes with the density, that is with the number of particles in the box.
template <int D>
double TimeStepper<D>::next(const View<D>& view, std::uint64_t step) {
  if (looks(step)) {
    const double temperature = temperatures(view).mean();
    const double crowding = static_cast<double>(view.particles.size()) / particles_;
    current_ = wanted_ / (rate_at_one_ * std::sqrt(temperature) * crowding);
    if (!(temperature > 0) || !std::isfinite(current_))
      throw RunError(fmt::format(
          "step {}: granular temperature {} gives no time step; give 'method.time-step' as a time", step,
          temperature));
  }
  return current();
}

template class TimeStepper<2>;
template class TimeStepper<3>;

}  // namespace sandglass
