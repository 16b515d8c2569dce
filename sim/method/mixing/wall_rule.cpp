#include "sim/method/mixing/wall_rule.hpp"

#include <cmath>

namespace sandglass::mixing {

std::uint32_t WallRule::turn_back(const Vector<2>& start, Phase<2>& particle, std::uint32_t most) const {
  Vector<2> from = start;
  const Vector<2>& position = particle.position;
  for (std::uint32_t walls = 0; walls <= most; ++walls) {
    if (position[0] > box[0])
      reflect(0, box[0], from, particle);
    else if (position[0] < 0)
      reflect(0, 0, from, particle);
    else if (position[1] > box[1])
      reflect(1, box[1], from, particle);
    else if (position[1] < 0)
      reflect(1, 0, from, particle);
    else
      return walls;
  }
  return most + 1;
}

/// In the order of the listing: what it has set anew it uses anew, so that the factor comes in twice along the wall.
void WallRule::reflect(int axis, double wall, Vector<2>& start, Phase<2>& particle) const {
  const int other = 1 - axis;
  Vector<2>& position = particle.position;
  const double path = position[axis] - start[axis];
  const double tangent = (position[other] - start[other]) / (path + std::copysign(smallest_length, path));
  position[axis] = wall - speed_factor * (position[axis] - wall);
  start[axis] = wall;
  start[other] = position[other] + (position[axis] - wall) * tangent;
  position[other] = start[other] - speed_factor * (position[axis] - wall) * tangent;
  const Vector<2> inside = position - start;
  const double speed = speed_factor * particle.velocity.norm();
  particle.velocity = speed / (inside.norm() + smallest_length) * inside;
}

}  // namespace sandglass::mixing
