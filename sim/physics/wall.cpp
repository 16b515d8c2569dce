#include "sim/physics/wall.hpp"

#include "sim/physics/collision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/random/normal_distribution.hpp>

namespace sandglass {
namespace {

double gaussian(Random& random) { return boost::random::normal_distribution<double>()(random); }

/// Unit vectors along the surface; the axes where the normal is one.
template <int D>
Vector<D> tangent(const Vector<D>& normal, int which) {
  return contact_normal(normal, 1.0, Vector<D - 1>(Vector<D - 1>::Unit(which)));
}

template <int D>
void specular(const Surface& surface, const Vector<D>& normal, Vector<D> wall,
              const ParticleAtWall<D>& particle) {
  const bool rough = particle.spin && !surface.smooth();
  Spin<D> still = Spin<D>::Zero(), unused = Spin<D>::Zero();
  const double inertia = rough ? particle.inertia : 1;
  collide<D>(
      rough ? surface : Surface{surface.normal}, normal,
      {particle.velocity, rough ? *particle.spin : unused, 1 / particle.mass, 1 / inertia, particle.radius},
      {wall, still, 0, 0, 0});
}

template <int D>
Vector<D> random_signs(const Vector<D>& along, const Vector<D>& normal, Random& random) {
  Vector<D> turned = Vector<D>::Zero();
  for (int i = 0; i < D - 1; ++i) {
    const Vector<D> axis = tangent<D>(normal, i);
    turned += (random.uniform() < 0.5 ? -1 : 1) * along.dot(axis) * axis;
  }
  return turned;
}

/// Flux distribution of a gas at rest along the normal (FluxSampler without a stream is Rayleigh's), Maxwell's along the
/// surface and of the spin. Without `flux` Maxwell's along the normal too: a planted fault.
template <int D>
void thermal(double temperature, bool flux, const Vector<D>& normal, const Vector<D>& wall,
             const ParticleAtWall<D>& particle, Random& random) {
  const double speed = std::sqrt(temperature / particle.mass);
  const double leaving = flux ? std::sqrt(-2 * std::log(1 - random.uniform())) : std::abs(gaussian(random));
  particle.velocity = wall + speed * leaving * normal;
  for (int i = 0; i < D - 1; ++i) particle.velocity += speed * gaussian(random) * tangent<D>(normal, i);
  if (!particle.spin) return;
  for (double& component : particle.spin->reshaped())
    component = std::sqrt(temperature / particle.inertia) * gaussian(random);
}

/// Rounding must not leave the particle on its way into the wall: a push by the last digits.
template <int D>
void lift_off(const Vector<D>& normal, const Vector<D>& wall, bool stay, Vector<D>& velocity) {
  const auto inward = [&] {
    const double leaving = (velocity - wall).dot(normal);
    return leaving < 0 || (leaving == 0 && !stay);
  };
  double push = std::max(std::numeric_limits<double>::epsilon() * (velocity.norm() + wall.norm()),
                         std::numeric_limits<double>::min());
  for (; inward(); push *= 2) velocity += push * normal;
}

}  // namespace

template <int D>
void reflect(const WallRule& rule, const Vector<D>& normal, const Vector<D>& wall_velocity,
             const ParticleAtWall<D>& particle, Random& random) {
  const Vector<D> before = particle.velocity - wall_velocity;
  const double approach = -before.dot(normal);
  if (approach < 0) return;
  const Vector<D> along = before + approach * normal;
  const double restitution = rule.surface.normal(approach);
  const Vector<D> leaving = wall_velocity + restitution * approach * normal;
  switch (rule.kind) {
    case WallKind::bounce_back:
      if (rule.probability >= 1 || random.uniform() < rule.probability) {
        particle.velocity = leaving - along;
        break;
      }
      [[fallthrough]];
    case WallKind::specular:
      specular<D>(rule.surface, normal, wall_velocity, particle);
      break;
    case WallKind::random_tangential_sign:
      particle.velocity = leaving + random_signs<D>(along, normal, random);
      break;
    case WallKind::thermal:
      thermal<D>(rule.temperature, rule.probability > 0, normal, wall_velocity, particle, random);
      break;
  }
  lift_off<D>(normal, wall_velocity, restitution == 0 && rule.kind != WallKind::thermal, particle.velocity);
}

template void reflect<2>(const WallRule&, const Vector<2>&, const Vector<2>&, const ParticleAtWall<2>&,
                         Random&);
template void reflect<3>(const WallRule&, const Vector<3>&, const Vector<3>&, const ParticleAtWall<3>&,
                         Random&);

}  // namespace sandglass
