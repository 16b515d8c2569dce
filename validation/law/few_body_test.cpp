#include "validation/law/few_body.hpp"

#include "sim/base/error.hpp"
#include "validation/law/few_body_line.hpp"

#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace sandglass::law::few_body_test {
namespace {

Vector<3> random_vector(std::mt19937& generator) {
  std::normal_distribution<double> normal;
  return {normal(generator), normal(generator), normal(generator)};
}

struct Pair {
  Ball first{2, 0.5, 0.3, {}, {}, {}}, second{0.7, 0.8, 0.1, {}, {}, {}};
  Vector<3> normal;
  explicit Pair(unsigned seed) {
    std::mt19937 generator(seed);
    normal = random_vector(generator).normalized();
    first.position = Vector<3>(1, 2, 3);
    second.position = first.position - (first.radius + second.radius) * normal;
    for (Ball* ball : {&first, &second}) {
      ball->velocity = random_vector(generator);
      ball->spin = random_vector(generator);
    }
    const double opening = (first.velocity - second.velocity).dot(normal);
    if (opening > 0) first.velocity -= 2 * opening * normal;
  }
  double reduced() const { return 1 / (1 / first.mass + 1 / second.mass); }
  double tangential_mass() const {
    return 1 / (1 / reduced() + first.radius * first.radius / first.inertia +
                second.radius * second.radius / second.inertia);
  }
  Vector<3> surface_velocity() const {
    return first.velocity - second.velocity -
           (first.radius * first.spin + second.radius * second.spin).cross(normal);
  }
  Vector<3> slip() const { return surface_velocity() - surface_velocity().dot(normal) * normal; }
  double approach() const { return (second.velocity - first.velocity).dot(normal); }
  Vector<3> momentum() const { return first.mass * first.velocity + second.mass * second.velocity; }
  Vector<3> angular_momentum() const {
    Vector<3> sum = Vector<3>::Zero();
    for (const Ball* ball : {&first, &second})
      sum += ball->mass * ball->position.cross(ball->velocity) + ball->inertia * ball->spin;
    return sum;
  }
  double energy() const {
    double sum = 0;
    for (const Ball* ball : {&first, &second})
      sum += ball->mass * ball->velocity.squaredNorm() + ball->inertia * ball->spin.squaredNorm();
    return sum / 2;
  }
};

// The impulses of Baryshev (2003), Eq. 3.57-3.69, which the twelve equations do not contain.
TEST(TwoBalls, StickingImpulsesAreBaryshevs) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Pair pair(seed);
    const Pair before = pair;
    collide(pair.first, pair.second, {0.7, 0.4});
    const Vector<3> impulse = before.first.mass * (pair.first.velocity - before.first.velocity);
    const Vector<3> expected = 1.7 * before.reduced() * before.approach() * before.normal -
                               1.4 * before.tangential_mass() * before.slip();
    EXPECT_LT((impulse - expected).norm(), 1e-13);
    EXPECT_LT((pair.momentum() - before.momentum()).norm(), 1e-13);
    EXPECT_LT((pair.angular_momentum() - before.angular_momentum()).norm(), 1e-12);
    const double loss = (1 - 0.7 * 0.7) * before.reduced() * before.approach() * before.approach() / 2 +
                        (1 - 0.4 * 0.4) * before.tangential_mass() * before.slip().squaredNorm() / 2;
    EXPECT_NEAR(before.energy() - pair.energy(), loss, 1e-12);
  }
}

TEST(TwoBalls, SlidingTakesFrictionTimesTheNormalImpulseAgainstTheSlip) {
  int slid = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    Pair pair(seed);
    const Pair before = pair;
    collide(pair.first, pair.second, {0.7, 0.4, 0.3});
    const Vector<3> impulse = before.first.mass * (pair.first.velocity - before.first.velocity);
    const double along_normal = impulse.dot(before.normal);
    const Vector<3> tangential = impulse - along_normal * before.normal;
    const double sticking = 1.4 * before.tangential_mass() * before.slip().norm();
    slid += sticking > 0.3 * along_normal ? 1 : 0;
    EXPECT_NEAR(along_normal, 1.7 * before.reduced() * before.approach(), 1e-13);
    EXPECT_LT((tangential + std::min(sticking, 0.3 * along_normal) * before.slip().normalized()).norm(),
              1e-13);
    EXPECT_LE(pair.energy(), before.energy());
  }
  EXPECT_GT(slid, 4);
  EXPECT_LT(slid, 20);
}

