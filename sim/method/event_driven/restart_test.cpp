#include "sim/method/event_driven/test_gas.hpp"

namespace sandglass::event_driven::restart_test {
namespace {

/// Everything that the two show is the same to the last bit.
template <int D>
void expect_identical(Simulator<D>& a, Simulator<D>& b) {
  const View<D> left = a.view(), right = b.view();
  ASSERT_EQ(left.particles.size(), right.particles.size());
  for (std::size_t i = 0; i < left.particles.size(); ++i) {
    ASSERT_EQ(left.particles[i].position, right.particles[i].position) << i;
    ASSERT_EQ(left.particles[i].velocity, right.particles[i].velocity) << i;
  }
  ASSERT_TRUE(std::ranges::equal(left.columns.get(column::spin<D>), right.columns.get(column::spin<D>)));
  ASSERT_TRUE(std::ranges::equal(left.columns.get(column::species), right.columns.get(column::species)));
  ASSERT_TRUE(std::ranges::equal(a.ids(), b.ids()));
}

/// Every option at once: agents that draw, spins, kinds, ids, TC model, gravity.
TestGas<2> everything() {
  auto gas = lattice_gas<2>(12, 1.6);
  gas.make_mixture(0.6, 0.3);
  gas.set_restitution(0.9);
  gas.make_rough(0.3, 0.2);
  gas.parameters.gravity = {0.02, -0.1};
  gas.parameters.contact_time = 0.02;
  gas.add_walls(1, {WallKind::thermal, {}, 1, 1.5});
  return gas;
}

template <int D>
void expect_repeatable(const TestGas<D>& gas) {
  const auto a = gas.make(), b = gas.make();
  for (int i = 0; i < 20; ++i) {
    a->step(0.5, static_cast<std::uint64_t>(i));
    b->step(0.5, static_cast<std::uint64_t>(i));
  }
  EXPECT_GT(a->tally().collisions, 100u);
  expect_identical(*a, *b);
}

TEST(Repeat, TwoRunsAreTheSameToTheLastBit) {
  expect_repeatable(everything());
  expect_repeatable(triangular_gas(20, 20, 0.6));
  expect_repeatable(cubic_gas(4, 0.3));
}

/// Steps only end the loop: the events of a run do not know how it is cut into steps. Bitwise so in velocities, partners and
/// the virial; the times at which positions are shown differ by rounding.
template <int D>
void expect_split_as_one(TestGas<D> gas) {
  gas.parameters.measure_transfer = true;
  Recorder<D> one, many;
  const auto a = gas.make(&one), b = gas.make(&many);
  a->step(6, 0);
  for (int i = 0; i < 300; ++i) b->step(0.02, static_cast<std::uint64_t>(i));
  ASSERT_EQ(one.events.size(), many.events.size());
  for (std::size_t k = 0; k < one.events.size(); ++k) {
    ASSERT_EQ(one.events[k].first, many.events[k].first);
    ASSERT_EQ(one.events[k].second, many.events[k].second);
    ASSERT_EQ(one.events[k].time, many.events[k].time);
    ASSERT_EQ(one.events[k].velocity_1, many.events[k].velocity_1);
  }
  EXPECT_EQ(a->tally().transfer.value(), b->tally().transfer.value());
  const auto left = by_id(*a), right = by_id(*b);
  for (std::size_t i = 0; i < left.size(); ++i)
    EXPECT_LT((left[i].position - right[i].position).norm(), 1e-12);
}

TEST(Repeat, TheCutIntoStepsDoesNotShow) {
  expect_split_as_one(everything());
  expect_split_as_one(triangular_gas(20, 20, 0.6));
  expect_split_as_one(lattice_gas<3>(4, 3));
}

template <int D>
void expect_restart(const TestGas<D>& gas, double moment) {
  const auto straight = gas.make();
  straight->step(moment, 0);
  const auto memory = straight->save();
  const auto resumed = gas.make_bare();
  resumed->assign(particles_of(*straight));
  resumed->load(memory);
  expect_identical(*straight, *resumed);
  const std::uint64_t before = straight->tally().collisions;
  for (int i = 0; i < 30; ++i) {
    straight->step(0.3, 0);
    resumed->step(0.3, 0);
  }
  EXPECT_GT(straight->tally().collisions, before + 100);
  EXPECT_EQ(straight->tally().collisions - before, resumed->tally().collisions);
  expect_identical(*straight, *resumed);
}

TEST(Restart, GoesOnToTheLastBit) {
  for (const double moment : {0.0, 1e-3, 0.77, 5.0, 23.0}) {
    expect_restart(everything(), moment);
    expect_restart(triangular_gas(20, 20, 0.6), moment);
    expect_restart(cubic_gas(3, 0.3), moment);
  }
}

/// Particles keep identities of their own where walls draw.
TEST(Restart, RandomWallsWithoutIds) {
  auto gas = everything();
  gas.parameters.keep_ids = false;
  EXPECT_TRUE(gas.make()->ids().empty());
  expect_restart(gas, 1.7);
}

TEST(Restart, SpinsOfSpheres) {
  auto gas = cubic_gas(3, 0.3);
  gas.make_rough(0.5, 0.3);
  expect_restart(gas, 1.7);
}

TEST(Restart, WithoutIds) {
  auto gas = triangular_gas(10, 10, 0.6);
  gas.parameters.keep_ids = false;
  expect_restart(gas, 1.7);
}

/// The coming run does not depend on what the simulator did before.
TEST(Restart, AssignBeginsAnew) {
  const auto gas = everything();
  const auto fresh = gas.make(), used = gas.make();
  used->step(3, 0);
  used->assign(gas.particles);
  fresh->step(5, 0);
  used->step(5, 0);
  expect_identical(*fresh, *used);
}

TEST(Restart, ADamagedCheckpointIsRefused) {
  const auto gas = triangular_gas(6, 6, 0.6).make();
  auto memory = gas->save();
  memory["event-driven/time"].pop_back();
  EXPECT_THROW(gas->load(memory), InputError);
}

/// Flips all velocities: the run goes back the way it came, as long as rounding has not grown to the size of a particle.
/// Returns the largest distance from the start.
double distance_after_return(const TestGas<2>& gas, double duration) {
  const auto engine = gas.make();
  const auto start = by_id(*engine);
  engine->step(duration, 0);
  auto turned = particles_of(*engine);
  for (auto& phase : turned.phases) phase.velocity = -phase.velocity;
  engine->assign(turned);
  engine->step(duration, 0);
  const auto end = by_id(*engine);
  double largest = 0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    Vector<2> r = end[i].position - start[i].position;
    for (int axis = 0; axis < 2; ++axis)
      r[axis] -=
          gas.parameters.geometry.box[axis] * std::nearbyint(r[axis] / gas.parameters.geometry.box[axis]);
    largest = std::max(largest, r.norm());
  }
  return largest;
}

/// The Lyapunov horizon of 100 disks at nu = 0.4, T = 1: rounding grows exponentially, to the size of a particle after
/// some ten times.
TEST(Reversal, ReturnsToTheStartUntilTheLyapunovHorizon) {
  const auto gas = triangular_gas(10, 10, 0.4);
  const double soon = distance_after_return(gas, 0.3), later = distance_after_return(gas, 2.5);
  EXPECT_LT(soon, 1e-12);
  EXPECT_GT(later, 10 * soon);
  EXPECT_LT(later, 1e-3);
  double horizon = 0.5;
  while (distance_after_return(gas, horizon) < 0.1 && horizon < 50) horizon += 0.5;
  RecordProperty("lyapunov_horizon", std::to_string(horizon));
  RecordProperty("growth_rate", std::to_string(std::log(1e15) / (2 * horizon)));
  EXPECT_GT(horizon, 3);
  EXPECT_LT(horizon, 15);
}

}  // namespace
}  // namespace sandglass::event_driven::restart_test
