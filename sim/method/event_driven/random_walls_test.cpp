#include "sim/method/event_driven/test_gas.hpp"

namespace sandglass::event_driven::random_walls_test {
namespace {

struct Start {
  std::uint64_t id;
  Phase<2> phase;
};

/// Velocities of the particle with identity 7 after each of its events, between walls that turn the motion along
/// themselves at random.
std::vector<Vector<2>> velocities_of_seven(const std::vector<Start>& starts) {
  TestGas<2> gas({10, 60});
  gas.add_walls(0, {WallKind::random_tangential_sign});
  for (const Start& start : starts) {
    gas.add(start.phase.position, start.phase.velocity);
    gas.particles.columns.append(column::id, start.id);
  }
  gas.parameters.particles = 3;  // the same cells whoever is there
  Recorder<2> trace;
  const auto engine = gas.make(&trace);
  engine->step(300, 0);
  EXPECT_EQ(engine->tally().collisions, 0u);
  std::vector<Vector<2>> velocities;
  for (const auto& event : trace.events)
    if (event.first == 7) velocities.push_back(event.velocity_1);
  return velocities;
}

/// What a particle draws is its own: it depends neither on who else is there nor on the order in which they stand.
TEST(RandomWalls, DrawsOfAParticleDoNotDependOnOthers) {
  const Start seven{7, {{5, 10}, {1.3, 0.02}}}, two{2, {{5, 30}, {1.7, -0.02}}},
      nine{9, {{4, 50}, {-0.9, 0.01}}};
  const auto alone = velocities_of_seven({seven});
  ASSERT_GT(alone.size(), 30u);
  EXPECT_EQ(velocities_of_seven({two, seven, nine}), alone);
  EXPECT_EQ(velocities_of_seven({nine, seven, two}), alone);
  int turns = 0;
  for (std::size_t k = 1; k < alone.size(); ++k) turns += alone[k][1] * alone[k - 1][1] < 0;
  EXPECT_GT(turns, 5);
  EXPECT_LT(turns, static_cast<int>(alone.size()) - 5);
}

TEST(RandomWalls, ParticlesDrawDifferently) {
  TestGas<2> gas({10, 60});
  gas.add_walls(0, {WallKind::thermal});
  gas.parameters.keep_ids = true;
  for (int i = 0; i < 3; ++i) gas.add({5, 10.0 + 20 * i}, {1.3, 0});
  Recorder<2> trace;
  const auto engine = gas.make(&trace);
  engine->step(4, 0);
  ASSERT_GE(trace.events.size(), 3u);
  EXPECT_NE(trace.events[0].velocity_1, trace.events[1].velocity_1);
  EXPECT_NE(trace.events[1].velocity_1, trace.events[2].velocity_1);
}

/// The virial of the same gas whose particles stand in another order: not a digit.
TEST(Virial, DoesNotDependOnTheOrderOfParticles) {
  auto gas = triangular_gas(12, 12, 0.5);
  gas.parameters.measure_transfer = true;
  const auto one = gas.make();
  std::ranges::reverse(gas.particles.phases);
  const auto other = gas.make();
  for (int i = 0; i < 10; ++i) {
    one->step(0.05, 0);
    other->step(0.05, 0);
  }
  EXPECT_GT(one->tally().collisions, 100u);
  EXPECT_EQ(one->tally().transfer.value(), other->tally().transfer.value());
}

}  // namespace
}  // namespace sandglass::event_driven::random_walls_test
