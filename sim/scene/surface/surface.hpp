#pragma once

#include <optional>
#include <vector>

// What particles hit that is not a particle: walls and fixed obstacles. Plain values of a scene.

namespace sandglass {

/// What becomes of the velocity relative to the surface.
/// specular: the collision rule, with the surface as a partner of infinite mass; bounce_back: reversed as a
/// whole with `probability`, else specular; random_tangential_sign: specular, and each tangential component
/// keeps or turns its sign at random; thermal: drawn anew from the flux distribution at `temperature`.
enum class SurfaceKind { specular, bounce_back, random_tangential_sign, thermal };

struct SurfaceRule {
  SurfaceKind rule = SurfaceKind::specular;
  double restitution = 1;               ///< normal; not for thermal
  double tangential_restitution = -1;   ///< specular: -1 is smooth
  std::optional<double> friction = {};  ///< specular: Coulomb coefficient; none: always sticking
  double probability = 1;               ///< bounce_back
  double temperature = 0;               ///< thermal: granular temperature of the wall
  bool operator==(const SurfaceRule&) const = default;
};

/// More about one side of the domain that is not periodic. Its plane stands at
/// edge + velocity[axis] t + amplitude sin(2 pi frequency t); hard particles touch it with their surface.
struct Wall {
  int axis = 0;
  bool high = false;
  SurfaceRule surface;
  std::vector<double> velocity;  ///< empty: at rest
  double amplitude = 0;
  double frequency = 0;
  bool operator==(const Wall&) const = default;
};

/// A disk or sphere that stands still.
struct Obstacle {
  std::vector<double> centre;
  double radius = 0;
  SurfaceRule surface;
  bool operator==(const Obstacle&) const = default;
};

}  // namespace sandglass
