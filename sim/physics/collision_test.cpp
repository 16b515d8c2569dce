#include "sim/physics/collision.hpp"

#include <gtest/gtest.h>

namespace sandglass::collision_test {
namespace {

Random stream(std::uint64_t index) { return {StreamKey(11, Purpose::collisions, 0, 0), index}; }

template <int D>
Vector<D> any_velocity(Random& random) {
  Vector<D> velocity;
  for (int axis = 0; axis < D; ++axis) velocity[axis] = 4 * random.uniform() - 2;
  return velocity;
}

template <int D>
void expect_rule_of_smooth_spheres() {
  Random random = stream(0);
  for (int trial = 0; trial < 1000; ++trial) {
    const double restitution = random.uniform();
    const Vector<D> before_1 = any_velocity<D>(random), before_2 = any_velocity<D>(random);
    const Vector<D> normal = any_velocity<D>(random).normalized();
    Vector<D> after_1 = before_1, after_2 = before_2;
    SmoothInelastic{restitution}(after_1, after_2, normal);
    const Vector<D> before = before_1 - before_2, after = after_1 - after_2;
    EXPECT_LT((after_1 + after_2 - before_1 - before_2).norm(), 1e-14);
    EXPECT_NEAR(after.dot(normal), -restitution * before.dot(normal), 1e-14);
    EXPECT_LT((after - after.dot(normal) * normal - before + before.dot(normal) * normal).norm(), 1e-14);
  }
}

TEST(SmoothInelastic, ReversesTheNormalPartOnly) {
  expect_rule_of_smooth_spheres<2>();
  expect_rule_of_smooth_spheres<3>();
}

/// Relative velocities along every axis and at random: the basis of Duff et al. must not break at the poles.
template <int D>
std::vector<Vector<D>> relative_velocities() {
  std::vector<Vector<D>> velocities;
  for (int axis = 0; axis < D; ++axis)
    for (double sign : {-1.0, 1.0}) velocities.push_back(sign * 3 * Vector<D>::Unit(axis));
  Random random = stream(1);
  for (int i = 0; i < 200; ++i) velocities.push_back(any_velocity<D>(random));
  return velocities;
}

template <int D>
void expect_normal_of_impact() {
  Random random = stream(2);
  for (const Vector<D>& relative : relative_velocities<D>()) {
    const Vector<D - 1> impact = uniform_impact<D>(random);
    const Vector<D> normal = contact_normal(relative, 1 / relative.norm(), impact);
    const double along = normal.dot(relative) / relative.norm();
    EXPECT_NEAR(normal.norm(), 1, 1e-14);
    EXPECT_NEAR(along, -std::sqrt(1 - impact.squaredNorm()), 1e-14);
    const Vector<D> head_on =
        contact_normal(relative, 1 / relative.norm(), Vector<D - 1>(Vector<D - 1>::Zero()));
    EXPECT_LT((head_on + relative.normalized()).norm(), 1e-14);
  }
}

TEST(ContactNormal, IsAUnitVectorAtItsImpactParameter) {
  expect_normal_of_impact<2>();
  expect_normal_of_impact<3>();
}

TEST(ContactNormal, KeepsTheAnglesOfTheCrossSection) {
  for (const Vector<3>& relative : relative_velocities<3>()) {
    const double inverse = 1 / relative.norm();
    const Vector<3> first = contact_normal(relative, inverse, Vector<2>(1, 0));
    const Vector<3> second = contact_normal(relative, inverse, Vector<2>(0, 1));
    EXPECT_NEAR(first.dot(second), 0, 1e-14);
    EXPECT_NEAR(first.dot(relative), 0, 1e-14);
    EXPECT_NEAR(second.dot(relative), 0, 1e-14);
  }
}

TEST(CrossSection, IsThatOfTwoEqualParticles) {
  EXPECT_DOUBLE_EQ(cross_section(2, 0.5), 1);
  EXPECT_DOUBLE_EQ(cross_section(3, 2), 4 * M_PI);
}

}  // namespace
}  // namespace sandglass::collision_test