TEST(TwoBalls, PerfectlyRoughAndElasticReturnsWhenReversed) {
  Pair pair(3);
  const Pair before = pair;
  collide(pair.first, pair.second, {1, 1});
  EXPECT_NEAR(pair.energy(), before.energy(), 1e-13);
  for (Ball* ball : {&pair.first, &pair.second}) {
    ball->velocity = -ball->velocity;
    ball->spin = -ball->spin;
  }
  collide(pair.first, pair.second, {1, 1});
  EXPECT_LT((pair.first.velocity + before.first.velocity).norm(), 1e-13);
  EXPECT_LT((pair.second.spin + before.second.spin).norm(), 1e-12);
}

TEST(TwoBalls, SmoothOnesKeepTheirSpins) {
  Pair pair(5), frictionless(5);
  const Pair before = pair;
  collide(pair.first, pair.second, {0.5});
  collide(frictionless.first, frictionless.second, {0.5, 0.3, 0});
  EXPECT_LT((pair.first.spin - before.first.spin).norm(), 1e-13);
  EXPECT_LT((pair.first.velocity - frictionless.first.velocity).norm(), 1e-13);
}

std::vector<Ball> row(const std::vector<double>& places, const std::vector<double>& velocities) {
  std::vector<Ball> balls(places.size());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    balls[i].position[0] = places[i];
    balls[i].velocity[0] = velocities[i];
  }
  return balls;
}

Touch smooth(double restitution) { return {restitution}; }

TEST(FewBody, TouchesWhenSurfacesMeet) {
  std::vector<Ball> balls = row({0, 4}, {1, -1});
  balls[1].position[1] = 0.6;  // at contact the centres are 0.8 apart along x: after 1.6
  const FewBodyResult result = few_body(
      balls, [](auto, auto) { return smooth(1); }, 3);
  EXPECT_EQ(result.collisions, 1u);
  EXPECT_NEAR(result.last_collision, 1.6, 1e-15);
  EXPECT_NEAR(result.balls[0].velocity[0], 1 - 2 * 0.64, 1e-14);
  EXPECT_NEAR(result.balls[0].velocity[1], -2 * 0.8 * 0.6, 1e-14);
  EXPECT_NEAR(result.balls[0].position[1], -0.96 * 1.4, 1e-14);
}

TEST(FewBody, DoesNotSeeReceding) {
  const auto elastic = [](auto, auto) { return smooth(1); };
  EXPECT_EQ(few_body(row({0, 1}, {-1, 1}), elastic, 5).collisions, 0u);
  EXPECT_EQ(few_body(row({0, 3}, {1, 1}), elastic, 5).collisions, 0u);
}

TEST(FewBody, ThreeInARowEndAsTheMatricesSay) {
  const std::array<double, 3> masses = {1, 0.3, 2}, velocities = {1, 0, -0.4};
  std::vector<Ball> balls = row({0, 1.1, 3}, {1, 0, -0.4});
  for (std::size_t i = 0; i < 3; ++i) balls[i].mass = masses[i];
  const FewBodyResult result = few_body(
      balls, [](auto, auto) { return smooth(0.8); }, 100);
  const RowResult expected = three_in_a_row(masses, 0.8, velocities);
  EXPECT_EQ(static_cast<double>(result.collisions), expected.collisions);
  EXPECT_GT(result.collisions, 2u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(result.balls[i].velocity[0], expected.velocities[i], 1e-14);
}

TEST(FewBody, LastOfTouchingElasticBallsLeaves) {
  const FewBodyResult result = few_body(
      row({0, 3, 4, 5}, {1, 0, 0, 0}), [](auto, auto) { return smooth(1); }, 3);
  EXPECT_EQ(result.collisions, 3u);
  EXPECT_NEAR(result.balls[3].velocity[0], 1, 1e-14);
  EXPECT_NEAR(result.balls[3].position[0], 6, 1e-14);
}

TEST(FewBody, CollapseIsRefused) {
  EXPECT_THROW(few_body(
                   row({0, 1.2, 2.7}, {1, 0, -1}), [](auto, auto) { return smooth(0.05); }, 50, 30),
               InputError);
}

}  // namespace
}  // namespace sandglass::law::few_body_test
