#include "validation/law/sinking_column.hpp"

#include "validation/law/sedimentation.hpp"
#include "validation/law/transport.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sandglass::law {

namespace {
using Values = std::vector<double>;

/// Places and velocities of the faces between the parts, the ends among them, and a temperature of each part.
struct State {
  Values place, velocity, temperature;

  void add(double factor, const State& rate) {
    for (std::size_t i = 0; i < place.size(); ++i) {
      place[i] += factor * rate.place[i];
      velocity[i] += factor * rate.velocity[i];
    }
    for (std::size_t i = 0; i < temperature.size(); ++i) temperature[i] += factor * rate.temperature[i];
  }
};

class Flow {
 public:
  Flow(const SinkingColumn& column, int cells)
      : column_(column),
        part_(number_density(column.gas) * column.height / cells),
        viscosity_(2.0 * (column.gas.dimension - 1) / column.gas.dimension *
                   boltzmann_shear_viscosity(at_one(column.gas), SonineOrder::converged)),
        conductivity_(boltzmann_conductivity(at_one(column.gas), SonineOrder::converged)) {
    const auto count = static_cast<std::size_t>(cells);
    for (std::size_t i = 0; i <= count; ++i)
      start_.place.push_back(column.height * static_cast<double>(i) / cells);
    start_.velocity.assign(count + 1, 0.0);
    start_.temperature.assign(count, column.gas.temperature);
  }

  const State& start() const { return start_; }

  /// Half of what the diffusion of heat and momentum allows, and the sound, in parts half as thick and at twice the
  /// temperature.
  double step() const {
    const double thickness = start_.place[1] / 2, hot = 2 * column_.gas.temperature;
    const double diffusivity = std::max(viscosity_ / column_.gas.mass, 2 / column_.freedom * conductivity_) *
                               std::sqrt(hot) / (2 * number_density(column_.gas));
    return 0.5 * std::min(thickness * thickness / (2 * diffusivity),
                          thickness / std::sqrt(3 * hot / column_.gas.mass));
  }

  State rate(const State& now) const {
    const std::size_t count = now.temperature.size();
    State rate{now.velocity, Values(count + 1), Values(count)};
    Values pressure(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double thickness = now.place[i + 1] - now.place[i];
      const double stretch = now.velocity[i + 1] - now.velocity[i];
      pressure[i] = part_ * now.temperature[i] / thickness -
                    viscosity_ * std::sqrt(now.temperature[i]) * stretch / thickness;
      rate.temperature[i] -= pressure[i] * stretch;
    }
    for (std::size_t i = 1; i < count; ++i) {
      rate.velocity[i] = (pressure[i - 1] - pressure[i]) / (column_.gas.mass * part_) - column_.gravity;
      const double distance = (now.place[i + 1] - now.place[i - 1]) / 2;
      const double root = std::sqrt((now.temperature[i] + now.temperature[i - 1]) / 2);
      const double heat = conductivity_ * root * (now.temperature[i] - now.temperature[i - 1]) / distance;
      rate.temperature[i - 1] += heat;
      rate.temperature[i] -= heat;
    }
    for (double& value : rate.temperature) value *= 2 / (column_.freedom * part_);
    return rate;
  }

 private:
  static Gas at_one(Gas gas) {
    gas.temperature = 1;
    return gas;
  }

  SinkingColumn column_;
  double part_;                      ///< particles of a part per area
  double viscosity_, conductivity_;  ///< at temperature one; both go as its root
  State start_;
};

/// Runge and Kutta's fourth order.
void advance(const Flow& flow, double step, State& now) {
  const State first = flow.rate(now);
  State at = now;
  at.add(step / 2, first);
  const State second = flow.rate(at);
  at = now;
  at.add(step / 2, second);
  const State third = flow.rate(at);
  at = now;
  at.add(step, third);
  const State last = flow.rate(at);
  now.add(step / 6, first);
  now.add(step / 3, second);
  now.add(step / 3, third);
  now.add(step / 6, last);
}

/// Parts hold equal numbers; each lies in the middle between its faces.
double centre_of_mass(const State& state) {
  double sum = (state.place.front() + state.place.back()) / 2;
  for (std::size_t i = 1; i + 1 < state.place.size(); ++i) sum += state.place[i];
  return sum / static_cast<double>(state.temperature.size());
}

MixedColumn at_rest(const SinkingColumn& column) {
  return {{{column.gas.mass, 1, column.height}}, column.gravity, column.freedom};
}
}  // namespace

Fall fall_of_column(const SinkingColumn& column, double until, int cells) {
  const Flow flow(column, cells);
  const double steps = std::ceil(until / flow.step());
  Fall fall{until / steps, {}};
  State now = flow.start();
  fall.height.push_back(centre_of_mass(now));
  for (int i = 0; i < steps; ++i) {
    advance(flow, fall.step, now);
    fall.height.push_back(centre_of_mass(now));
  }
  return fall;
}

Bounce first_bounce(const SinkingColumn& column) {
  const Column sound{column.gas.mass, column.gas.temperature, column.gravity, column.height};
  const double end =
      sedimentation_temperature(at_rest(column), even_column_energy(at_rest(column), column.gas.temperature));
  const double rest = mean_column_height({column.gas.mass, end, column.gravity, column.height});
  const Fall fall =
      fall_of_column(column, 2 * std::numbers::pi / column_sound_frequency(sound, column.freedom));
  const auto lowest = std::min_element(fall.height.begin(), fall.height.end());
  return {fall.step * static_cast<double>(lowest - fall.height.begin()),
          (rest - *lowest) / (fall.height.front() - rest)};
}

}  // namespace sandglass::law
