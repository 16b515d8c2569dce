#include "sim/physics/contact.hpp"

#include "sim/physics/collision.hpp"
#include "sim/physics/test_pair.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::contact_test {
namespace {

template <class Body2, class Body3>
void in_both_dimensions(Body2 disks, Body3 spheres) {
  Random random(StreamKey(21, Purpose::collisions, 0, 0), 0);
  for (int trial = 0; trial < 2000; ++trial) {
    disks(random, any_pair<2>(random));
    spheres(random, any_pair<3>(random));
  }
}

#define IN_BOTH_DIMENSIONS(function) in_both_dimensions(function<2>, function<3>)

template <int D>
void expect_conservation(Random& random, Pair<D> pair) {
  const Pair<D> before = pair;
  ASSERT_TRUE(pair.collide(any_surface(random)));
  EXPECT_LT((pair.momentum() - before.momentum()).norm(), 1e-13);
  EXPECT_LT((pair.angular_momentum() - before.angular_momentum()).norm(), 1e-13);
  EXPECT_LE(pair.energy(), before.energy() + 1e-13);
}
TEST(Contact, ConservesMomentumAndAngularMomentumAndLosesEnergy) { IN_BOTH_DIMENSIONS(expect_conservation); }

template <int D>
void expect_reversal(Random& random, Pair<D> pair) {
  Pair<D> before = pair;
  const Surface surface{{random.uniform()}, 2 * random.uniform() - 1};
  pair.collide(surface);
  const auto across = [](Pair<D>& p) {
    return Vector<D>(p.contact() - p.contact().dot(p.normal) * p.normal);
  };
  EXPECT_NEAR(pair.approach(), -surface.normal.value * before.approach(), 1e-13);
  EXPECT_LT((across(pair) + surface.tangential * across(before)).norm(), 1e-13);
  // Loss: M (1 - e^2) c_n^2 / 2 + M_t (1 - e_t^2) g_t^2 / 2.
  const double mass = tangential_mass(before.first.partner(), before.second.partner());
  const double loss =
      0.5 * before.reduced_mass() * (1 - std::pow(surface.normal.value, 2)) * std::pow(before.approach(), 2) +
      0.5 * mass * (1 - std::pow(surface.tangential, 2)) * across(before).squaredNorm();
  EXPECT_NEAR(before.energy() - pair.energy(), loss, 1e-13);
}
TEST(Contact, ThatSticksReversesBothPartsAndBalancesEnergy) { IN_BOTH_DIMENSIONS(expect_reversal); }

template <int D>
void expect_energy_kept(Random&, Pair<D> pair) {
  const double energy = pair.energy();
  Pair<D> smooth = pair;
  pair.collide({{1}, 1});
  smooth.collide({});
  EXPECT_NEAR(pair.energy(), energy, 1e-13);
  EXPECT_NEAR(smooth.energy(), energy, 1e-13);
}
TEST(Contact, KeepsEnergyWhenSmoothOrPerfectlyRough) { IN_BOTH_DIMENSIONS(expect_energy_kept); }

template <int D>
void expect_smooth(Random& random, Pair<D> pair) {
  const Pair<D> before = pair;
  const double restitution = random.uniform();
  pair.collide({{restitution}, -1, random.uniform()});
  const Vector<D> impulse = smooth_impulse<D>(before.first.mass, before.second.mass, restitution,
                                              before.first.velocity - before.second.velocity, before.normal);
  EXPECT_EQ(pair.first.spin, before.first.spin);
  EXPECT_EQ(pair.second.spin, before.second.spin);
  EXPECT_LT((pair.first.velocity - before.first.velocity - impulse / before.first.mass).norm(), 1e-13);
  EXPECT_LT((pair.second.velocity - before.second.velocity + impulse / before.second.mass).norm(), 1e-13);
}
TEST(Contact, ThatIsSmoothLeavesSpinAndGivesTheSmoothImpulse) { IN_BOTH_DIMENSIONS(expect_smooth); }

template <int D>
void expect_uniform_rule(Random& random, Pair<D> pair) {
  pair.second.mass = pair.first.mass;
  Vector<D> one = pair.first.velocity, two = pair.second.velocity;
  const double restitution = random.uniform();
  SmoothInelastic{restitution}(one, two, pair.normal);
  pair.collide({{restitution}});
  EXPECT_LT((pair.first.velocity - one).norm() + (pair.second.velocity - two).norm(), 1e-13);
}
TEST(Contact, OfEqualSmoothPartnersIsTheUniformRule) { IN_BOTH_DIMENSIONS(expect_uniform_rule); }

/// The whole rule through the effective coefficient min(e_t1, e_t) of Baryshev (2003), Eq. 3.68.
template <int D>
void expect_effective_restitution(Random& random, Pair<D> pair) {
  const Surface surface = any_surface(random);
  const Vector<D> g = pair.contact(), slip = g - g.dot(pair.normal) * pair.normal;
  const double masses = pair.reduced_mass() / tangential_mass(pair.first.partner(), pair.second.partner());
  const double effective =
      std::min(surface.tangential, sliding_restitution(surface, pair.approach(), slip.norm(), masses));
  pair.collide(surface);
  const Vector<D> after = pair.contact();
  EXPECT_LT((after - after.dot(pair.normal) * pair.normal + effective * slip).norm(), 1e-13);
}
TEST(Contact, HasTheEffectiveTangentialRestitution) { IN_BOTH_DIMENSIONS(expect_effective_restitution); }

template <int D>
void expect_galilean(Random& random, Pair<D> pair) {
  Pair<D> moving = pair;
  const Vector<D> drift = any<Vector<D>>(random);
  moving.first.velocity += drift;
  moving.second.velocity += drift;
  const Surface surface = any_surface(random);
  pair.collide(surface);
  moving.collide(surface);
  EXPECT_LT((moving.first.velocity - drift - pair.first.velocity).norm(), 1e-13);
  EXPECT_LT((moving.second.velocity - drift - pair.second.velocity).norm(), 1e-13);
  EXPECT_LT((moving.first.spin - pair.first.spin).norm(), 1e-12);
  EXPECT_LT((moving.second.spin - pair.second.spin).norm(), 1e-12);
}
TEST(Contact, IsGalileanInvariant) { IN_BOTH_DIMENSIONS(expect_galilean); }

/// x -> -x: velocities are vectors, spins axial vectors.
template <int D>
Pair<D> mirrored(Pair<D> pair) {
  pair.normal[0] *= -1;
  for (Ball<D>* ball : {&pair.first, &pair.second}) {
    ball->velocity[0] *= -1;
    const double kept = ball->spin[0];
    ball->spin *= -1;
    if constexpr (D == 3) ball->spin[0] = kept;
  }
  return pair;
}
template <int D>
void expect_mirror(Random& random, Pair<D> pair) {
  Pair<D> image = mirrored(pair);
  const Surface surface = any_surface(random);
  pair.collide(surface);
  image.collide(surface);
  image = mirrored(image);
  EXPECT_LT((image.first.velocity - pair.first.velocity).norm(), 1e-14);
  EXPECT_LT((image.first.spin - pair.first.spin).norm(), 1e-13);
}
TEST(Contact, HasMirrorSymmetry) { IN_BOTH_DIMENSIONS(expect_mirror); }

template <int D>
void expect_exchange(Random& random, Pair<D> pair) {
  Pair<D> swapped{pair.second, pair.first, -pair.normal};
  const Surface surface = any_surface(random);
  pair.collide(surface);
  swapped.collide(surface);
  EXPECT_LT((swapped.second.velocity - pair.first.velocity).norm(), 1e-14);
  EXPECT_LT((swapped.first.spin - pair.second.spin).norm(), 1e-13);
}
TEST(Contact, DoesNotKnowWhoIsFirst) { IN_BOTH_DIMENSIONS(expect_exchange); }

template <int D>
void expect_wall_limit(Random& random, Pair<D> pair) {
  pair.second.mass = pair.second.inertia = 1e14;
  Pair<D> wall = pair;
  const Surface surface = any_surface(random);
  pair.collide(surface);
  const Partner<D> fixed{wall.second.velocity, wall.second.spin, 0, 0, wall.second.radius};
  collide(surface, wall.normal, wall.first.partner(), fixed);
  EXPECT_LT((wall.first.velocity - pair.first.velocity).norm(), 1e-12);
  EXPECT_LT((wall.first.spin - pair.first.spin).norm(), 1e-11);
  EXPECT_LT((wall.second.velocity - pair.second.velocity).norm(), 1e-12);
}
TEST(Contact, WithAVeryHeavyPartnerIsAWall) { IN_BOTH_DIMENSIONS(expect_wall_limit); }

template <int D>
void expect_nothing(Random& random, Pair<D> pair) {
  pair.normal = -pair.normal;
  const Pair<D> before = pair;
  EXPECT_FALSE(pair.collide(any_surface(random)));
  EXPECT_EQ(pair.first.velocity, before.first.velocity);
  EXPECT_EQ(pair.second.spin, before.second.spin);
}
TEST(Contact, LeavesARecedingPairAlone) { IN_BOTH_DIMENSIONS(expect_nothing); }

}  // namespace
}  // namespace sandglass::contact_test
