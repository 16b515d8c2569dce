#include "sim/run/check_state.hpp"

#include "sim/base/saved.hpp"
#include "sim/scene/method/capabilities.hpp"

#include <algorithm>

namespace sandglass {

namespace {
constexpr double kFar = 1e100;  // as far as a scene may place a particle, and as fast as it may move one

/// A wall that moves takes particles with it as far as it goes.
void require_places(const State& state, const Domain& domain) {
  const auto axes = static_cast<std::size_t>(domain.dimension);
  for (std::size_t i = 0; i < state.particles.position.size(); ++i) {
    const std::size_t axis = i % axes;
    const bool periodic = domain.sides[axis][0] == Side::periodic;
    const double length = domain.size[axis];
    saved_number(state.particles.position[i], periodic ? -length : -kFar, periodic ? 2 * length : kFar,
                 "the position of a particle");
  }
  for (const double component : state.particles.velocity)
    saved_number(component, -kFar, kFar, "the velocity of a particle");
}

void require_finite(const NamedColumn& column) {
  if (column.info.name == column::last_contact.name) return;  // it may be long ago
  if (const auto* numbers = std::get_if<std::vector<double>>(&column.numbers))
    for (const double number : *numbers) saved_number(number, -kFar, kFar, column.info.name.c_str());
}

void require_columns(const State& state, const Scene& scene) {
  const Columns& columns = state.particles.columns;
  for (const NamedColumn& column : columns.all()) require_finite(column);
  for (const double weight : columns.get(column::weight)) saved_number(weight, 1e-300, kFar, "a weight");
  const auto species = columns.get(column::species);
  const bool known = scene.species.size() < 2 || !species.empty() || state.particles.position.empty();
  if (!known) refuse_saved("particles without their species");
  for (const std::uint8_t kind : species)
    if (kind >= scene.species.size()) refuse_saved("a species that the scene does not have");
}

void require_clock(const State& state, const Scene& scene) {
  saved_count(static_cast<double>(state.step), "the step");
  saved_number(state.time, 0, 1e300, "the time");
  const auto& step = scene.method.time_step.fixed;
  const double time = static_cast<double>(state.step) * step.value_or(0);
  if (step && std::abs(time - state.time) > 1e-9 * time)
    refuse_saved("a time that its steps do not add up to");
}
}  // namespace

void require_sound(const State& state, const Scene& scene) {
  require_clock(state, scene);
  require_places(state, scene.domain);
  require_columns(state, scene);
  for (const auto& [name, numbers] : state.memory)
    if (std::ranges::any_of(numbers, [](double number) { return std::isnan(number); }))
      refuse_saved("'" + name + "' that is not a number");
}

}  // namespace sandglass
