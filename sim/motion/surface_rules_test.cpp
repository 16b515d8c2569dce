#include "sim/base/statistics.hpp"
#include "sim/motion/test_flight.hpp"

#include <gtest/gtest.h>

// What particles do at walls and obstacles, rule by rule, through a whole step.

namespace sandglass::motion::surface_rules_test {
namespace {

constexpr double kDt = 0.2, kHeight = 0.1, kFall = 1, kSlip = 0.7;

/// Particles over the floor, the low wall of the last axis, that reach it once within a step of kDt.
template <int D>
std::vector<Phase<D>> over_the_floor(std::size_t count) {
  Vector<D> place = Vector<D>::Constant(0.8), velocity = Vector<D>::Constant(kSlip);
  place[D - 1] = kHeight;
  velocity[D - 1] = -kFall;
  return std::vector<Phase<D>>(count, {place, velocity});
}

template <int D>
MotionParameters<D> over(const WallPlace<D>& floor) {
  MotionParameters<D> parameters;
  parameters.walled[D - 1] = true;
  parameters.walls = {floor};
  return parameters;
}

template <int D>
std::vector<Phase<D>> after(const MotionParameters<D>& parameters, const std::vector<Phase<D>>& particles,
                            const MotionStep& step) {
  auto store = store_of<D>(particles);
  advance(*make_motion_stage<D>(parameters, box<D>()), store, step);
  return {store.phases().begin(), store.phases().end()};
}

template <int D>
Phase<D> one_after(const WallPlace<D>& floor, const MotionStep& step = {kDt}) {
  return after<D>(over<D>(floor), over_the_floor<D>(1), step).front();
}

template <int D>
void expect_restitution() {
  const Phase<D> end = one_after<D>(wall<D>(D - 1, false, {WallKind::specular, {{0.6}}}));
  EXPECT_NEAR(end.velocity[D - 1], 0.6 * kFall, 1e-15);
  EXPECT_NEAR(end.position[D - 1], 0.6 * kFall * (kDt - kHeight / kFall), 1e-15);
  EXPECT_EQ(end.velocity[0], kSlip);
  EXPECT_NEAR(end.position[0], 0.8 + kSlip * kDt, 1e-15);
}
TEST(WallRules, SpecularTakesTheRestitution) {
  expect_restitution<2>();
  expect_restitution<3>();
}

/// A wall at speed U turns v into 2U - v, wherever it has come by then.
template <int D>
void expect_moving_wall() {
  constexpr double kWall = 0.3, kTime = 2;
  WallPlace<D> floor = wall<D>(D - 1, false, {});
  floor.velocity[D - 1] = kWall;
  floor.edge = -kWall * kTime;  // at zero when the step begins
  const Phase<D> end = one_after<D>(floor, {kDt, kTime});
  const double hit = kHeight / (kFall + kWall);
  EXPECT_NEAR(end.velocity[D - 1], 2 * kWall + kFall, 1e-14);
  EXPECT_NEAR(end.position[D - 1], kWall * hit + (2 * kWall + kFall) * (kDt - hit), 1e-14);
}
TEST(WallRules, MovingWallAddsTwiceItsSpeed) {
  expect_moving_wall<2>();
  expect_moving_wall<3>();
}

/// Where the wall has left the box, particles follow it and count as in the cell at the edge.
TEST(WallRules, WallMayLeaveTheBox) {
  WallPlace<2> floor = wall<2>(1, false, {});
  floor.velocity[1] = -0.5;
  auto store = store_of<2>(over_the_floor<2>(1));
  const auto motion = make_motion_stage<2>(over<2>(floor), box<2>());
  for (int step = 0; step < 4; ++step) {
    advance(*motion, store, {0.1, 0.1 * step});
    store.sort();
  }
  EXPECT_NEAR(store.phases()[0].velocity[1], 0, 1e-14);  // 2U - v
  EXPECT_NEAR(store.phases()[0].position[1], -0.1, 1e-14);
  EXPECT_EQ(store.offsets()[5], 1u);  // in the lowest row
}

template <int D>
void expect_back(double probability) {
  constexpr std::size_t kCount = 20000;
  const auto end = after<D>(over<D>(wall<D>(D - 1, false, {WallKind::bounce_back, {}, probability})),
                            over_the_floor<D>(kCount), {kDt, 0, wall_key(0)});
  double back = 0;
  for (const Phase<D>& particle : end) {
    ASSERT_EQ(particle.velocity.cwiseAbs(), over_the_floor<D>(1)[0].velocity.cwiseAbs());
    ASSERT_GT(particle.velocity[D - 1], 0);
    back += particle.velocity[0] < 0;
  }
  EXPECT_NEAR(back, probability * kCount, 4.5 * std::sqrt(kCount * probability * (1 - probability)));
}
TEST(WallRules, BounceBackReversesItsShare) {
  for (const double probability : {0.0, 0.3, 1.0}) {
    expect_back<2>(probability);
    expect_back<3>(probability);
  }
}

/// Each tangential component turns half of the time, by itself.
TEST(WallRules, RandomSignTurnsHalf) {
  constexpr std::size_t kCount = 20000;
  const auto end = after<3>(over<3>(wall<3>(2, false, {WallKind::random_tangential_sign})),
                            over_the_floor<3>(kCount), {kDt, 0, wall_key(0)});
  int turned[2][2] = {};
  for (const Phase<3>& particle : end) {
    ASSERT_NEAR(particle.velocity.norm(), over_the_floor<3>(1)[0].velocity.norm(), 1e-14);
    ++turned[particle.velocity[0] < 0][particle.velocity[1] < 0];
  }
  for (const auto& row : turned)
    for (const int count : row) EXPECT_NEAR(count, kCount / 4.0, 4.5 * std::sqrt(kCount * 3.0 / 16));
}

/// Particles of mass m leave a thermal wall with <v_n> = sqrt(pi T / (2 m)), <v_n^2> = 2 T / m, <v_t^2> = T / m.
template <int D>
void expect_thermal() {
  constexpr double kTemperature = 1.7, kMass = 2.5;
  auto parameters = over<D>(wall<D>(D - 1, false, {WallKind::thermal, {}, 1, kTemperature}));
  parameters.mass = kMass;
  const auto end = after<D>(parameters, over_the_floor<D>(40000), {kDt, 0, wall_key(0)});
  std::vector<double> normal, square, along;
  for (const Phase<D>& particle : end) {
    normal.push_back(particle.velocity[D - 1]);
    square.push_back(normal.back() * normal.back());
    along.push_back(particle.velocity[0] * particle.velocity[0]);
  }
  const auto expect_mean = [](const std::vector<double>& values, double expected) {
    const Mean mean = mean_of_independent(values);
    EXPECT_NEAR(mean.value, expected, 4.5 * mean.standard_error);
    EXPECT_LT(mean.standard_error, 0.01 * expected);
  };
  expect_mean(normal, std::sqrt(M_PI * kTemperature / (2 * kMass)));
  expect_mean(square, 2 * kTemperature / kMass);
  expect_mean(along, kTemperature / kMass);
}
TEST(WallRules, ThermalWallHasTheFluxOfItsTemperature) {
  expect_thermal<2>();
  expect_thermal<3>();
}

/// Head on, and at 45 degrees from the side: the normal of a disk or sphere where it is hit.
template <int D>
void expect_reflection() {
  MotionParameters<D> parameters;
  parameters.obstacles = {{Vector<D>::Constant(0.8), 0.5, {}}};
  const Vector<D> x = Vector<D>::Unit(0), y = Vector<D>::Unit(1), centre = parameters.obstacles[0].centre;
  const double side = 0.5 * std::sqrt(0.5);
  const auto end =
      after<D>(parameters, {{centre - 0.6 * x, x}, {centre - (side + 0.1) * x + side * y, x}}, {0.3});
  const Phase<D>& head_on = end[0].velocity[0] < -0.5 ? end[0] : end[1];
  const Phase<D>& aside = end[0].velocity[0] < -0.5 ? end[1] : end[0];
  EXPECT_LT((head_on.velocity + x).norm(), 1e-14);
  EXPECT_LT((head_on.position - (centre - 0.7 * x)).norm(), 1e-14);
  EXPECT_LT((aside.velocity - y).norm(), 1e-14);
  EXPECT_LT((aside.position - (centre - side * x + (side + 0.2) * y)).norm(), 1e-14);
}
TEST(ObstacleRules, ReflectAboutTheNormal) {
  expect_reflection<2>();
  expect_reflection<3>();
}

/// A ball dropped on the top of an obstacle is back after two times of fall.
template <int D>
void expect_fall() {
  MotionParameters<D> parameters;
  parameters.gravity[1] = -2;
  parameters.obstacles = {{Vector<D>::Constant(0.8), 0.3, {}}};
  const Vector<D> start = Vector<D>::Constant(0.8) + 0.55 * Vector<D>::Unit(1);
  const double fall = std::sqrt(0.25);
  const auto end = after<D>(parameters, {{start, Vector<D>::Zero()}}, {2 * fall});
  EXPECT_LT((end[0].position - start).norm(), 1e-14);
  EXPECT_LT(end[0].velocity.norm(), 1e-14);
}
TEST(ObstacleRules, FallingBallComesBack) {
  expect_fall<2>();
  expect_fall<3>();
}

/// Thrown up from below, a ball hits the obstacle on a path that begins and ends lower: it hits at the height 0.1 after
/// sqrt(0.25) - sqrt(0.05).
template <int D>
void expect_throw() {
  MotionParameters<D> parameters;
  parameters.gravity[1] = -1;
  parameters.obstacles = {{Vector<D>::Constant(1), 0.4, {}}};
  const Vector<D> up = Vector<D>::Unit(1), start = Vector<D>::Constant(1) - 0.5 * up;
  const auto end = after<D>(parameters, {{start, 0.5 * up}}, {1});
  const double speed = std::sqrt(0.05), rest = 1 - (0.5 - speed);
  EXPECT_LT((end[0].velocity + (speed + rest) * up).norm(), 1e-14);
  EXPECT_LT((end[0].position - (start + (0.1 - rest * (speed + rest / 2)) * up)).norm(), 1e-14);
}
TEST(ObstacleRules, ArcMeetsWhatItsChordPasses) {
  expect_throw<2>();
  expect_throw<3>();
}

/// Between elastic surfaces at rest the energy of every particle stays, gravity included.
template <int D>
void expect_energy() {
  MotionParameters<D> parameters;
  parameters.walled.fill(true);
  parameters.gravity[D - 1] = -1;
  parameters.obstacles = some_obstacles<D>({WallKind::bounce_back, {}, 0.5});
  const auto energy = [](const Phase<D>& p) { return 0.5 * p.velocity.squaredNorm() + p.position[D - 1]; };
  auto store = scattered<D>(2);
  const auto motion = make_motion_stage<D>(parameters, box<D>());
  advance(*motion, store, {1e-9, 0, wall_key(0)});  // out of the obstacles
  std::vector<double> before(store.size());
  store.sort();
  for (std::size_t i = 0; i < store.size(); ++i) before[store.ids()[i]] = energy(store.phases()[i]);
  for (std::uint64_t step = 1; step < 30; ++step) {
    advance(*motion, store, {0.3, 0, wall_key(step)});
    store.sort();
  }
  for (std::size_t i = 0; i < store.size(); ++i)
    ASSERT_NEAR(energy(store.phases()[i]), before[store.ids()[i]], 1e-11);
}
TEST(ObstacleRules, ElasticSurfacesKeepTheEnergy) {
  expect_energy<2>();
  expect_energy<3>();
}

}  // namespace
}  // namespace sandglass::motion::surface_rules_test
