#include "sim/method/event_driven/faults.hpp"

#include "sim/method/event_driven/test_gas.hpp"

namespace sandglass::event_driven::faults_test {
namespace {

TEST(Faults, TheFaultyEngineWithASmallFaultIsTheHonestOneToRounding) {
  auto gas = triangular_gas(10, 10, 0.5);
  const auto honest = gas.make();
  gas.parameters.faults.momentum_leak = 1e-300;
  const auto faulty = gas.make();
  honest->step(0.5, 0);
  faulty->step(0.5, 0);
  EXPECT_GT(honest->tally().collisions, 50u);
  EXPECT_EQ(honest->tally().collisions, faulty->tally().collisions);
  const auto left = by_id(*honest), right = by_id(*faulty);
  for (std::size_t i = 0; i < left.size(); ++i)
    EXPECT_LT((left[i].position - right[i].position).norm(), 1e-9);
  EXPECT_TRUE(faulty->view().columns.get(column::species).empty());
}

TEST(Faults, ALeakLosesMomentum) {
  auto gas = triangular_gas(10, 10, 0.5);
  gas.parameters.faults.momentum_leak = 1e-3;
  const auto engine = gas.make();
  engine->step(5, 0);
  EXPECT_GT(momentum(*engine).norm(), 1e-3);
}

TEST(Faults, ABlindCrossingLetsParticlesOverlap) {
  auto gas = triangular_gas(10, 10, 0.5);
  gas.parameters.faults.blind_crossing = true;
  const auto engine = gas.make();
  engine->step(5, 0);
  EXPECT_GT(engine->tally().deepest_overlap, 1e-3);
}

/// The second of three learns that the first will come, then is hit by the third.
TEST(Faults, AStaleContactIsCarriedOut) {
  TestGas<2> gas({20, 20});
  gas.add({2, 10}, {1, 0});
  gas.add({8, 10}, {0, 0});
  gas.add({8, 6}, {0, 1});
  for (const bool stale : {false, true}) {
    gas.parameters.faults.stale_partner = stale;
    const auto engine = gas.make();
    engine->step(5.5, 0);
    EXPECT_EQ(engine->tally().collisions, stale ? 2u : 1u);
  }
}

}  // namespace
}  // namespace sandglass::event_driven::faults_test
