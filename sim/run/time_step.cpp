#include "sim/run/time_step.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/sums.hpp"
#include "sim/run/equilibrate.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

double mean_speed(int dimension, double thermal_speed) {
  return thermal_speed * std::sqrt(squared_mean_speed(dimension));
}

template <int D>
double expected_collision_rate(const Scene& scene, const Setup<D>& setup, double temperature) {
  if (is_event_driven(scene)) return enskog_rate(scene, temperature);
  const Species& species = scene.species.front();
  const double contact =
      setup.parameters.factor.formula == nullptr ? 1 : setup.parameters.factor.formula(fraction(scene)).value;
  const double density =
      static_cast<double>(particle_count(scene)) * scene.method.weight / volume(scene.domain);
  return M_SQRT2 * density * setup.parameters.cross_section * contact *
         mean_speed(D, std::sqrt(temperature / species.mass));
}

template <int D>
TimeStepper<D>::TimeStepper(const Scene& scene, const Setup<D>& setup) {
  const TimeStep& step = scene.method.time_step;
  fixed_ = step.fixed.value_or(0);
  if (step.fixed) return;
  wanted_ = step.collisions.value();
  rate_at_one_ = expected_collision_rate(scene, setup, 1);
  // Without a drive the temperature falls by (1 - r^2)/D per collision of each particle: look again every half per cent.
  const double loss =
      (1 - scene.species.front().restitution * scene.species.front().restitution) / D * wanted_;
  if (scene.gravity.empty())
    refresh_ = static_cast<std::uint64_t>(std::clamp(0.005 / std::max(loss, 1e-9), 1.0, 100.0));
}

template <int D>
double TimeStepper<D>::next(const View<D>& view, std::uint64_t step) {
  if (looks(step)) {
    const double temperature = temperatures(view).mean();
    current_ = wanted_ / (rate_at_one_ * std::sqrt(temperature));
    if (!(temperature > 0) || !std::isfinite(current_))
      throw RunError(fmt::format(
          "step {}: granular temperature {} gives no time step; give 'method.time-step' as a time", step,
          temperature));
  }
  return current();
}

template double expected_collision_rate(const Scene&, const Setup<2>&, double);
template double expected_collision_rate(const Scene&, const Setup<3>&, double);
template class TimeStepper<2>;
template class TimeStepper<3>;

}  // namespace sandglass
