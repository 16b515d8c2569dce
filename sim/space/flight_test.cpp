#include "sim/space/flight.hpp"

#include "sim/base/random.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace sandglass::flight_test {
namespace {

std::vector<double> lengths() {
  std::vector<double> list{1, 49, 0.1, 10.0 / 3, 7.3e5};
  Random random(StreamKey(4, Purpose::positions, 0, 0), 0);
  for (int i = 0; i < 200; ++i) list.push_back(0.1 + 10 * random.uniform());
  return list;
}

/// Multiples of the length and their neighbours in floating point, both signs, and points far off.
std::vector<double> awkward_points(double length) {
  std::vector<double> points{0, -0.0, 1e-300, -1e-300, -1e-20, 1e9 * length, -1e9 * length};
  for (int multiple = -30; multiple <= 30; ++multiple) {
    const double x = multiple * length;
    points.insert(points.end(),
                  {x, std::nextafter(x, HUGE_VAL), std::nextafter(x, -HUGE_VAL), x + 0.3 * length});
  }
  return points;
}

TEST(Wrap, StaysInTheHalfOpenPeriod) {
  for (double length : lengths())
    for (double x : awkward_points(length)) {
      const double wrapped = wrap(x, length, 1 / length);
      EXPECT_GE(wrapped, 0) << x << " in " << length;
      EXPECT_LT(wrapped, length) << x << " in " << length;
      const double periods = (x - wrapped) / length;
      EXPECT_NEAR(periods, std::round(periods), 1e-12 * (1 + std::fabs(periods))) << x << " in " << length;
    }
}

TEST(Mirror, StaysBetweenTheWalls) {
  for (double length : lengths())
    for (double x : awkward_points(length)) {
      const double mirrored = mirror(x, length);
      EXPECT_GE(mirrored, 0) << x << " in " << length;
      EXPECT_LE(mirrored, length) << x << " in " << length;
      // cos(pi x / length) is even and has period 2 length, as the mirror images have.
      if (std::fabs(x) > 100 * length) continue;
      EXPECT_NEAR(std::cos(M_PI * mirrored / length), std::cos(M_PI * x / length), 1e-12)
          << x << " in " << length;
    }
}

struct Motion {
  double x, velocity;
  HitSpeeds hits = {};
  int count = 0;  ///< of the hits, by the twin
};

/// Smooth elastic walls give back twice the momentum that comes, and a force adds its own.
void expect_balance(const Motion& start, const Motion& end, double acceleration, double dt) {
  const double gain = acceleration * dt + 2 * (end.hits.low - end.hits.high);
  EXPECT_NEAR(end.velocity - start.velocity, gain, 1e-12 * (1 + end.hits.low + end.hits.high));
}

/// The slow twin: many tiny steps, exact between walls, each reflected where it passes a wall.
Motion creep(Motion motion, double acceleration, double dt, double length, int steps) {
  const double tiny = dt / steps;
  for (int i = 0; i < steps; ++i) {
    motion.x += tiny * (motion.velocity + 0.5 * acceleration * tiny);
    motion.velocity += acceleration * tiny;
    const bool low = motion.x < 0 && motion.velocity<0, high = motion.x> length && motion.velocity > 0;
    if (low) motion.x = -motion.x;
    if (high) motion.x = 2 * length - motion.x;
    if (!low && !high) continue;
    motion.hits.add(high, std::fabs(motion.velocity));
    motion.velocity = -motion.velocity;
    ++motion.count;
  }
  return motion;
}

TEST(FlyBetweenWalls, AgreesWithManyTinySteps) {
  Random random(StreamKey(1, Purpose::positions, 0, 0), 0);
  for (int trial = 0; trial < 500; ++trial) {
    const double length = 0.5 + random.uniform();
    Motion motion{length * random.uniform(), 20 * random.uniform() - 10};
    const Motion twin = creep(motion, 0, 1, length, 1000);
    const Motion start = motion;
    fly_between_walls(motion.x, motion.velocity, 1, length, &motion.hits);
    EXPECT_NEAR(motion.x, twin.x, 1e-11);
    EXPECT_NEAR(motion.hits.low, twin.hits.low, 1e-12 * twin.hits.low);
    EXPECT_NEAR(motion.hits.high, twin.hits.high, 1e-12 * twin.hits.high);
    expect_balance(start, motion, 0, 1);
    EXPECT_EQ(motion.velocity, twin.velocity);
  }
}

TEST(FlyBetweenWalls, AgreesWithTheUnfoldedPathForVeryLongSteps) {
  for (double velocity : {1e6, -1e6, 3.3e8}) {
    Motion motion{0.3, velocity};
    fly_between_walls(motion.x, motion.velocity, 1, 2);
    EXPECT_EQ(motion.x, mirror(0.3 + velocity, 2));
    EXPECT_EQ(std::fabs(motion.velocity), std::fabs(velocity));
  }
}

/// A bounce moves the twin by up to the height of one tiny step, hence the bound.
TEST(FallBetweenWalls, AgreesWithManyTinySteps) {
  Random random(StreamKey(2, Purpose::positions, 0, 0), 0);
  for (int trial = 0; trial < 300; ++trial) {
    const double length = 0.5 + random.uniform(), acceleration = 10 * random.uniform() - 5;
    Motion motion{length * random.uniform(), 8 * random.uniform() - 4};
    const Motion twin = creep(motion, acceleration, 1, length, 100'000);
    const Motion start = motion;
    fall_between_walls(motion.x, motion.velocity, acceleration, 1, length, &motion.hits);
    expect_balance(start, motion, acceleration, 1);
    EXPECT_NEAR(motion.x, twin.x, 3e-3)
        << start.x << " " << start.velocity << " " << acceleration << " " << length;
    // The twin may be a tiny step early or late at its last wall.
    if (motion.x > 1e-2 && motion.x < length - 1e-2) {
      EXPECT_NEAR(motion.velocity, twin.velocity, 1e-2);
      EXPECT_NEAR(motion.hits.low, twin.hits.low, 1e-2 * (1 + twin.count));
      EXPECT_NEAR(motion.hits.high, twin.hits.high, 1e-2 * (1 + twin.count));
    }
  }
}

double energy(const Motion& motion, double acceleration) {
  return 0.5 * motion.velocity * motion.velocity - acceleration * motion.x;
}

TEST(FallBetweenWalls, ConservesEnergy) {
  Random random(StreamKey(3, Purpose::positions, 0, 0), 0);
  for (int trial = 0; trial < 20000; ++trial) {
    const double acceleration = trial % 2 == 0 ? -2.0 : 3.0;
    Motion motion{random.uniform(), 4 * random.uniform() - 2};
    const double before = energy(motion, acceleration);
    fall_between_walls(motion.x, motion.velocity, acceleration, 10 * random.uniform(), 1);
    ASSERT_NEAR(energy(motion, acceleration), before, 1e-12);
    ASSERT_GE(motion.x, 0);
    ASSERT_LE(motion.x, 1);
  }
}

/// Bounces of height v^2/2g, thousands of them in one step: whole periods change nothing.
TEST(FallBetweenWalls, CountsAnyNumberOfLowBounces) {
  for (double speed : {1e-2, 1e-4, 1e-6, 1e-9}) {
    Motion motion{0, speed};
    const double period = 2 * speed;
    fall_between_walls(motion.x, motion.velocity, -1, (20000 + 0.25) * period, 1);
    EXPECT_NEAR(energy(motion, -1) / (0.5 * speed * speed), 1, 1e-6) << "speed " << speed;
    EXPECT_NEAR(motion.velocity / speed, 0.5, 1e-6) << "speed " << speed;
  }
}

TEST(FallBetweenWalls, CountsAnyNumberOfCrossings) {
  Motion motion{0, 1e4};
  // From floor to ceiling against g = 1: v - sqrt(v^2 - 2).
  const double across = 2 / (1e4 + std::sqrt(1e8 - 2));
  fall_between_walls(motion.x, motion.velocity, -1, 5001.5 * across, 1);
  EXPECT_NEAR(motion.x, 0.5, 1e-6);
  EXPECT_NEAR(energy(motion, -1) / 5e7, 1, 1e-12);
  EXPECT_LT(motion.velocity, 0);
}

TEST(FallBetweenWalls, RestingParticleRests) {
  for (double acceleration : {-9.8, 9.8}) {
    const double wall = acceleration < 0 ? 0 : 1;
    Motion motion{wall, 0};
    for (int step = 0; step < 100; ++step)
      fall_between_walls(motion.x, motion.velocity, acceleration, 0.1, 1);
    EXPECT_EQ(motion.x, wall);
    EXPECT_EQ(motion.velocity, 0);
  }
}

/// From the middle of a box of height one with g = 1: at the ceiling after 0.5 = v t - t^2/2.
TEST(FallBetweenWalls, ReturnsFromTheCeiling) {
  Motion motion{0.5, 2};
  const double hit = 2 - std::sqrt(3.0);
  fall_between_walls(motion.x, motion.velocity, -1, hit + 0.1, 1);
  EXPECT_NEAR(motion.velocity, -std::sqrt(3.0) - 0.1, 1e-14);
  EXPECT_NEAR(motion.x, 1 - 0.1 * std::sqrt(3.0) - 0.005, 1e-14);
}

/// What is not a number must not become a cell: it shows in the velocity, and observers refuse that.
TEST(Flight, LeavesNoPositionThatIsNotANumber) {
  double x = NAN, velocity = NAN;
  EXPECT_EQ(wrap(NAN, 1, 1), 0);
  EXPECT_EQ(wrap(HUGE_VAL, 1, 1), 0);
  EXPECT_EQ(mirror(NAN, 1), 0);
  fly_between_walls(x, velocity, 1, 1);
  EXPECT_EQ(x, 0);
  fall_between_walls(x, velocity, -1, 1, 1);
  EXPECT_TRUE(x >= 0 && x <= 1);
  EXPECT_TRUE(std::isnan(velocity));
}

TEST(FallBetweenWalls, GrazesTheCeilingAndFallsBack) {
  Motion motion{0, std::sqrt(2.0)};  // the apex is the ceiling
  fall_between_walls(motion.x, motion.velocity, -1, 1.9 * std::sqrt(2.0), 1);
  EXPECT_NEAR(energy(motion, -1), 1, 1e-12);
  EXPECT_NEAR(motion.velocity, -0.9 * std::sqrt(2.0), 1e-7);
}

}  // namespace
}  // namespace sandglass::flight_test
