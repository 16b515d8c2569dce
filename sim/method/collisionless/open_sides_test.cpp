#include "sim/method/collisionless/collisionless.hpp"
#include "sim/space/particles.hpp"

#include <cmath>

#include <boost/random/normal_distribution.hpp>
#include <gtest/gtest.h>

// A gas that flies out of its box.

namespace sandglass::collisionless::open_sides_test {
namespace {

constexpr double kLength = 8, kDt = 0.1;
const Grid<2> grid({kLength, kLength}, {4, 4});

Particles<2> gas_at_rest(std::size_t count) {
  Random random(StreamKey(7, Purpose::positions, 0, 0), 0);
  boost::random::normal_distribution<double> normal;
  Particles<2> particles;
  for (std::size_t i = 0; i < count; ++i)
    particles.phases.push_back(
        {{kLength * random.uniform(), kLength * random.uniform()}, {normal(random), normal(random)}});
  return particles;
}

motion::MotionParameters<2> open_at_x() {
  motion::MotionParameters<2> motion;
  motion.walled[0] = true;
  motion.open[0] = {true, true};
  return motion;
}

/// Of particles spread evenly over [0, L] the share max(0, 1 - |v| t / L) at speed v is still there. Its mean over
/// Maxwell's distribution of width one, with u = L / t.
double share_left(double t) {
  const double u = kLength / t;
  return std::erf(u / M_SQRT2) - std::sqrt(2 / M_PI) * (1 - std::exp(-u * u / 2)) / u;
}

TEST(OpenSides, AGasFliesAwayAsItsVelocitiesSay) {
  constexpr std::size_t kCount = 20000;
  Collisionless<2> gas(grid, {1, 1}, 1, open_at_x(), {});
  gas.assign(gas_at_rest(kCount));
  for (std::uint64_t step = 0; step < 60; ++step) {
    gas.step(kDt, step);
    if (step % 10 != 9) continue;
    const double share = share_left(kDt * static_cast<double>(step + 1));
    const double error = std::sqrt(share * (1 - share) / kCount);  // binomial
    EXPECT_NEAR(static_cast<double>(gas.size()) / kCount, share, 4 * error) << step;
  }
}

TEST(OpenSides, EveryoneWhoHasLeftIsCounted) {
  constexpr std::size_t kCount = 1000;
  Collisionless<2> gas(grid, {1, 1}, 1, open_at_x(), {});
  gas.assign(gas_at_rest(kCount));
  for (std::uint64_t step = 0; step < 30; ++step) {
    gas.step(kDt, step);
    const auto counters = gas.counters();
    ASSERT_EQ(counters.at("particles-left") + static_cast<double>(gas.size()), kCount);
    ASSERT_EQ(counters.at("particles-left-x-low") + counters.at("particles-left-x-high"),
              counters.at("particles-left"));
    ASSERT_FALSE(counters.contains("particles-left-y-low"));
  }
  EXPECT_GT(gas.counters().at("particles-left-x-low"), 50);
  EXPECT_GT(gas.counters().at("particles-left-x-high"), 50);
}

/// Of a box that is longer than high: each side counts its own.
TEST(OpenSides, EverySideCountsThoseWhoLeaveByIt) {
  motion::MotionParameters<2> motion;
  motion.walled = {true, true};
  motion.open = {{{true, true}, {true, true}}};
  Collisionless<2> gas(Grid<2>({kLength, 2}, {4, 4}), {1, 1}, 1, motion, {});
  Particles<2> particles;
  const std::array<Vector<2>, 4> velocities = {{{-9, 0}, {9, 0}, {0, -9}, {0, 9}}};
  for (std::size_t side = 0; side < 4; ++side)
    for (std::size_t i = 0; i <= side; ++i) particles.phases.push_back({{4, 1}, velocities[side]});
  gas.assign(particles);
  for (std::uint64_t step = 0; step < 10; ++step) gas.step(kDt, step);
  const auto counters = gas.counters();
  EXPECT_EQ(counters.at("particles-left-x-low"), 1);
  EXPECT_EQ(counters.at("particles-left-x-high"), 2);
  EXPECT_EQ(counters.at("particles-left-y-low"), 3);
  EXPECT_EQ(counters.at("particles-left-y-high"), 4);
  EXPECT_EQ(counters.at("particles-left"), 10);
}

TEST(OpenSides, CountsGoOnAfterARestart) {
  Collisionless<2> whole(grid, {1, 1}, 1, open_at_x(), {}), second(grid, {1, 1}, 1, open_at_x(), {});
  whole.assign(gas_at_rest(500));
  for (std::uint64_t step = 0; step < 20; ++step) whole.step(kDt, step);
  const auto half_way = whole.view().particles;
  second.assign({{half_way.begin(), half_way.end()}, {}});
  second.load(whole.save());
  for (std::uint64_t step = 20; step < 40; ++step) {
    whole.step(kDt, step);
    second.step(kDt, step);
  }
  EXPECT_EQ(whole.counters(), second.counters());
  ASSERT_EQ(whole.size(), second.size());
  for (std::size_t i = 0; i < whole.size(); ++i)
    EXPECT_EQ(whole.view().particles[i].position, second.view().particles[i].position);
}

/// All leave in the end, and an empty box goes on.
TEST(OpenSides, AnEmptyBoxGoesOn) {
  Collisionless<2> gas(grid, {1, 1}, 1, open_at_x(), {});
  gas.assign({{{{1, 1}, {-5, 1}}, {{2, 3}, {9, 0}}}, {}});
  for (std::uint64_t step = 0; step < 20; ++step) gas.step(kDt, step);
  EXPECT_EQ(gas.size(), 0u);
  EXPECT_EQ(gas.counters().at("particles-left-x-low"), 1);
  EXPECT_EQ(gas.counters().at("particles-left-x-high"), 1);
}

}  // namespace
}  // namespace sandglass::collisionless::open_sides_test
