#include "sim/method/collisionless/collisionless.hpp"

#include "sim/method/collisionless/family.hpp"

#include <gtest/gtest.h>

namespace sandglass::collisionless::collisionless_test {
namespace {

const Grid<2> grid({8, 8}, {4, 4});

Particles<2> two_on_a_course() { return {{{{1, 4}, {1, 0}}, {{7, 4}, {-1, 0}}}, {}}; }

TEST(Collisionless, ParticlesPassThroughEachOther) {
  Collisionless<2> gas(grid, {1, 1}, 1, {}, {}, {column::id});
  gas.assign(two_on_a_course());
  for (std::uint64_t step = 0; step < 40; ++step) gas.step(0.1, step);
  const auto particles = gas.view().particles;
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(particles[i].position[0], gas.ids()[i] == 0 ? 5 : 3, 1e-12);
    EXPECT_EQ(particles[i].velocity[0], gas.ids()[i] == 0 ? 1 : -1);
  }
  EXPECT_EQ(gas.tally().collisions, 0u);
  EXPECT_EQ(gas.tally().moves, 80u);
}

TEST(Collisionless, WallsTurnThemBack) {
  motion::MotionParameters<2> motion;
  motion.walled = {true, false};
  Collisionless<2> gas(grid, {1, 1}, 1, motion, {}, {column::id});
  gas.assign(two_on_a_course());
  for (std::uint64_t step = 0; step < 100; ++step) gas.step(0.1, step);
  for (const Phase<2>& particle : gas.view().particles) EXPECT_EQ(std::abs(particle.velocity[0]), 1);
  EXPECT_EQ(gas.view().particles[0].velocity[0] + gas.view().particles[1].velocity[0], 0);
}

TEST(Collisionless, GoesOnAfterARestart) {
  motion::MotionParameters<2> motion;
  motion.walled = {true, true};
  motion.walls = {{0, false, 0, {0, 0}, 0.5, 0.3, {}}};
  Collisionless<2> whole(grid, {1, 1}, 1, motion, {}), first(grid, {1, 1}, 1, motion, {}),
      second(grid, {1, 1}, 1, motion, {});
  whole.assign(two_on_a_course());
  first.assign(two_on_a_course());
  for (std::uint64_t step = 0; step < 60; ++step) whole.step(0.1, step);
  for (std::uint64_t step = 0; step < 30; ++step) first.step(0.1, step);
  const auto half_way = first.view().particles;
  second.assign({{half_way.begin(), half_way.end()}, {}});
  second.load(first.save());
  for (std::uint64_t step = 30; step < 60; ++step) second.step(0.1, step);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(whole.view().particles[i].position, second.view().particles[i].position);
}

TEST(Collisionless, TheFaultOfTheFlightIsOneOfTheFamily) {
  Collisionless<2> gas(grid, {1, 1}, 1, {}, {}, {}, {1.1});
  gas.assign({{{{1, 4}, {1, 0}}}, {}});
  gas.step(1, 0);
  EXPECT_NEAR(gas.view().particles[0].position[0], 2.1, 1e-15);
  EXPECT_EQ(family().faults.front().name, "flight-plus-10-percent");
}

}  // namespace
}  // namespace sandglass::collisionless::collisionless_test
