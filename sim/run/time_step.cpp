#include "sim/run/time_step.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/sums.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
/// Steps between looks at the largest speed, which the bound exceeds twice.
constexpr std::uint64_t kLook = 10;

/// Of a fall through one cell, or of the fastest wall.
double drive_speed(const Scene& scene, double edge) {
  double gravity = 0;
  for (const double component : scene.gravity) gravity = std::hypot(gravity, component);
  double wall = 0;
  for (const Wall& each : scene.walls) {
    double speed = 2 * M_PI * each.amplitude * each.frequency;
    for (const double component : each.velocity) speed = std::hypot(speed, component);
    wall = std::max(wall, speed);
  }
  return std::sqrt(2 * gravity * edge) + wall;
}

/// Without a drive the temperature falls by (1 - r^2)/D per collision of each particle; spins may take as much again as
/// there is.
double loss_per_collision(const Scene& scene) {
  double loss = 0;
  for (const Species& species : scene.species)
    loss = std::max(loss, 1 - species.restitution * species.restitution);
  return is_rough(scene) ? loss + 1 : loss;
}
}  // namespace

template <int D>
TimeStepper<D>::TimeStepper(const Setup<D>& setup) {
  const Scene& scene = setup.scene;
  const TimeStep& step = setup.time_step;
  fixed_ = step.fixed.value_or(0);
  if (step.fixed) return;
  if (step.cell_fraction) {
    distance_ = *step.cell_fraction * setup.method->cell_edge();
    drive_speed_ = drive_speed(scene, setup.method->cell_edge());
    refresh_ = kLook;
    return;
  }
  wanted_ = step.collisions.value();
  rate_at_one_ = setup.method->collision_rate(1);
  particles_ = static_cast<double>(setup.particles);
  // Look again every half per cent.
  const double loss = loss_per_collision(scene) / D * wanted_;
  if (scene.gravity.empty())
    refresh_ = static_cast<std::uint64_t>(std::clamp(0.005 / std::max(loss, 1e-9), 1.0, 100.0));
}

template <int D>
double TimeStepper<D>::next(const View<D>& view, std::uint64_t step) {
  if (looks(step)) {
    current_ = distance_ > 0 ? within_cells(view) : for_collisions(view);
    if (!(current_ > 0) || !std::isfinite(current_))
      throw RunError(
          fmt::format("step {}: speeds that give no time step (granular temperature {}); give "
                      "'method.time-step' as a time",
                      step, temperatures(view).mean()));
  }
  return current();
}

/// The rate goes with the density, that is with the number of particles in the box.
template <int D>
double TimeStepper<D>::for_collisions(const View<D>& view) const {
  const double crowding = static_cast<double>(particles_of_all(view)) / particles_;
  return wanted_ / (rate_at_one_ * std::sqrt(temperatures(view).mean()) * crowding);
}

template <int D>
double TimeStepper<D>::within_cells(const View<D>& view) const {
  double square = 0;
  for (const Phase<D>& particle : view.particles) square = std::max(square, particle.velocity.squaredNorm());
  if (view.ranks != nullptr)
    for (const auto& largest : collect<double>(*view.ranks, {square}))
      square = std::max(square, largest.front());
  return distance_ / (2 * std::sqrt(square) + drive_speed_);
}

template class TimeStepper<2>;
template class TimeStepper<3>;

}  // namespace sandglass
