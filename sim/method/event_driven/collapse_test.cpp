#include "sim/method/event_driven/test_gas.hpp"

#include <gmock/gmock.h>

namespace sandglass::event_driven::collapse_test {
namespace {

/// Below this three particles on a line collapse (Bernu & Mazighi 1990; McNamara & Young 1992).
const double kCritical = 7 - 4 * std::sqrt(3.0);

/// The middle one bounces between its neighbours. With unit masses the pair of closing speeds (a, b) left and right becomes
/// (-r a, b + (1 + r) a / 2) in a collision on the left: the ratio of the two that is the same one cycle later is the
/// slower eigenvalue's, and gaps close in proportion.
TestGas<2> three_on_a_line(double r) {
  TestGas<2> gas({400, 10});
  gas.set_restitution(r);
  gas.add({10, 5}, {1, 0});
  gas.add({12, 5}, {0, 0});
  gas.add({13.2, 5}, {-1, 0});
  return gas;
}

/// Collisions in a gas of three rods by exact arithmetic in long numbers, at most `most`. Collapse: no end of them.
int collisions_on_a_line(long double r, int most) {
  long double left = 1, right = 0.2L, a = 1, b = 1;  // gaps and closing speeds
  int count = 0;
  while (count < most) {
    const long double t = a > 0 ? left / a : HUGE_VALL, u = b > 0 ? right / b : HUGE_VALL;
    if (std::isinf(t) && std::isinf(u)) break;
    const long double dt = std::min(t, u);
    left -= a * dt, right -= b * dt;
    const bool first = t <= u;
    (first ? left : right) = 0;
    (first ? b : a) += (1 + r) / 2 * (first ? a : b);
    (first ? a : b) *= -r;
    ++count;
  }
  return count;
}

TEST(Collapse, ThreeOnALineIfAndOnlyIfTheRestitutionIsBelowTheCriticalOne) {
  for (const double r : {0.0072, 0.03, 0.06, 0.0715}) {
    SCOPED_TRACE(r);
    ASSERT_EQ(collisions_on_a_line(r, 200), 200);
    const auto gas = three_on_a_line(r).make();
    EXPECT_THROW(gas->step(10, 0), RunError);
  }
  for (const double r : {0.0721, 0.08, 0.1, 0.3, 0.9}) {
    SCOPED_TRACE(r);
    const int expected = collisions_on_a_line(r, 200);
    ASSERT_LT(expected, 200);
    const auto gas = three_on_a_line(r).make();
    EXPECT_NO_THROW(gas->step(150, 0));
    EXPECT_EQ(gas->tally().collisions, static_cast<std::uint64_t>(expected));
  }
  EXPECT_NEAR(kCritical, 0.0718, 1e-4);
}

/// A row of touching disks all around the box: the momentum goes round and round at one instant.
TEST(Collapse, ARingOfTouchingDisksIsRefusedAndNotFollowedForEver) {
  Parameters<2> parameters;
  parameters.geometry = {Vector<2>(6, 6), {true, true}};
  parameters.particles = 6;
  const auto gas = make_event_driven<2>(parameters, {}, {1, 0});
  Particles<2> ring;
  for (int i = 0; i < 6; ++i) ring.phases.push_back({{i + 0.5, 3}, {i == 0 ? 5.0 : -1.0, 0}});
  gas->assign(ring);
  EXPECT_THROW(gas->step(1, 0), RunError);
}

TEST(Collapse, TheMessageNamesTimePlaceAndPair) {
  const auto gas = three_on_a_line(0.05).make();
  try {
    gas->step(10, 0);
    FAIL() << "it did not collapse";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("inelastic collapse at time "));
    EXPECT_THAT(error.what(), testing::HasSubstr(" at (1"));
    EXPECT_THAT(error.what(), testing::HasSubstr("particle"));
    EXPECT_THAT(error.what(), testing::HasSubstr("collapse-guard"));
  }
}

TEST(Collapse, TheContactTimeModelGoesThrough) {
  auto guarded = three_on_a_line(0.05);
  guarded.parameters.contact_time = 1e-3;
  const auto gas = guarded.make();
  EXPECT_NO_THROW(gas->step(10, 0));
  EXPECT_GT(gas->counters().at("guarded-collisions"), 0);
  EXPECT_LT(gas->tally().collisions, 100u);
  EXPECT_NEAR(momentum(*gas).norm(), 0, 1e-15);

  auto dropped = guarded;
  dropped.parameters.contact_time = 0;
  EXPECT_THROW(dropped.make()->step(10, 0), RunError);
}

TEST(Collapse, RestitutionThatDependsOnTheVelocityGoesThrough) {
  auto soft = three_on_a_line(0.05);
  soft.parameters.surfaces.front().normal.reference_speed = 0.5;
  const auto gas = soft.make();
  EXPECT_NO_THROW(gas->step(10, 0));
  EXPECT_LT(gas->tally().collisions, 100u);
}

/// Two that stick make no chain of collisions.
TEST(Collapse, APairThatSticksDoesNotCollapse) {
  for (const double angle : {0.0, 0.3, 1.1}) {
    TestGas<2> gas({20, 20});
    gas.set_restitution(0);
    gas.add({5, 5}, {std::cos(angle), std::sin(angle)});
    gas.add({5 + 3 * std::cos(angle), 5 + 3 * std::sin(angle)}, {-0.3, 0.1});
    const auto engine = gas.make();
    EXPECT_NO_THROW(engine->step(100, 0));
    EXPECT_LT(engine->tally().collisions, 60u);
  }
}

/// A ball dropped from rest at height h: it lands at t0 = sqrt(2 h / g) and bounces for the n-th time at
/// t0 (1 + 2 (r + ... + r^(n-1))), which ends at t0 (1 + r) / (1 - r).
struct Drop {
  double g = 2, height = 3, r;
  double landing() const { return std::sqrt(2 * height / g); }
  double end() const { return landing() * (1 + r) / (1 - r); }
  TestGas<2> gas(double velocity = 0) const {
    TestGas<2> gas({8, 10});
    gas.parameters.gravity = {0, -g};
    gas.add_walls(1, {WallKind::specular, {{r}}});
    gas.add({4, height + 0.5}, {velocity, 0});
    return gas;
  }
};

TEST(Collapse, ABallBouncesAtTheTimesOfTheSeries) {
  for (const double r : {0.3, 0.5, 0.9}) {
    const Drop drop{.r = r};
    Recorder<2> trace;
    const auto engine = drop.gas().make(&trace);
    engine->step(drop.end() * (1 - 1e-6), 0);
    ASSERT_GT(trace.events.size(), 8u);
    double expected = drop.landing(), power = 1;
    for (const auto& event : trace.events) {
      EXPECT_NEAR(event.time, expected, 1e-12 * drop.end());
      EXPECT_NEAR(event.velocity_1[1], power * r * drop.g * drop.landing(), 1e-9 * drop.landing());
      power *= r;
      expected += 2 * power * drop.landing();
    }
    EXPECT_GT(expected, drop.end() * (1 - 1e-6));  // none is missing
  }
}

/// With and without a motion along the floor that goes on.
TEST(Collapse, ABallThatComesToRestEndsTheRun) {
  for (const double along : {0.0, 0.7})
    for (const double r : {0.3, 0.5, 0.9, 0.97}) {
      SCOPED_TRACE(r);
      const Drop drop{.r = r};
      const auto engine = drop.gas(along).make();
      EXPECT_NO_THROW(engine->step(drop.end() * (1 - 1e-6), 0));
      EXPECT_THROW(engine->step(1, 0), RunError);
    }
}

/// With the TC model the ball goes on at the pace of the contact time, for ever and elastically. Without it, neither does
/// restitution that goes to 1 at rest help: bounces then die as n^(-4/3), and their times still have a finite sum.
TEST(Collapse, ABallOnAGuardedFloorGoesOn) {
  const Drop drop{.r = 0.5};
  auto gas = drop.gas();
  gas.parameters.contact_time = 0.01;
  const auto engine = gas.make();
  EXPECT_NO_THROW(engine->step(drop.end() + 1, 0));
  const double guarded = engine->counters().at("guarded-collisions");
  EXPECT_GT(guarded, 0);
  EXPECT_NO_THROW(engine->step(10, 0));
  const auto phase = engine->view().particles[0];
  const double speed =
      std::sqrt(phase.velocity[1] * phase.velocity[1] + 2 * drop.g * (phase.position[1] - 0.5));
  EXPECT_LT(2 * speed / drop.g,
            0.01);  // the interval of the bounces, less than the contact time but more than its half
  EXPECT_GT(2 * speed / drop.g, 0.005 * drop.r);
  EXPECT_NEAR(engine->counters().at("guarded-collisions") - guarded, 10 / (2 * speed / drop.g), 2);
}

}  // namespace
}  // namespace sandglass::event_driven::collapse_test
