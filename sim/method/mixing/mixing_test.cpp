#include "sim/method/mixing/mixing.hpp"

#include "sim/base/error.hpp"
#include "sim/method/mixing/family.hpp"
#include "sim/method/mixing/stability.hpp"
#include "sim/method/mixing/test_listing.hpp"

#include <gtest/gtest.h>

namespace sandglass::mixing::mixing_test {
namespace {

/// Example 1 of the source but for the start.
Parameters sixteen() {
  Parameters parameters;
  parameters.repulsion = {1, 0, 2, 5, 20};
  parameters.walls = {{100, 100}, 1, 1e-3};
  parameters.gravity = -980;
  parameters.support = SupportParameters{{100, 100}, 4, 4, 20, 1e-3};
  parameters.species = {{20, 25, 0}, {20, 10, 0}};
  parameters.keep_ids = true;
  return parameters;
}

/// No gravity, mirrors, a softened core within a cutoff.
Parameters pair() {
  Parameters parameters;
  parameters.repulsion = {1, 0.1, 2, 2, 5, 10};
  parameters.walls = {{100, 100}, 1, 0};
  parameters.species = {{5, 1, 0}, {5, 3, 0}};
  parameters.keep_ids = true;
  return parameters;
}

Particles<2> two(const Phase<2>& light, const Phase<2>& heavy) {
  Particles<2> particles{{light, heavy}, {}};
  particles.columns.set(column::species, std::vector<std::uint8_t>{0, 1});
  return particles;
}

Particles<2> mixture(std::size_t count, std::uint64_t seed) {
  Particles<2> particles{random_particles({100, 100}, count, seed), {}};
  std::vector<std::uint8_t> species;
  for (std::size_t i = 0; i < count; ++i) species.push_back(i < count / 4 ? 0 : 1);
  particles.columns.set(column::species, species);
  return particles;
}

/// A step by hand from the twins of force and support.
std::vector<Phase<2>> listed_step(std::vector<Phase<2>> all, const Parameters& parameters, double kick,
                                  double dt) {
  std::vector<double> masses;
  for (std::size_t i = 0; i < all.size(); ++i) masses.push_back(i < all.size() / 4 ? 25 : 10);
  const auto push = listed_accelerations(all, masses, parameters.repulsion);
  const auto shares = listed_shares(all, *parameters.support);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vector<2> start = all[i].position;
    all[i].velocity += kick * (push[i] + Vector<2>(0, parameters.gravity * shares[i]));
    all[i].position += dt * all[i].velocity;
    parameters.walls.turn_back(start, all[i], 100);
  }
  return all;
}

TEST(Mixing, StepsAsTheListingDoes) {
  const Particles<2> start = mixture(16, 3);
  Mixing fluid(sixteen(), {});
  fluid.assign(start);
  std::vector<Phase<2>> expected = start.phases;
  constexpr double kDt = 1e-3;
  for (std::uint64_t step = 0; step < 20; ++step) {
    fluid.step(kDt, step);
    expected = listed_step(expected, sixteen(), step == 0 ? kDt / 2 : kDt, kDt);
  }
  const View<2> view = fluid.view();
  ASSERT_EQ(view.traits.size(), 2u);
  for (std::size_t i = 0; i < 16; ++i) {
    const Phase<2>& twin = expected[fluid.ids()[i]];
    EXPECT_LT((view.particles[i].position - twin.position).norm(), 1e-9) << i;
    EXPECT_LT((view.particles[i].velocity - twin.velocity).norm(), 1e-7) << i;
  }
}

TEST(Mixing, FirstKickLastsHalfAStep) {
  Parameters parameters = sixteen();
  parameters.support.reset();
  Mixing fluid(parameters, {});
  fluid.assign(two({{20, 90}, {0, 0}}, {{80, 90}, {0, 0}}));
  fluid.step(1e-3, 0);
  EXPECT_NEAR(fluid.view().particles[0].velocity[1], -0.49, 1e-12);
  fluid.step(1e-3, 1);
  EXPECT_NEAR(fluid.view().particles[0].velocity[1], -3 * 0.49, 1e-12);
}

/// Where the force jumps, by 0.4 at the cutoff and 0.03 at a diameter, a step may give a whole kick too much or too
/// little, twice on the way in and out: the relative speed of 8 is off by 4 dt 0.43 at most.
TEST(Mixing, EncountersConserveMomentumAndEnergy) {
  for (const double dt : {4e-3, 2e-3, 1e-3}) {
    Mixing fluid(pair(), {});
    fluid.assign(two({{30, 50}, {6, 0}}, {{70, 51}, {-2, 0}}));
    const auto steps = static_cast<std::uint64_t>(std::lround(10 / dt));
    double closest = HUGE_VAL;
    for (std::uint64_t step = 0; step < steps; ++step) {
      fluid.step(dt, step);
      const auto all = fluid.view().particles;
      closest = std::min(closest, (all[0].position - all[1].position).norm());
    }
    EXPECT_LT(closest, 5);  // into the core
    const auto all = fluid.view().particles;
    Vector<2> momentum = Vector<2>::Zero();
    double energy = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const double mass = fluid.ids()[i] == 0 ? 1 : 3;
      momentum += mass * all[i].velocity;
      energy += mass * all[i].velocity.squaredNorm() / 2;
    }
    EXPECT_LT(momentum.norm(), 1e-10);
    EXPECT_NEAR(energy, 24, 0.75 * 8 * 4 * dt * 0.43 + 1e-3);  // reduced mass 0.75; the rest is second order
  }
}

