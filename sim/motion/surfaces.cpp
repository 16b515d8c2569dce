#include "sim/motion/surfaces.hpp"

#include "sim/base/error.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass::motion {

namespace {

/// Relative: a particle on a surface is off it by a few of its last digits.
constexpr double kMargin = 1e-9;

template <int D>
bool stands(const WallPlace<D>& wall, const MotionParameters<D>& parameters) {
  if (wall.axis < 0 || wall.axis >= D) return false;
  const auto axis = static_cast<std::size_t>(wall.axis);
  return parameters.walled[axis] && !parameters.open[axis][wall.high];
}

template <int D>
bool is_plain(const WallPlace<D>& wall, const MotionParameters<D>& parameters, const Vector<D>& box) {
  if (!stands(wall, parameters)) return false;  // to be refused
  return wall.rule.kind == WallKind::specular && wall.rule.surface.normal.value == 1 &&
         wall.rule.surface.smooth() && !wall.moves() && wall.edge == (wall.high ? box[wall.axis] : 0);
}

template <int D>
WallPlace<D> side_of(const MotionParameters<D>& parameters, const Vector<D>& box, int axis, bool high) {
  for (const WallPlace<D>& wall : parameters.walls)
    if (wall.axis == axis && wall.high == high) return wall;
  WallPlace<D> plain;
  plain.axis = axis;
  plain.high = high;
  plain.edge = high ? box[axis] : 0;
  return plain;
}

template <int D>
void check_walls(const MotionParameters<D>& parameters) {
  for (const WallPlace<D>& wall : parameters.walls)
    if (!stands(wall, parameters))
      throw InputError(
          fmt::format("a wall stands normal to axis {}, at a side that is periodic or open; put walls there "
                      "('domain.sides')",
                      wall.axis));
}

template <int D>
void check_obstacles(const MotionParameters<D>& parameters, const Vector<D>& box) {
  for (const ObstaclePlace<D>& obstacle : parameters.obstacles) {
    const Vector<D> reach = Vector<D>::Constant(obstacle.radius);
    const bool in = ((obstacle.centre - reach).array() >= 0).all() &&
                    ((box - obstacle.centre - reach).array() >= 0).all();
    if (!(obstacle.radius > 0) || !in)
      throw InputError(fmt::format(
          "an obstacle of radius {} does not lie inside the box with all its surface; move 'obstacle.centre' "
          "or change 'obstacle.radius'",
          obstacle.radius));
  }
}

template <int D>
void check_planes(const MotionParameters<D>& parameters) {
  if (parameters.planes == nullptr) return;
  for (const Plane& plane : *parameters.planes)
    if (parameters.walled[static_cast<std::size_t>(plane.axis())])
      throw InputError(
          fmt::format("a plane that counts is normal to axis {}, which has walls; choose a periodic axis "
                      "('observe.axis')",
                      plane.axis()));
}

}  // namespace

template <int D>
WallSurface<D>::WallSurface(const WallPlace<D>& wall)
    : place(wall),
      inward(wall.high ? -1 : 1),
      motion{inward * wall.edge, inward * wall.velocity[wall.axis], wall.vibrates() ? wall.amplitude : 0,
             wall.frequency, wall.high ? M_PI : 0} {}

/// The steady part is highest at one end of the step; the vibration rises no faster than amplitude times frequency.
template <int D>
double WallSurface<D>::reach(double time, double dt) const {
  const double steady = motion.position + std::max(motion.speed * time, motion.speed * (time + dt));
  const double amplitude = std::fabs(motion.amplitude);
  const double swing = motion.amplitude * std::sin(motion.angle(time)) +
                       amplitude * std::fabs(motion.angular_frequency()) * dt;
  return inward * (steady + std::min(amplitude, swing));
}

template <int D>
Surfaces<D>::Surfaces(const MotionParameters<D>& from, const Vector<D>& box) : parameters(from) {
  check_walls(from);
  check_obstacles(from, box);
  check_planes(from);
  for (int axis = 0; axis < D; ++axis)
    if (from.walled[static_cast<std::size_t>(axis)])
      for (const bool high : {false, true}) add_side(box, axis, high);
  std::vector<Ball<D>> balls;
  for (const ObstaclePlace<D>& obstacle : from.obstacles)
    balls.push_back({obstacle.centre, obstacle.radius * (1 + kMargin)});
  obstacles = BallIndex<D>(std::move(balls));
  for (const WallSurface<D>& wall : walls) draws = draws || sandglass::draws(wall.place.rule);
  for (const ObstaclePlace<D>& obstacle : from.obstacles) draws = draws || sandglass::draws(obstacle.rule);
}

template <int D>
void Surfaces<D>::add_side(const Vector<D>& box, int axis, bool high) {
  if (parameters.open[static_cast<std::size_t>(axis)][high])
    open.push_back({axis, high ? box[axis] : 0, high ? -1.0 : 1.0});
  else
    walls.emplace_back(side_of(parameters, box, axis, high));
}

template <int D>
bool are_plain(const MotionParameters<D>& parameters, const Vector<D>& box) {
  return parameters.obstacles.empty() && std::ranges::all_of(parameters.walls, [&](const auto& wall) {
           return is_plain<D>(wall, parameters, box);
         });
}

template struct WallSurface<2>;
template struct WallSurface<3>;
template struct Surfaces<2>;
template struct Surfaces<3>;
template bool are_plain<2>(const MotionParameters<2>&, const Vector<2>&);
template bool are_plain<3>(const MotionParameters<3>&, const Vector<3>&);

}  // namespace sandglass::motion
