#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/worst.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

// The length of the steps that a run took, against the rule that chose it.

namespace sandglass {

namespace {
double shortest_edge(const Scene& scene) {
  const std::vector<double> cells = cells_along(scene);
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < cells.size(); ++axis)
    shortest = std::min(shortest, scene.domain.size[axis] / cells[axis]);
  return shortest;
}

/// What gravity and walls may add: a fall through one cell, and the fastest wall.
double drive_speed(const Scene& scene) {
  double gravity = 0, fastest = 0;
  for (const double component : scene.gravity) gravity = std::hypot(gravity, component);
  for (const Wall& wall : scene.walls) {
    double speed = 2 * std::numbers::pi * wall.amplitude * wall.frequency;
    for (const double component : wall.velocity) speed = std::hypot(speed, component);
    fastest = std::max(fastest, speed);
  }
  return std::sqrt(2 * gravity * shortest_edge(scene)) + fastest;
}

/// Between two samples: the mean step, times the speed at which two particles of average energy may meet head on, over the
/// edge of a cell. The rule takes the fastest particle instead of the average, so this is less than the part of a cell
/// that it allows.
double largest_part(const Subject& subject, std::size_t replica) {
  const Series& energy = subject.series(replica, "energy");
  const double mass = subject.particles() * subject.scene().method.weight * subject.species().mass;
  double worst = 0;
  for (std::size_t i = 1; i < energy.samples(); ++i) {
    const double steps = static_cast<double>(energy.step[i] - energy.step[i - 1]);
    const double speed = std::sqrt(2 * std::min(energy.value[i], energy.value[i - 1]) / mass);
    const double approach = 2 * speed + drive_speed(subject.scene());
    keep_worst(worst,
               (energy.time[i] - energy.time[i - 1]) / steps * approach / shortest_edge(subject.scene()));
  }
  return worst;
}

Evidence part_of_a_cell(const Subject& subject, const law::Arguments&) {
  Evidence evidence;
  evidence.kind = Expectation::at_most;
  evidence.expected = *subject.scene().method.time_step.cell_fraction;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    keep_worst(evidence.value, largest_part(subject, replica));
  return evidence;
}

bool steps_by_cells(const Scene& scene) {
  return scene.method.time_step.cell_fraction.has_value() && scene.species.size() == 1 && !is_rough(scene) &&
         scene.sources.empty() && !has_open_side(scene.domain);
}
}  // namespace

std::vector<CheckInfo> time_step_checks() {
  return {{"step-in-cells",
           "largest part of a cell by which two particles of average energy may come closer in a step",
           "",
           {"energy"},
           true,
           {},
           steps_by_cells,
           part_of_a_cell}};
}

}  // namespace sandglass
