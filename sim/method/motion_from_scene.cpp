#include "sim/method/motion_from_scene.hpp"

#include "sim/method/from_scene.hpp"

namespace sandglass {

namespace {
template <int D>
motion::WallPlace<D> place_of(const Scene& scene, const Wall& wall) {
  const double edge = wall.high ? scene.domain.size[static_cast<std::size_t>(wall.axis)] : 0;
  return {wall.axis,
          wall.high,
          edge,
          vector_of<D>(wall.velocity),
          wall.amplitude,
          wall.frequency,
          wall_rule_of(scene, wall.surface)};
}
}  // namespace

template <int D>
motion::MotionParameters<D> motion_of(const Scene& scene) {
  motion::MotionParameters<D> motion;
  motion.mass = scene.species.front().mass;
  if (scene.species.size() > 1 || is_rough(scene)) motion.species = traits_of(scene);
  motion.gravity = vector_of<D>(scene.gravity);
  for (std::size_t axis = 0; axis < D; ++axis)
    for (std::size_t high = 0; high < 2; ++high) {
      motion.walled[axis] = scene.domain.sides[axis][high] != Side::periodic;
      motion.open[axis][high] = scene.domain.sides[axis][high] == Side::open;
    }
  for (const Wall& wall : scene.walls) motion.walls.push_back(place_of<D>(scene, wall));
  for (const Obstacle& obstacle : scene.obstacles)
    motion.obstacles.push_back(
        {vector_of<D>(obstacle.centre), obstacle.radius, wall_rule_of(scene, obstacle.surface)});
  return motion;
}

template motion::MotionParameters<2> motion_of(const Scene&);
template motion::MotionParameters<3> motion_of(const Scene&);

}  // namespace sandglass
