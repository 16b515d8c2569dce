#include "validation/law/guarded.hpp"

#include "validation/law/contact_average.hpp"
#include "validation/law/haff.hpp"
#include "validation/law/quadrature.hpp"

#include <array>
#include <random>

#include <gtest/gtest.h>

namespace sandglass::law::guarded_test {
namespace {

double maxwell_speed_density(int dimension, double s) {
  const double shell = dimension == 2 ? 2 * s : 4 / std::sqrt(std::numbers::pi) * s * s;
  return shell * std::exp(-s * s);
}

TEST(SpeedResolvedRate, AveragesToTheMeanRate) {
  for (int dimension : {2, 3}) {
    const auto weighted = [=](double s) {
      return maxwell_speed_density(dimension, s) * speed_resolved_rate(dimension, s);
    };
    EXPECT_NEAR(quadrature::integral(weighted, 0, 8), 1, 1e-9);
  }
}

// A particle at rest collides with others at their mean speed, one far above at its own: over sqrt(2) mean speeds.
TEST(SpeedResolvedRate, AtRestAndFarAbove) {
  for (int dimension : {2, 3}) {
    const double mean_speed =
        dimension == 2 ? std::sqrt(std::numbers::pi) / 2 : 2 / std::sqrt(std::numbers::pi);
    EXPECT_NEAR(speed_resolved_rate(dimension, 0), 1 / std::numbers::sqrt2, 1e-12);
    EXPECT_NEAR(speed_resolved_rate(dimension, 1e-5), speed_resolved_rate(dimension, 0), 1e-8);
    EXPECT_NEAR(speed_resolved_rate(dimension, 50) / (50 / (std::numbers::sqrt2 * mean_speed)), 1, 2e-4);
  }
}

// The same average by Gauss nodes over all velocities instead of a grid along the normal.
TEST(GuardedShare, IsTheAverageOverContacts) {
  for (int dimension : {2, 3})
    for (double x : {0.02, 0.2}) {
      const auto kept = [=](const Contact& contact) {
        return std::exp(-x * (speed_resolved_rate(dimension, contact.first.norm()) +
                              speed_resolved_rate(dimension, contact.second.norm())));
      };
      const double all = contact_average(
          dimension, 1, [](const Contact&) { return 1.0; }, 3);
      EXPECT_NEAR(guarded_share(dimension, x), contact_average(dimension, 1, kept, 3) / all, 1e-4 * (1 + x));
    }
}

TEST(GuardedShare, StartsAtOneAndFallsFasterThanAtTheMeanRate) {
  for (int dimension : {2, 3}) {
    EXPECT_DOUBLE_EQ(guarded_share(dimension, 0), 1);
    const double slope = (1 - guarded_share(dimension, 1e-6)) / 1e-6;
    EXPECT_GT(slope, 2);  // contacts that lose much are made by fast particles, which collide more often
    EXPECT_LT(slope, 2.6);
    EXPECT_LT(guarded_share(dimension, 20), 1e-9);
  }
}

// The theory of the source and ours, which it does not know of, agree; one rate for all speeds would give exp(-2x).
TEST(GuardedShare, OfSpheresIsThatOfLudingAndGoldshtein) {
  for (double x : {0.05, 0.1, 0.25, 0.5, 1.0, 1.5})
    EXPECT_NEAR(guarded_share(3, x) / guarded_share_polynomial(x), 1, 0.002) << x;
  EXPECT_LT(guarded_share_polynomial(0.5), 0.9 * std::exp(-1.0));
}

// The plainest event-driven loop, over all pairs of 256 elastic disks at 0.65, 1.5 million collisions.
TEST(GuardedShare, OfContactsIsThatOfDenseDisks) {
  const Gas disks{.dimension = 2, .fraction = 0.65};
  const double seen[][3] = {{0.025, 0.9453, 0.0003}, {0.1, 0.7999, 0.0008},   {0.249, 0.5730, 0.0014},
                            {0.5, 0.3303, 0.0005},   {0.799, 0.1722, 0.0002}, {1.0, 0.1120, 0.0003}};
  for (const auto& [x, share, error] : seen) {
    const Bounded law = guarded_share_of_contacts(disks, x);
    EXPECT_NEAR(law.value, share, law.bound + 3 * error) << x;
    EXPECT_GT(share - guarded_share(2, x), 5 * error) << x;
  }
  const Bounded dilute = guarded_share_of_contacts({.dimension = 2, .fraction = 0.01}, 0.5);
  EXPECT_NEAR(dilute.value - dilute.bound, guarded_share(2, 0.5), 1e-3);
}

/// Energy lost per collision in a gas without positions: pairs drawn at random, accepted by their approach speed, each
/// collision elastic (a stationary gas) and counted as dissipative by the rule of the guard itself.
double simulated_share(double x) {
  constexpr std::size_t particles = 4000;
  std::mt19937_64 generator(11);
  std::normal_distribution<double> normal(0, std::sqrt(0.5));
  std::uniform_real_distribution<double> uniform;
  std::vector<std::array<double, 2>> velocity(particles);
  for (auto& v : velocity) v = {normal(generator), normal(generator)};
  std::vector<double> last(particles, -10);
  const double highest = 8;
  double time = 0, all = 0, dissipative = 0;
  const double mean_approach = 1 / std::sqrt(2 * std::numbers::pi);  // <Theta(g) g>, g of unit variance
  // Each of N/2 pairs' worth of collisions per time: the mean rate is one.
  const double tries_per_time = particles / 2.0 * highest / mean_approach;
  for (int i = 0; i < 30000000; ++i) {
    time += 1 / tries_per_time;
    const auto a = static_cast<std::size_t>(uniform(generator) * particles);
    const auto b = static_cast<std::size_t>(uniform(generator) * particles);
    const double angle = 2 * std::numbers::pi * uniform(generator);
    const double nx = std::cos(angle), ny = std::sin(angle);
    const double approach = (velocity[a][0] - velocity[b][0]) * nx + (velocity[a][1] - velocity[b][1]) * ny;
    if (a == b || uniform(generator) * highest >= approach) continue;
    const double loss = approach * approach;
    all += loss;
    if (time - std::max(last[a], last[b]) >= x) dissipative += loss;
    last[a] = last[b] = time;
    velocity[a] = {velocity[a][0] - approach * nx, velocity[a][1] - approach * ny};
    velocity[b] = {velocity[b][0] + approach * nx, velocity[b][1] + approach * ny};
  }
  return dissipative / all;
}

TEST(GuardedShare, IsWhatAGasWithoutPositionsShows) {
  EXPECT_NEAR(simulated_share(0.2), guarded_share(2, 0.2), 0.004);
  EXPECT_GT(std::abs(std::exp(-0.4) - guarded_share(2, 0.2)), 0.02);
}

TEST(GuardedCoolingRate, WithoutAGuardIsHaffs) {
  const Gas gas{
      .dimension = 2, .diameter = 0.7, .mass = 1.3, .temperature = 2.1, .fraction = 0.2, .restitution = 0.6};
  EXPECT_DOUBLE_EQ(guarded_cooling_rate(gas, 0), cooling_rate(gas));
  EXPECT_LT(guarded_cooling_rate(gas, 0.1), cooling_rate(gas));
}

}  // namespace
}  // namespace sandglass::law::guarded_test
