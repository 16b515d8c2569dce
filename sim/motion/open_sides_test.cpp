#include "sim/base/error.hpp"
#include "sim/motion/entry_stage.hpp"
#include "sim/motion/test_flight.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

// Sides that let particles out, against twins of one coordinate.

namespace sandglass::motion::open_sides_test {
namespace {

constexpr double kDt = 0.4;

/// Open at both ends of the first axis; the last is between walls, others periodic.
template <int D>
MotionParameters<D> table(double gravity) {
  MotionParameters<D> parameters;
  parameters.walled[0] = parameters.walled[D - 1] = true;
  parameters.open[0] = {true, true};
  parameters.gravity[0] = gravity;
  parameters.gravity[D - 1] = -1;
  return parameters;
}

/// -1 and +1: over which end of [0, length] a parabola first leaves within the time t; 0: it stays.
int exit_of(double x, double v, double g, double length, double t) {
  double first = HUGE_VAL;
  int side = 0;
  for (const int end : {-1, 1}) {
    const double gap = end < 0 ? x : length - x, speed = end * v, pull = end * g;
    const double root = std::sqrt(speed * speed + 2 * pull * gap);
    const double time = pull == 0 ? gap / speed : (root - speed) / pull;  // on the way out
    if (!(time >= 0 && time <= t && time < first)) continue;
    first = time;
    side = end;
  }
  return side;
}

template <int D>
void expect_exits(double gravity) {
  auto store = scattered<D>(4);
  std::map<std::uint64_t, Phase<D>> before;
  for (std::size_t i = 0; i < store.size(); ++i) before[store.ids()[i]] = store.phases()[i];
  advance(*make_motion_stage<D>(table<D>(gravity), box<D>()), store, {kDt});
  std::map<int, int> seen, expected;
  for (std::size_t i = 0; i < store.size(); ++i) {
    const double x = before[store.ids()[i]].position[0], v = before[store.ids()[i]].velocity[0];
    const double end = store.phases()[i].position[0], length = box<D>()[0];
    const int side = exit_of(x, v, gravity, length, kDt);
    ++expected[side];
    ASSERT_EQ(store.places()[i].cell == store.removed(), side != 0);
    ++seen[end < 0 ? -1 : end > length ? 1 : 0];
    if (side == 0) {
      ASSERT_NEAR(end, x + kDt * (v + 0.5 * kDt * gravity), 1e-12);
      ASSERT_EQ(store.places()[i].cell, store.grid().cell_of(store.phases()[i].position));
    }
  }
  EXPECT_EQ(seen, expected);
  EXPECT_GT(std::min({seen[-1], seen[0], seen[1]}), 50);
  store.sort();
  EXPECT_EQ(store.size(), static_cast<std::size_t>(expected[0]));
}

/// With gravity along the axis some would come back within the step; they have left all the same.
TEST(OpenSides, LetOutWhoeverReachesThem) {
  for (const double gravity : {0.0, 3.0, -20.0}) {
    expect_exits<2>(gravity);
    expect_exits<3>(gravity);
  }
}

/// The far side reflects: the path is that of a mirrored box of twice the length.
TEST(OpenSides, MayFaceAWall) {
  MotionParameters<2> parameters;
  parameters.walled[0] = true;
  parameters.open[0] = {true, false};
  auto store = scattered<2>(12);
  std::vector<Phase<2>> before(store.phases().begin(), store.phases().end());
  advance(*make_motion_stage<2>(parameters, box<2>()), store, {kDt});
  int left = 0, turned = 0;
  for (std::size_t i = 0; i < store.size(); ++i) {
    const double end = before[i].position[0] + kDt * before[i].velocity[0], length = box<2>()[0];
    const bool out = end < 0 || end > 2 * length;
    left += out;
    turned += !out && end > length;
    ASSERT_EQ(store.places()[i].cell == store.removed(), out);
    if (!out) {
      ASSERT_NEAR(store.phases()[i].position[0], std::min(end, 2 * length - end), 1e-12);
    }
  }
  EXPECT_GT(left, 200);
  EXPECT_GT(turned, 200);
}

TEST(OpenSides, WhomAnOffsetHasPutBeyondThemHasLeft) {
  auto store = scattered<2>(0.1, 0.5);
  int beyond = 0;
  std::vector<bool> out;
  for (const Phase<2>& particle : store.phases())
    beyond += out.emplace_back(particle.position[0] < 0 || particle.position[0] > box<2>()[0]);
  MotionParameters<2> parameters = table<2>(0);
  parameters.offsets = true;
  advance(*make_motion_stage<2>(parameters, box<2>()), store, {1e-6});
  EXPECT_GT(beyond, 100);
  for (std::size_t i = 0; i < store.size(); ++i)
    if (out[i]) {
      ASSERT_EQ(store.places()[i].cell, store.removed());
    }
}

/// A plane that the way out leads through counts; one that it never reaches does not.
TEST(OpenSides, PlanesCountTheWayOut) {
  MotionParameters<2> parameters = table<2>(0);
  parameters.walled[1] = false;
  parameters.gravity.setZero();
  std::vector<Plane> planes{{1, 0.4, {-10, 0, 10}}};
  parameters.planes = &planes;
  // Leaves at time 0.1: passes y = 0.4 on the way, or would pass it later.
  auto store = store_of<2>({{{0.2, 0.3}, {-2, 2}}, {{0.2, 0.3}, {-2, 0.5}}});
  advance(*make_motion_stage<2>(parameters, box<2>()), store, {kDt});
  EXPECT_EQ(planes[0].up(), 1);
}

TEST(OpenSides, ObstaclesStandInTheWay) {
  MotionParameters<2> parameters = table<2>(0);
  parameters.gravity.setZero();
  parameters.obstacles = {{{0.5, 0.5}, 0.3, {}}};
  auto store = store_of<2>({{{1.0, 0.5}, {-3, 0}}, {{1.0, 1.0}, {-3, 0}}});
  advance(*make_motion_stage<2>(parameters, box<2>()), store, {kDt});
  EXPECT_NEAR(store.phases()[0].position[0], 0.8 + (kDt * 3 - 0.2), 1e-12);
  EXPECT_EQ(store.places()[1].cell, store.removed());
}

TEST(OpenSides, NoFullCellKeepsWhoeverLeaves) {
  auto free = scattered<2>(4), refused = scattered<2>(4);
  const MotionParameters<2> parameters = table<2>(0);
  advance(*make_motion_stage<2>(parameters, box<2>()), free, {kDt});
  std::vector<std::uint8_t> full(refused.cells().size() + 1, 1);
  full.back() = 0;
  refused.begin_step();
  make_entry_stage<2>(parameters, box<2>())
      ->advance(refused, 0, refused.cells().size(), {kDt}, {full.data(), nullptr, {}, true});
  for (std::size_t i = 0; i < free.size(); ++i)
    ASSERT_EQ(refused.places()[i].cell == refused.removed(), free.places()[i].cell == free.removed());
  const std::size_t before = refused.size();
  refused.sort();
  EXPECT_LT(refused.size(), before - 200);
}

TEST(OpenSides, NoWallStandsThere) {
  MotionParameters<2> parameters = table<2>(0);
  parameters.walls = {wall<2>(0, true, {})};
  EXPECT_THROW(make_motion_stage<2>(parameters, box<2>()), InputError);
}

}  // namespace
}  // namespace sandglass::motion::open_sides_test
