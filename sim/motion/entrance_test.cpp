#include "sim/motion/entrance.hpp"

#include "sim/motion/test_flight.hpp"

#include <gtest/gtest.h>

// What enters flies as one that stood there all the time flies through a step of its own.

namespace sandglass::motion::entrance_test {
namespace {

constexpr double kDt = 0.6;

/// Open along the first axis, walls across the last, which gravity pulls along; an obstacle in the middle.
template <int D>
MotionParameters<D> channel() {
  MotionParameters<D> parameters;
  parameters.walled[0] = parameters.walled[D - 1] = true;
  parameters.open[0] = {true, true};
  parameters.gravity[D - 1] = -2;
  parameters.gravity[0] = -1;
  parameters.walls = {wall<D>(D - 1, false, {WallKind::specular, {{0.7}}})};
  parameters.obstacles = {{box<D>() / 2, 0.3, {}}};
  return parameters;
}

template <int D>
Entrants<D> some_entrants(std::size_t count) {
  Random random(StreamKey(4, Purpose::inflow, 0, 0), D);
  Entrants<D> entrants;
  for (std::size_t i = 0; i < count; ++i) {
    const bool high = i % 3 == 0;
    Phase<D> particle{box<D>().cwiseProduct(random_vector<D>(random)),
                      8 * (random_vector<D>(random) - Vector<D>::Constant(0.5))};
    particle.position[0] = high ? box<D>()[0] : 0;
    particle.velocity[0] = (high ? -1 : 1) * 6 * random.uniform();
    entrants.particles.phases.push_back(particle);
    entrants.arrivals.push_back({0, high, kDt * (1 - random.uniform())});
  }
  return entrants;
}

template <int D>
void expect_own_steps() {
  const MotionParameters<D> parameters = channel<D>();
  const Entrants<D> entrants = some_entrants<D>(400);
  const Arrived<D> arrived = Entrance<D>(parameters, box<D>()).fly(entrants, {kDt, 0, {}});
  const auto stage = make_motion_stage<D>(parameters, box<D>());
  std::size_t in = 0, out = 0;
  for (std::size_t i = 0; i < 400; ++i) {
    auto store = store_of<D>({entrants.particles.phases[i]});
    advance(*stage, store, {entrants.arrivals[i].left});
    const Vector<D> end = store.phases()[0].position;
    if (store.places()[0].cell == store.removed()) {
      ASSERT_TRUE(arrived.left[out++].isApprox(end, 1e-12));
      continue;
    }
    ASSERT_TRUE(arrived.particles.phases[in].position.isApprox(end, 1e-12)) << i;
    ASSERT_TRUE(arrived.particles.phases[in++].velocity.isApprox(store.phases()[0].velocity, 1e-12)) << i;
  }
  EXPECT_EQ(in, arrived.particles.phases.size());
  EXPECT_EQ(out, arrived.left.size());
  EXPECT_GT(in, 200u);
  EXPECT_GT(out, 20u);
}

TEST(Entrance, FliesWhatIsLeftOfTheStep) {
  expect_own_steps<2>();
  expect_own_steps<3>();
}

/// All that the particles in the box have at the end has come through sides and mirrors.
TEST(Entrance, SidesTakeWhatPassesThem) {
  MotionParameters<2> parameters = channel<2>();
  parameters.gravity.setZero();
  parameters.walls.clear();
  parameters.obstacles.clear();
  parameters.mass = 3;
  WallImpulses<2> impulses;
  parameters.impulses = &impulses;
  const Arrived<2> arrived = Entrance<2>(parameters, box<2>()).fly(some_entrants<2>(300), {kDt, 0, {}});
  Vector<2> momentum = Vector<2>::Zero(), given = Vector<2>::Zero();
  double energy = 0, taken = 0;
  for (const Phase<2>& particle : arrived.particles.phases) {
    momentum += 3 * particle.velocity;
    energy += 1.5 * particle.velocity.squaredNorm();
  }
  for (std::size_t side = 0; side < 4; ++side) {
    given += impulses.impulse(side);
    taken += impulses.heat(side);
  }
  EXPECT_GT(arrived.left.size(), 10u);
  EXPECT_TRUE(momentum.isApprox(-given, 1e-12));
  EXPECT_NEAR(energy / -taken, 1, 1e-12);
}

/// Spins and species stay with their particle.
TEST(Entrance, KeepsSpeciesAndSpins) {
  MotionParameters<2> parameters;
  parameters.walled[0] = true;
  parameters.open[0] = {true, true};
  parameters.species = {{0.1, 1, 0.1}, {0.2, 2, 0.2}};
  Entrants<2> entrants = some_entrants<2>(90);
  for (std::size_t i = 0; i < 90; ++i) {
    entrants.particles.columns.append(column::species, static_cast<std::uint8_t>(i % 2));
    entrants.particles.columns.append(column::spin<2>, Spin<2>::Constant(static_cast<double>(i)));
  }
  const Arrived<2> arrived = Entrance<2>(parameters, box<2>()).fly(entrants, {kDt, 0, {}});
  const auto species = arrived.particles.columns.get(column::species);
  const auto spins = arrived.particles.columns.get(column::spin<2>);
  ASSERT_EQ(species.size(), arrived.particles.phases.size());
  ASSERT_EQ(spins.size(), species.size());
  EXPECT_LT(species.size(), 90u);
  for (std::size_t i = 0; i < species.size(); ++i) {
    const auto from = static_cast<std::size_t>(spins[i][0]);
    EXPECT_EQ(species[i], from % 2);
    EXPECT_EQ(arrived.particles.phases[i].velocity, entrants.particles.phases[from].velocity);
  }
}

}  // namespace
}  // namespace sandglass::motion::entrance_test