TEST(Mixing, GoesOnAfterARestart) {
  Mixing whole(sixteen(), {}), second(sixteen(), {});
  whole.assign(mixture(16, 5));
  for (std::uint64_t step = 0; step < 300; ++step) whole.step(1e-3, step);
  const View<2> view = whole.view();
  Particles<2> half{{view.particles.begin(), view.particles.end()}, {}};
  const auto ids = view.columns.get(column::id);
  const auto species = view.columns.get(column::species);
  half.columns.set(column::id, std::vector<std::uint64_t>(ids.begin(), ids.end()));
  half.columns.set(column::species, std::vector<std::uint8_t>(species.begin(), species.end()));
  second.restore(half, whole.save());
  for (std::uint64_t step = 300; step < 600; ++step) {
    whole.step(1e-3, step);
    second.step(1e-3, step);
  }
  EXPECT_EQ(whole.counters(), second.counters());
  EXPECT_GT(whole.counters().at("wall-reflections"), 0);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(whole.view().particles[i].position, second.view().particles[i].position);
    EXPECT_EQ(whole.view().particles[i].velocity, second.view().particles[i].velocity);
  }
}

/// A step beyond stability is refused by name, not left to infinities.
TEST(Mixing, RefusesAStepThatThrowsParticles) {
  Parameters parameters = sixteen();
  parameters.repulsion.core_exponent = 40;
  Mixing fluid(parameters, {});
  fluid.assign(two({{45, 50}, {1000, 0}}, {{55, 50}, {-1000, 0}}));
  try {
    for (std::uint64_t step = 0; step < 1000; ++step) fluid.step(1e-2, step);
    FAIL();
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("method.time-step"), std::string::npos) << error.what();
  }
}

TEST(Mixing, OneParticleFallsAndStaysInTheBox) {
  Mixing fluid(sixteen(), {});
  Particles<2> one{{{{50, 90}, {0, 0}}}, {}};
  fluid.assign(one);
  for (std::uint64_t step = 0; step < 5000; ++step) {
    fluid.step(1e-3, step);
    const Vector<2> place = fluid.view().particles[0].position;
    ASSERT_TRUE((place.array() >= 0).all() && (place.array() <= 100).all());
  }
}

TEST(CellsOf, AreAsWideAsTheCutoffOrOne) {
  EXPECT_EQ(cells_of(sixteen()).size(), 1u);
  EXPECT_EQ(cells_of(pair()).size(), 10u * 10);
  Parameters parameters = pair();
  parameters.repulsion.cutoff = 0.3 * 100;
  EXPECT_EQ(cells_of(parameters).size(), 9u);
  parameters.repulsion.cutoff = 2000;
  EXPECT_EQ(cells_of(parameters).size(), 1u);
}

/// Unsoftened: omega^2 = alpha M (q - 1) d^beta / r^q, q = p + beta, is (2/dt)^2 at r = (alpha M (q - 1) d^beta dt^2/4)^(1/q).
TEST(Stability, DistanceOfAnUnsoftenedCore) {
  const Repulsion law{1, 0, 2, 5, 20};
  const double expected = std::pow(50 * 6 * std::pow(20, 5) * 1e-6 / 4, 1.0 / 7);
  EXPECT_NEAR(unstable_distance(law, 50, 1e-3), expected, 0.006 * expected);  // a rung of the ladder
  EXPECT_EQ(unstable_distance({1, 0.1, 2, 2, 5, 10}, 2, 1e-3),
            0);  // alpha M d^beta / xi^(p + beta) < (2/dt)^2
}

/// Half the speed squared is alpha M d^beta r^(2 - q)/(q - 2) with a cutoff far out and p = 3, beta = 0.
TEST(Stability, SpeedThatReachesADistance) {
  const Repulsion law{2, 0, 3, 0, 1, 1e3};
  EXPECT_NEAR(speed_to_reach(law, 5, 0.5), std::sqrt(2 * 10 * (1 / 0.5 - 1 / 1e2)), 1e-3);
}

TEST(Family, ListsItsFaults) {
  EXPECT_EQ(family().name, "mixing");
  EXPECT_EQ(family().faults.size(), 8u);
}

}  // namespace
}  // namespace sandglass::mixing::mixing_test
