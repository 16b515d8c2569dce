#include "validation/law/channel.hpp"

#include "validation/law/enskog.hpp"
#include "validation/law/sedimentation.hpp"
#include "validation/law/transport.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace sandglass::law::channel_test {
namespace {

/// (5.2) to (5.7) against the viscosity of Chapman and Enskog, for any units.
TEST(Channel, NumbersFollowFromTheGas) {
  const Gas gas{3, 0.03, 2.5, 1.7, 0.0001};
  const double density = gas.mass * number_density(gas);
  const double path = 1 / (std::numbers::sqrt2 * std::numbers::pi * number_density(gas) * 0.03 * 0.03);
  const double speed = most_probable_speed(gas.temperature, gas.mass);
  const double viscosity = mean_path_viscosity(density, mean_speed_of_spheres(speed), path);
  EXPECT_NEAR(mean_speed_of_spheres(speed) / mean_speed(gas), 1, 1e-14);
  EXPECT_NEAR(viscosity / boltzmann_shear_viscosity(gas, SonineOrder::first), 1, 1e-13);
  const double stream = 2.2567 * speed, height = 8 * path;
  EXPECT_NEAR(channel_reynolds_number(2.2567, 8) / (density * stream * height / viscosity), 1, 1e-13);
  const double sound = std::sqrt((1 + 2.0 / 6) * gas.temperature / gas.mass);
  EXPECT_NEAR(mach_number(2.2567, heat_capacity_ratio(6)) / (stream / sound), 1, 1e-13);
}

/// What the source gives for its channels: Re 32.6 and 16.3, M 2.76, and n_enter = 10 (5.1).
TEST(Channel, NumbersOfTheSource) {
  EXPECT_NEAR(channel_reynolds_number(2.2567, 8), 32.6, 0.05);
  EXPECT_NEAR(channel_reynolds_number(2.2567, 4), 16.3, 0.05);
  EXPECT_NEAR(mach_number(2.2567, heat_capacity_ratio(6)), 2.76, 0.005);
  EXPECT_NEAR(2.2567 * 0.17725 * 10 / 0.4, 10, 1e-4);
}

constexpr CoolingStream kGranular{{3, 0.6, 0, 0.4}, 1, 2.2567, {0.5, 0.5}, 1};

TEST(CoolingStream, OfElasticParticlesStaysAsItIs) {
  for (const double tangential : {-1.0, 1.0}) {
    CoolingStream stream = kGranular;
    stream.gas = {3, 1, tangential, 0.4};
    const StreamState end = cooling_stream(stream, 20);
    EXPECT_NEAR(end.velocity, 2.2567, 1e-9);
    EXPECT_NEAR(end.temperature.translation, 0.5, 1e-9);
    EXPECT_NEAR(end.temperature.rotation, 0.5, 1e-9);
  }
}

/// Mass and momentum pass everywhere alike; energy falls by what collisions have taken, integrated by the trapezoidal rule.
TEST(CoolingStream, KeepsItsBalances) {
  for (const int dimension : {2, 3}) {
    CoolingStream stream = kGranular;
    stream.gas.dimension = dimension;
    stream.mass = 1.7;
    const auto energy = [&](const StreamState& s) {
      return stream.mass * s.velocity * s.velocity / 2 + (dimension + 2) / 2.0 * s.temperature.translation +
             (dimension == 2 ? 0.5 : 1.5) * s.temperature.rotation;
    };
    const auto loss = [&](const StreamState& s) {  // per length and particle
      const Temperatures change = rough_energy_change(stream.gas, s.temperature);
      const Gas start{dimension, 1, stream.mass, stream.temperature.translation, 1e-9};
      const double rate = mean_speed(start) / stream.mean_free_path * stream.velocity / s.velocity *
                          std::sqrt(s.temperature.translation / stream.temperature.translation);
      return rate * (change.translation + change.rotation) / (2 * s.velocity);
    };
    const double thrust = stream.mass * stream.velocity + stream.temperature.translation / stream.velocity;
    double lost = 0;
    StreamState before = cooling_stream(stream, 0);
    const double first = energy(before);
    constexpr int kSteps = 400;
    for (int i = 1; i <= kSteps; ++i) {
      const StreamState now = cooling_stream(stream, 16.0 * i / kSteps);
      lost += (loss(before) + loss(now)) / 2 * 16 / kSteps;
      before = now;
    }
    EXPECT_NEAR(stream.mass * before.velocity + before.temperature.translation / before.velocity, thrust,
                1e-9);
    EXPECT_NEAR(energy(before) - first, lost, 1e-4 * std::abs(lost));
    EXPECT_GT(before.velocity, 1.03 * stream.velocity) << "pressure pushes a stream that cools";
  }
}

/// Very fast, it cools as a gas at rest does in the time of flight.
TEST(CoolingStream, VeryFastIsAHomogeneousGas) {
  CoolingStream stream = kGranular;
  stream.velocity = 300;
  const double mean_free_times = 6, time = mean_free_times / std::sqrt(8 * 0.5 / std::numbers::pi);
  const StreamState end = cooling_stream(stream, time * stream.velocity);
  const Temperatures rest = rough_cooling_in_time(stream.gas, {1, 1}, mean_free_times);
  EXPECT_NEAR(end.temperature.translation / 0.5, rest.translation, 1e-4);
  EXPECT_NEAR(end.temperature.rotation / 0.5, rest.rotation, 1e-4);
}

constexpr FallingStream kFalling{1, 0.5, 2.2567, 0.5, 4, 6};

TEST(FallingStream, PassesWhatEntered) {
  const StreamState end = falling_stream_end(kFalling);
  const double t = end.temperature.translation, u = end.velocity;
  EXPECT_NEAR(u + t / u, 2.2567 + 0.5 / 2.2567, 1e-12);
  const double height = t / 0.5 - 4 / (std::exp(0.5 * 4 / t) - 1);
  EXPECT_NEAR(u * u / 2 + 4 * t + 0.5 * height, 2.2567 * 2.2567 / 2 + 4 * 0.5 + 0.5 * 4 / 2, 1e-12);
  EXPECT_GT(t, 0.5);
  EXPECT_LT(u, 2.2567);
  EXPECT_GT(u * u, 4.0 / 3 * t) << "still faster than sound";
}

/// Very fast, it is the column of gas at rest that the source solves in Appendix B: what the stream loses of its own motion
/// is the work that its pressure does.
TEST(FallingStream, VeryFastIsAColumnAtRest) {
  FallingStream stream = kFalling;
  stream.velocity = 1e3;
  const MixedColumn column{{{1, 1, 4}}, 0.5, 6};
  const double rest = sedimentation_temperature(column, even_column_energy(column, 0.5));
  EXPECT_NEAR(falling_stream_end(stream).temperature.translation, rest, 1e-5);
}

TEST(FallingStream, WithoutWeightStaysAsItIs) {
  FallingStream stream = kFalling;
  stream.gravity = 1e-9;
  EXPECT_NEAR(falling_stream_end(stream).velocity, 2.2567, 1e-8);
  stream.gravity = 50;
  EXPECT_TRUE(std::isnan(falling_stream_end(stream).velocity)) << "a shock must stand in it";
}

}  // namespace
}  // namespace sandglass::law::channel_test
