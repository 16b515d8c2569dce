#include "sim/motion/test_flight.hpp"

#include <gtest/gtest.h>

// What walls take is counted: against balances of momentum and energy, and the two flights against each other.

namespace sandglass::motion::impulses_test {
namespace {

/// Does what a smooth elastic wall does, but is not the plain flight's.
const WallRule kElasticInDisguise = {WallKind::bounce_back, {}, 0, 1};

template <int D>
struct Totals {
  Vector<D> momentum = Vector<D>::Zero();
  double energy = 0;
};

template <int D>
Totals<D> totals(ParticleStore<D>& store, const MotionParameters<D>& parameters) {
  Totals<D> sum;
  for (const Phase<D>& particle : store.phases()) {
    sum.momentum += parameters.mass * particle.velocity;
    sum.energy +=
        parameters.mass * (particle.velocity.squaredNorm() / 2 - parameters.gravity.dot(particle.position));
  }
  return sum;
}

template <int D>
Vector<D> taken(const WallImpulses<D>& impulses) {
  Vector<D> sum = Vector<D>::Zero();
  for (std::size_t side = 0; side < 2 * D; ++side) sum += impulses.impulse(side);
  return sum;
}

/// What gravity gives is what the particles gain and the walls take; counting changes no path.
template <int D>
WallImpulses<D> expect_balance(MotionParameters<D> parameters, const MotionStep& step) {
  WallImpulses<D> impulses;
  auto uncounted = scattered<D>(3), store = scattered<D>(3);
  advance(*make_motion_stage<D>(parameters, box<D>()), uncounted, step);
  const Totals<D> before = totals(store, parameters);
  parameters.impulses = &impulses;
  advance(*make_motion_stage<D>(parameters, box<D>()), store, step);
  const Totals<D> after = totals(store, parameters);
  const Vector<D> given = static_cast<double>(store.size()) * parameters.mass * step.dt * parameters.gravity;
  const double scale = static_cast<double>(store.size()) * parameters.mass * 10 * (1 + step.dt);
  EXPECT_LT((after.momentum - before.momentum + taken(impulses) - given).norm(), 1e-13 * scale);
  for (std::size_t i = 0; i < store.size(); ++i) {
    EXPECT_EQ(store.phases()[i].position, uncounted.phases()[i].position);
    EXPECT_EQ(store.phases()[i].velocity, uncounted.phases()[i].velocity);
  }
  return impulses;
}

template <int D>
MotionParameters<D> room(int code, int pulled) {
  MotionParameters<D> parameters;
  parameters.mass = 0.7;
  for (int axis = 0; axis < D; ++axis) parameters.walled[static_cast<std::size_t>(axis)] = code >> axis & 1;
  if (pulled >= 0) parameters.gravity[pulled] = -0.7;
  return parameters;
}

/// Plain walls, and the same as walls of the general flight: side by side the same.
template <int D>
void expect_plain_like_general() {
  for (int code = 1; code < 1 << D; ++code)
    for (int pulled = -1; pulled < D; ++pulled)
      for (double dt : {1e-3, 0.3, 5.0}) {
        MotionParameters<D> parameters = room<D>(code, pulled);
        const auto plain = expect_balance<D>(parameters, {dt});
        for (int axis = 0; axis < D; ++axis)
          if (code >> axis & 1) parameters.walls.push_back(wall<D>(axis, false, kElasticInDisguise));
        const auto general = expect_balance<D>(parameters, {dt});
        for (std::size_t side = 0; side < 2 * D; ++side) {
          const bool walled = code >> (side / 2) & 1;
          EXPECT_TRUE(walled || plain.impulse(side).isZero(0));
          EXPECT_TRUE(!walled || dt < 0.1 || plain.impulse(side).norm() > 0);
          EXPECT_LT((plain.impulse(side) - general.impulse(side)).norm(), 1e-11 * (1 + dt) * 2000);
          EXPECT_EQ(plain.work(side), 0);
        }
      }
}
TEST(Impulses, OfPlainWallsAreThoseOfTheGeneralFlight) {
  expect_plain_like_general<2>();
  expect_plain_like_general<3>();
}

/// Every rule balances the momentum; shear along a plate that slides shows up in its tangential component.
template <int D>
void expect_rules() {
  for (const WallKind kind :
       {WallKind::specular, WallKind::bounce_back, WallKind::random_tangential_sign, WallKind::thermal}) {
    MotionParameters<D> parameters = room<D>((1 << D) - 1, 1);
    WallPlace<D> floor = wall<D>(1, false, {kind, {{0.6}}, 1, 2}),
                 lid = wall<D>(1, true, {kind, {{0.6}}, 1, 2});
    floor.amplitude = 0.05, floor.frequency = 2;
    lid.velocity[0] = 3;
    parameters.walls = {floor, lid};
    const auto impulses = expect_balance<D>(parameters, {0.4, 0.3, wall_key(1)});
    const std::size_t low = WallImpulses<D>::side(1, false), high = WallImpulses<D>::side(1, true);
    EXPECT_LT(impulses.impulse(low)[1], 0);
    EXPECT_GT(impulses.impulse(high)[1], 0);
    EXPECT_NE(impulses.work(low), 0);
    EXPECT_EQ(impulses.impulse(high)[0] < -100, kind != WallKind::specular);
    EXPECT_EQ(impulses.impulse(high)[0] == 0, kind == WallKind::specular);
    EXPECT_NEAR(impulses.work(high), -3 * impulses.impulse(high)[0], 1e-13 * impulses.work(high));
  }
}
TEST(Impulses, BalanceForEveryRule) {
  expect_rules<2>();
  expect_rules<3>();
}

/// Elastic walls that move: the energy that particles gain is the work of the walls.
template <int D>
void expect_work() {
  MotionParameters<D> parameters = room<D>((1 << D) - 1, D - 1);
  WallPlace<D> floor = wall<D>(D - 1, false, {}), lid = wall<D>(D - 1, true, {});
  floor.amplitude = 0.06, floor.frequency = 2.5;
  lid.velocity[D - 1] = -0.2;
  parameters.walls = {floor, lid};
  WallImpulses<D> impulses;
  parameters.impulses = &impulses;
  auto store = scattered<D>(3);
  const Totals<D> before = totals(store, parameters);
  const auto motion = make_motion_stage<D>(parameters, box<D>());
  advance(*motion, store, {0.2, 0});
  const double work =
      impulses.work(WallImpulses<D>::side(D - 1, false)) + impulses.work(WallImpulses<D>::side(D - 1, true));
  // What begins below the floor is first lifted: the floor is highest after a tenth of the time and begins at 0.
  EXPECT_NEAR(totals(store, parameters).energy - before.energy, work, 1e-9 * before.energy);
  EXPECT_GT(work, 0);
}
TEST(Impulses, OfMovingWallsDoTheWorkThatParticlesGain) {
  expect_work<2>();
  expect_work<3>();
}

/// What particles gain is the work of the walls less the heat that these take, whatever the rule.
template <int D>
void expect_heat() {
  for (const WallKind kind :
       {WallKind::specular, WallKind::bounce_back, WallKind::random_tangential_sign, WallKind::thermal}) {
    MotionParameters<D> parameters = room<D>((1 << D) - 1, D - 1);
    WallPlace<D> floor = wall<D>(D - 1, false, {kind, {{0.6}}, 1, 2}),
                 lid = wall<D>(D - 1, true, {kind, {{0.6}}, 1, 2});
    floor.amplitude = 0.06, floor.frequency = 2.5;
    lid.velocity[0] = 3;
    parameters.walls = {floor, lid};
    WallImpulses<D> impulses;
    parameters.impulses = &impulses;
    auto store = scattered<D>(3);
    const Totals<D> before = totals(store, parameters);
    advance(*make_motion_stage<D>(parameters, box<D>()), store, {0.2, 0, wall_key(1)});
    double gain = 0;
    for (std::size_t side = 0; side < 2 * D; ++side) gain += impulses.work(side) - impulses.heat(side);
    EXPECT_NEAR(totals(store, parameters).energy - before.energy, gain, 1e-9 * before.energy);
    EXPECT_NE(impulses.heat(WallImpulses<D>::side(D - 1, false)), 0);
    EXPECT_NEAR(impulses.heat(WallImpulses<D>::side(0, false)), 0, 1e-12 * before.energy);
  }
}
TEST(Impulses, HeatIsWhatWallsTakeBesideTheirWork) {
  expect_heat<2>();
  expect_heat<3>();
}

/// A ball that loses its last bounces weighs on the floor all the same.
TEST(Impulses, OfABallAtRestAreItsWeight) {
  MotionParameters<2> parameters = room<2>(2, 1);
  for (const double restitution : {0.0, 0.8, 1.0}) {
    parameters.walls = {wall<2>(1, false, {WallKind::specular, {{restitution}}})};
    WallImpulses<2> impulses;
    parameters.impulses = &impulses;
    auto store = store_of<2>({{{1, 0.5}, {0.3, 0}}});
    const auto motion = make_motion_stage<2>(parameters, box<2>());
    for (int step = 0; step < 400; ++step) {
      advance(*motion, store, {0.1});
      store.sort();
    }
    const Vector<2> floor = impulses.impulse(WallImpulses<2>::side(1, false));
    EXPECT_NEAR(floor[1], -0.7 * (0.7 * 40 + store.phases()[0].velocity[1]), 1e-10) << restitution;
    EXPECT_EQ(floor[0], 0);
  }
}

}  // namespace
}  // namespace sandglass::motion::impulses_test
