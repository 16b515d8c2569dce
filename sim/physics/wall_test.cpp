#include "sim/physics/wall.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::wall_test {
namespace {

Random stream(std::uint64_t index) { return {StreamKey(31, Purpose::collisions, 0, 0), index}; }

template <int D>
Vector<D> any_vector(Random& random) {
  Vector<D> vector;
  for (int axis = 0; axis < D; ++axis) vector[axis] = 4 * random.uniform() - 2;
  return vector;
}

/// One hit on a wall, of a particle with m = 2, R = 1/2, I = 0.3.
template <int D>
struct Hit {
  Vector<D> normal, wall, before, after;
  Spin<D> spin_before, spin_after;

  Vector<D> relative(const Vector<D>& velocity) const { return velocity - wall; }
  double along_normal(const Vector<D>& velocity) const { return relative(velocity).dot(normal); }
  Vector<D> tangential(const Vector<D>& velocity) const {
    return relative(velocity) - along_normal(velocity) * normal;
  }
  void happen(const WallRule& rule, Random& random, bool spins = true) {
    after = before;
    spin_after = spin_before;
    reflect<D>(rule, normal, wall, {after, spins ? &spin_after : nullptr, 2, 0.5, 0.3}, random);
  }
};

template <int D>
Hit<D> any_hit(Random& random) {
  Hit<D> hit{any_vector<D>(random).normalized(), any_vector<D>(random), any_vector<D>(random), {}, {}, {}};
  for (double& component : hit.spin_before.reshaped()) component = 2 * random.uniform() - 1;
  if (hit.along_normal(hit.before) > 0) hit.normal = -hit.normal;
  return hit;
}

template <class Disk, class Sphere>
void in_both_dimensions(Disk disk, Sphere sphere) {
  Random random = stream(0);
  for (int trial = 0; trial < 1000; ++trial) {
    disk(random, any_hit<2>(random));
    sphere(random, any_hit<3>(random));
  }
}
#define IN_BOTH_DIMENSIONS(function) in_both_dimensions(function<2>, function<3>)

template <int D>
void expect_specular(Random& random, Hit<D> hit) {
  const double r = 0.1 + 0.9 * random.uniform();
  hit.happen({WallKind::specular, {{r}}}, random);
  EXPECT_NEAR(hit.along_normal(hit.after), -r * hit.along_normal(hit.before), 1e-14);
  EXPECT_LT((hit.tangential(hit.after) - hit.tangential(hit.before)).norm(), 1e-14);
  EXPECT_EQ(hit.spin_after, hit.spin_before);
}
TEST(Wall, SpecularReversesTheNormalPart) { IN_BOTH_DIMENSIONS(expect_specular); }

template <int D>
void expect_rough(Random& random, Hit<D> hit) {
  const Surface surface{{random.uniform()}, 0, random.uniform()};
  hit.happen({WallKind::specular, surface}, random);
  Vector<D> velocity = hit.before, wall = hit.wall;
  Spin<D> spin = hit.spin_before, none = Spin<D>::Zero();
  collide<D>(surface, hit.normal, {velocity, spin, 0.5, 1 / 0.3, 0.5}, {wall, none, 0, 0, 0});
  EXPECT_LT((hit.after - velocity).norm(), 1e-14);
  EXPECT_LT((hit.spin_after - spin).norm(), 1e-14);
  hit.happen({WallKind::specular, surface}, random, false);
  EXPECT_LT((hit.tangential(hit.after) - hit.tangential(hit.before)).norm(), 1e-14);
}
TEST(Wall, RoughTurnsWhatHasASpinOnly) { IN_BOTH_DIMENSIONS(expect_rough); }

template <int D>
void expect_bounce_back(Random& random, Hit<D> hit) {
  hit.happen({WallKind::bounce_back, {{1}}}, random);
  EXPECT_LT((hit.relative(hit.after) + hit.relative(hit.before)).norm(), 1e-14);
  hit.happen({WallKind::bounce_back, {{0.5}}}, random);
  EXPECT_NEAR(hit.along_normal(hit.after), -0.5 * hit.along_normal(hit.before), 1e-14);
  EXPECT_LT((hit.tangential(hit.after) + hit.tangential(hit.before)).norm(), 1e-14);
  EXPECT_EQ(hit.spin_after, hit.spin_before);
}
/// A rough wall of a shear cell, at rest along its normal: v_perp' = -r_w v_perp and v_par' = 2 v_w - v_par, (3.7) and
/// (3.8) of Mueller (2001), with v_par and v_w in the frame of the laboratory.
template <int D>
void expect_shear_cell(Random& random, Hit<D> hit) {
  const double r = random.uniform();
  hit.wall -= hit.wall.dot(hit.normal) * hit.normal;
  if (hit.along_normal(hit.before) > 0) hit.normal = -hit.normal;
  hit.happen({WallKind::bounce_back, {{r}}}, random);
  const double before = hit.before.dot(hit.normal), after = hit.after.dot(hit.normal);
  EXPECT_NEAR(after, -r * before, 1e-14);
  const Vector<D> along = hit.before - before * hit.normal, expected = 2 * hit.wall - along;
  EXPECT_LT((hit.after - after * hit.normal - expected).norm(), 1e-14);
}
TEST(Wall, BounceBackIsTheRuleOfAShearCell) { IN_BOTH_DIMENSIONS(expect_shear_cell); }

TEST(Wall, BounceBackReversesAll) { IN_BOTH_DIMENSIONS(expect_bounce_back); }

template <int D>
void expect_sign(Random& random, Hit<D> hit) {
  hit.happen({WallKind::random_tangential_sign, {{0.9}}}, random);
  EXPECT_NEAR(hit.along_normal(hit.after), -0.9 * hit.along_normal(hit.before), 1e-14);
  EXPECT_NEAR(hit.tangential(hit.after).norm(), hit.tangential(hit.before).norm(), 1e-14);
}
TEST(Wall, RandomSignKeepsTheTangentialSpeed) { IN_BOTH_DIMENSIONS(expect_sign); }

template <int D>
void expect_leaves(Random& random, Hit<D> hit) {
  // Fast wall, slow approach: rounding decides the sign.
  hit.wall *= 1e3;
  hit.before = hit.wall - std::pow(10, -18 * random.uniform()) * hit.normal;
  if (hit.along_normal(hit.before) > 0) return;
  for (const double r : {0.0, 1e-9, 1.0})
    for (const auto kind :
         {WallKind::specular, WallKind::bounce_back, WallKind::random_tangential_sign, WallKind::thermal}) {
      hit.happen({kind, {{r}}, 0.5}, random);
      EXPECT_GE(hit.along_normal(hit.after), 0);
      if (r > 0 || kind == WallKind::thermal) {
        EXPECT_GT(hit.along_normal(hit.after), 0);
      }
      EXPECT_LT(hit.relative(hit.after).norm(), 10);
    }
}
TEST(Wall, IsAlwaysLeft) { IN_BOTH_DIMENSIONS(expect_leaves); }

template <int D>
void expect_alone(Random& random, Hit<D> hit) {
  hit.normal = -hit.normal;
  hit.happen({WallKind::thermal}, random);
  EXPECT_EQ(hit.after, hit.before);
  EXPECT_EQ(hit.spin_after, hit.spin_before);
}
TEST(Wall, LeavesWhatRecedesAlone) { IN_BOTH_DIMENSIONS(expect_alone); }

/// Along axes the signs are those of the axes; each of the four turns comes a quarter of the time.
TEST(Wall, RandomSignTurnsEachAxisHalfOfTheTime) {
  Random random = stream(1);
  constexpr int kHits = 40000;
  int turned[2][2] = {};
  for (int i = 0; i < kHits; ++i) {
    Hit<3> hit{{0, 0, 1}, {0, 0, 0}, {0.5, 2, -1}, {}, {0, 0, 0}, {}};
    hit.happen({WallKind::random_tangential_sign}, random);
    ASSERT_EQ(hit.after.cwiseAbs(), Vector<3>(0.5, 2, 1));
    ++turned[hit.after[0] < 0][hit.after[1] < 0];
  }
  const double error = std::sqrt(kHits * 3.0 / 16);
  for (const auto& row : turned)
    for (const int count : row) EXPECT_NEAR(count, kHits / 4, 4.5 * error);
}

TEST(Wall, BouncesBackWithItsProbability) {
  Random random = stream(2);
  constexpr int kHits = 40000;
  int back = 0;
  for (int i = 0; i < kHits; ++i) {
    Hit<2> hit{{0, 1}, {0, 0}, {3, -1}, {}, Spin<2>(0.0), {}};
    hit.happen({WallKind::bounce_back, {}, 0.3}, random);
    ASSERT_EQ(hit.after.cwiseAbs(), Vector<2>(3, 1));
    back += hit.after[0] < 0;
  }
  EXPECT_NEAR(back, 0.3 * kHits, 4.5 * std::sqrt(0.21 * kHits));
}

}  // namespace
}  // namespace sandglass::wall_test
