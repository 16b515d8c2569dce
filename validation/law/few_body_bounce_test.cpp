#include "validation/law/few_body_bounce.hpp"

#include "sim/base/error.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace sandglass::law::few_body_bounce_test {
namespace {

constexpr BouncingBall kBall{.gravity = 2, .height = 0.7, .velocity = 0.5, .restitution = 0.6};

TEST(BouncingBall, FlightsAddUpToTheSum) {
  for (int n = 1; n < 12; ++n) {
    const BounceState after = bouncing_ball(kBall, bounce_time(kBall, n) + 1e-9);
    EXPECT_EQ(after.bounces, n);
    EXPECT_NEAR(after.velocity, 0.6 * bounce_speed(kBall, n), 1e-8);
    EXPECT_NEAR(after.left + after.since, bounce_time(kBall, n + 1) - bounce_time(kBall, n), 1e-14);
  }
}

TEST(BouncingBall, EachFlightKeepsItsEnergyAndEachBounceTakesItsShare) {
  const double first = bounce_speed(kBall, 1);
  EXPECT_NEAR(first * first / 2, 0.125 + 2 * 0.7, 1e-15);
  for (double time : {0.1, 1.3, 2.1, 3.0}) {
    const BounceState state = bouncing_ball(kBall, time);
    const double energy = state.velocity * state.velocity / 2 + 2 * state.height;
    EXPECT_NEAR(energy, first * first / 2 * std::pow(0.36, state.bounces), 1e-14);
  }
}

TEST(BouncingBall, ComesToRestAtTheAccumulationTime) {
  EXPECT_NEAR(bounce_time(kBall, 200), accumulation_time(kBall), 1e-14);
  EXPECT_GT(bouncing_ball(kBall, accumulation_time(kBall) - 1e-9).bounces, 40);
  EXPECT_THROW(bouncing_ball(kBall, accumulation_time(kBall) + 1e-9), InputError);
  BouncingBall elastic = kBall;
  elastic.restitution = 1;
  EXPECT_TRUE(std::isinf(accumulation_time(elastic)));
  EXPECT_NEAR(bouncing_ball(elastic, bounce_time(elastic, 9) + 0.01).height,
              0.01 * bounce_speed(elastic, 1) - 1e-4, 1e-14);
}

TEST(BouncingBall, VelocityDependentRestitutionGoesOn) {
  BouncingBall guarded = kBall;
  guarded.reference_speed = 1;
  EXPECT_GT(bouncing_ball(guarded, 2 * accumulation_time(kBall)).bounces, 10);
  guarded.reference_speed = 1e-3;  // above it nothing changes
  EXPECT_DOUBLE_EQ(bouncing_ball(guarded, 3).height, bouncing_ball(kBall, 3).height);
}

// dv/dn = -(1-r) v (v/v0)^(3/4): flights add up to a finite time here too, but as n^(-1/3).
TEST(BouncingBall, VelocityDependentRestitutionPilesUpSlowly) {
  const BouncingBall guarded{.gravity = 1, .height = 0.5, .restitution = 0.6, .reference_speed = 1};
  const auto late = [&](double time) {
    const BounceState state = bouncing_ball(guarded, time);
    return (state.velocity + state.since) * std::pow(0.75 * 0.4 * state.bounces, 4.0 / 3);
  };
  EXPECT_GT(bouncing_ball(guarded, 16.5).bounces, 1000);
  EXPECT_NEAR(late(16.5), 1, 0.01);
}

double floor_height(const VibratedBall& ball, double time) {
  return ball.amplitude * std::sin(2 * std::numbers::pi * ball.frequency * time);
}

/// Next bounce by steps and bisection, with no formula of the orbit: {time, speed after it}.
std::pair<double, double> next_bounce(const VibratedBall& ball, double time, double speed) {
  const double start = floor_height(ball, time);
  const auto above = [&](double s) {
    return start + speed * s - ball.gravity * s * s / 2 - floor_height(ball, time + s);
  };
  double s = 1e-3;
  while (above(s) > 0) s += 1e-4;
  double low = s - 1e-4, high = s;
  for (int i = 0; i < 60; ++i) (above((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  const double rate = 2 * std::numbers::pi * ball.frequency, end = time + high;
  const double floor_speed = ball.amplitude * rate * std::cos(rate * end);
  return {end, (1 + ball.restitution) * floor_speed - ball.restitution * (speed - ball.gravity * high)};
}

/// Distance of the speed from that of the orbit after some bounces from near it.
double distance_after(const VibratedBall& ball, int bounces, double start = 1e-3) {
  double time = *bounce_phase(ball) / (2 * std::numbers::pi * ball.frequency);
  const double orbit = ball.gravity / ball.frequency / 2;
  double speed = orbit * (1 + start);
  for (int i = 0; i < bounces; ++i) std::tie(time, speed) = next_bounce(ball, time, speed);
  return std::abs(speed / orbit - 1);
}

TEST(VibratedBall, OrbitAttractsWhereItIsStableAndOnlyThere) {
  VibratedBall ball{.gravity = 1.3, .amplitude = 0.03, .frequency = 1.1, .restitution = 0.5};
  EXPECT_GT(orbit_acceleration_ratio(ball), 0);
  EXPECT_LT(orbit_acceleration_ratio(ball), 0.95);
  EXPECT_LT(distance_after(ball, 40), 1e-10);
  ball.amplitude = 0.045;
  EXPECT_GT(orbit_acceleration_ratio(ball), 1.05);
  EXPECT_GT(distance_after(ball, 40), 1e-2);
}

TEST(VibratedBall, DeviationsShrinkAsTheEigenvaluesSay) {
  const VibratedBall slowly{.gravity = 1, .amplitude = 0.026563, .frequency = 1, .restitution = 0.5};
  EXPECT_GT(orbit_contraction(slowly), 0.6);  // two real ones
  EXPECT_NEAR(distance_after(slowly, 16) / distance_after(slowly, 12), std::pow(orbit_contraction(slowly), 4),
              0.01);
  const VibratedBall spiral{.gravity = 1, .amplitude = 0.0334, .frequency = 1, .restitution = 0.5};
  EXPECT_DOUBLE_EQ(orbit_contraction(spiral), 0.5);
}

TEST(VibratedBall, OrbitMeetsTheFloorWithItsRule) {
  const VibratedBall ball{.gravity = 1.3, .amplitude = 0.03, .frequency = 1.1, .restitution = 0.5};
  const double rate = 2 * std::numbers::pi * 1.1, bounce = 3 / 1.1 + *bounce_phase(ball) / rate;
  const BounceState before = period_one_orbit(ball, bounce - 1e-10),
                    after = period_one_orbit(ball, bounce + 1e-10);
  const double floor = 0.03 * rate * std::cos(rate * bounce);
  EXPECT_NEAR(after.height, floor_height(ball, bounce), 1e-9);
  EXPECT_NEAR(before.height, floor_height(ball, bounce), 1e-9);
  EXPECT_NEAR(after.velocity - floor, -0.5 * (before.velocity - floor), 1e-9);
}

TEST(VibratedBall, SlowFloorHasNoOrbit) {
  const VibratedBall slow{.gravity = 1, .amplitude = 0.01, .frequency = 1, .restitution = 0.5};
  EXPECT_FALSE(bounce_phase(slow));
  EXPECT_TRUE(std::isnan(orbit_acceleration_ratio(slow)));
  EXPECT_THROW(period_one_orbit(slow, 1), InputError);
  const VibratedBall elastic{.gravity = 1, .amplitude = 0.01, .frequency = 1, .restitution = 1};
  EXPECT_NEAR(*bounce_phase(elastic), std::numbers::pi / 2, 1e-15);
}

}  // namespace
}  // namespace sandglass::law::few_body_bounce_test
