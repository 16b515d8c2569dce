#include "sim/method/dsmc/dsmc.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

// The gas between walls that move and draw: what a restart needs.

namespace sandglass::dsmc::walls_test {
namespace {

constexpr double kDt = 0.05;

template <int D>
motion::MotionParameters<D> shaken_room() {
  motion::MotionParameters<D> parameters;
  parameters.walled[0] = true;
  parameters.walls = {{0, false, 0, Vector<D>::Zero(), 0.3, 0.7, {}},
                      {0, true, 4, 0.2 * Vector<D>::Unit(0), 0, 0, {WallKind::thermal, {}, 1, 2}}};
  parameters.obstacles = {{Vector<D>::Constant(2), 0.5, {WallKind::random_tangential_sign}}};
  return parameters;
}

template <int D>
Dsmc<D> gas(const motion::MotionParameters<D>& motion, const std::vector<Phase<D>>& particles) {
  std::array<std::uint32_t, D> cells;
  cells.fill(4);
  Parameters parameters;
  parameters.cross_section = 0.05;
  Dsmc<D> dsmc(Grid<D>(Vector<D>::Constant(4), cells), parameters, motion, {});
  dsmc.assign({particles, {}});
  return dsmc;
}

template <int D>
std::vector<Phase<D>> some_particles() {
  Random random(StreamKey(1, Purpose::positions, 0, 0), 0);
  std::vector<Phase<D>> list(1000);
  for (Phase<D>& particle : list)
    for (int axis = 0; axis < D; ++axis) {
      particle.position[axis] = 4 * random.uniform();
      particle.velocity[axis] = 2 * random.uniform() - 1;
    }
  return list;
}

template <int D>
std::vector<Phase<D>> particles_of(Dsmc<D>& dsmc) {
  const auto particles = dsmc.view().particles;
  return {particles.begin(), particles.end()};
}

/// Particles have followed the moving wall out of the box by the time of the restart.
template <int D>
void expect_restart() {
  const auto motion = shaken_room<D>();
  Dsmc<D> whole = gas<D>(motion, some_particles<D>());
  std::uint64_t step = 0;
  for (; step < 30; ++step) whole.step(kDt, step);
  const auto middle = particles_of(whole);
  ASSERT_TRUE(std::ranges::any_of(middle, [](const auto& particle) { return particle.position[0] > 4; }));
  Dsmc<D> resumed = gas<D>(motion, middle);
  resumed.load(whole.save());
  for (; step < 60; ++step) {
    whole.step(kDt, step);
    resumed.step(kDt, step);
  }
  EXPECT_TRUE(std::ranges::equal(
      particles_of(whole), particles_of(resumed),
      [](const auto& a, const auto& b) { return a.position == b.position && a.velocity == b.velocity; }));
}
TEST(DsmcWalls, RestartIsBitwise) {
  expect_restart<2>();
  expect_restart<3>();
}

/// Between walls that draw every velocity anew no two are alike.
TEST(DsmcWalls, DrawAnewInEveryStep) {
  motion::MotionParameters<2> motion;
  motion.walled[0] = true;
  for (const bool high : {false, true})
    motion.walls.push_back(
        {0, high, high ? 1.0 : 0.0, Vector<2>::Zero(), 0, 0, {WallKind::thermal, {}, 1, 1}});
  Dsmc<2> dsmc(Grid<2>({1, 1}, {1, 1}), {}, motion, {});
  dsmc.assign({{{{0.5, 0.5}, {1, 0}}}, {}});
  std::set<double> speeds;
  for (std::uint64_t step = 0; step < 100; ++step) {
    dsmc.step(2, step);
    speeds.insert(dsmc.view().particles[0].velocity[0]);
  }
  EXPECT_GT(speeds.size(), 80u);
}

TEST(DsmcWalls, TimeIsSavedOnlyIfAWallMoves) {
  auto motion = shaken_room<2>();
  EXPECT_TRUE(gas<2>(motion, {}).save().contains("motion/time"));
  motion.walls.erase(motion.walls.begin());
  motion.walls.front().velocity.setZero();
  EXPECT_FALSE(gas<2>(motion, {}).save().contains("motion/time"));
}

}  // namespace
}  // namespace sandglass::dsmc::walls_test
