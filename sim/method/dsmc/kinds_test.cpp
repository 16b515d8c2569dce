#include "sim/method/dsmc/dsmc.hpp"
#include "sim/physics/collision.hpp"

#include <gtest/gtest.h>

// Species and spins through whole steps: columns travel with their particles, and walls know them.

namespace sandglass::dsmc::kinds_test {
namespace {

constexpr double kEdge = 4;
constexpr std::size_t kCount = 2000;

template <int D>
Particles<D> start(bool spins, std::size_t species) {
  Random random(StreamKey(1, Purpose::positions, 0, 0), 0);
  Particles<D> particles;
  for (std::size_t i = 0; i < kCount; ++i) {
    Phase<D> phase;
    Spin<D> spin;
    for (int axis = 0; axis < D; ++axis) {
      phase.position[axis] = kEdge * random.uniform();
      phase.velocity[axis] = 2 * random.uniform() - 1;
    }
    for (double& component : spin.reshaped()) component = 2 * random.uniform() - 1;
    particles.phases.push_back(phase);
    if (spins) particles.columns.append(column::spin<D>, spin);
    if (species > 1) particles.columns.append(column::species, static_cast<std::uint8_t>(i % species));
  }
  return particles;
}

template <int D>
Dsmc<D> gas(const Kinds& kinds, motion::MotionParameters<D> motion) {
  std::array<std::uint32_t, D> cells;
  cells.fill(4);
  Parameters parameters;
  parameters.kinds = kinds;
  parameters.cross_section = 0.02;
  motion.species = kinds.species;
  std::vector<ColumnInfo> columns;
  if (kinds.mixed()) columns.push_back(column::species);
  if (kinds.rough) columns.push_back(column::spin<D>);
  return Dsmc<D>(Grid<D>(Vector<D>::Constant(kEdge), cells), parameters, motion, {}, Purpose::collisions,
                 columns);
}

struct Energies {
  double translation = 0, rotation = 0;
};

template <int D>
Energies energies(Dsmc<D>& dsmc) {
  const View<D> view = dsmc.view();
  const auto spins = view.columns.get(column::spin<D>);
  const auto species = view.columns.get(column::species);
  Energies all;
  for (std::size_t i = 0; i < view.particles.size(); ++i) {
    const SpeciesTraits& kind = view.traits[species.empty() ? 0 : species[i]];
    all.translation += 0.5 * kind.mass * view.particles[i].velocity.squaredNorm();
    if (!spins.empty()) all.rotation += 0.5 * kind.inertia * spins[i].squaredNorm();
  }
  return all;
}

template <int D>
motion::MotionParameters<D> between_walls(const WallRule& rule) {
  motion::MotionParameters<D> motion;
  motion.walled[0] = true;
  for (const bool high : {false, true})
    motion.walls.push_back({0, high, high ? kEdge : 0, Vector<D>::Zero(), 0, 0, rule});
  return motion;
}

/// Perfectly rough elastic pairs and walls keep the energy of two species that spin, and exchange its parts.
template <int D>
void expect_energy() {
  const Kinds kinds{{{1, 1, 0.1}, {2, 3, 0.7}}, std::vector<Surface>(4, Surface{{1}, 1}), true, {}};
  Dsmc<D> dsmc = gas<D>(kinds, between_walls<D>({WallKind::specular, {{1}, 1}}));
  dsmc.assign(start<D>(true, 2));
  const Energies before = energies(dsmc);
  for (std::uint64_t step = 0; step < 100; ++step) dsmc.step(0.1, step);
  const Energies after = energies(dsmc);
  EXPECT_GT(dsmc.tally().collisions, 100u);
  EXPECT_NEAR(after.translation + after.rotation, before.translation + before.rotation,
              1e-10 * before.translation);
  EXPECT_GT(std::abs(after.rotation - before.rotation), 0.01 * before.rotation);
}

TEST(Kinds, RoughWallsAndPairsKeepTheEnergy) {
  expect_energy<2>();
  expect_energy<3>();
}

/// Between thermal walls smooth pairs never touch the spins; walls give them their temperature. Statistical: 5 standard
/// errors of the mean of 2000 particles with three components.
TEST(Kinds, ThermalWallsTurnParticles) {
  const Kinds kinds{{{1, 1, 0.1}}, {Surface{{1}, 0, 0}}, true, {}};
  Dsmc<3> dsmc = gas<3>(kinds, between_walls<3>({WallKind::thermal, {}, 1, 2}));
  dsmc.assign(start<3>(true, 1));
  for (std::uint64_t step = 0; step < 3000; ++step) dsmc.step(0.1, step);
  EXPECT_NEAR(energies(dsmc).rotation / (1.5 * kCount), 2, 5 * 2 * std::sqrt(2.0 / (3 * kCount)));
}

/// Smooth elastic walls give what they take, by the mass of each particle; nobody collides.
TEST(Kinds, WallsWeighTheSpecies) {
  const Kinds kinds{{{1, 1, 0}, {1, 5, 0}}, std::vector<Surface>(4, Surface{}), false, {}};
  auto motion = between_walls<2>({});
  WallImpulses<2> impulses;
  motion.impulses = &impulses;
  Dsmc<2> dsmc = gas<2>(kinds, motion);
  Particles<2> two;
  two.phases = {{{1, 1}, {-1, 0}}, {{3, 3}, {1, 0.5}}};
  two.columns.set(column::species, std::vector<std::uint8_t>{0, 1});
  dsmc.assign(two);
  dsmc.step(1.5, 0);
  EXPECT_NEAR(impulses.impulse(WallImpulses<2>::side(0, false))[0], -2, 1e-14);
  EXPECT_NEAR(impulses.impulse(WallImpulses<2>::side(0, true))[0], 10, 1e-14);
}

/// Stopped and gone on from its particles, the gas is bit for bit where the uninterrupted one is.
TEST(Kinds, GoOnAfterARestart) {
  const Kinds kinds{{{1, 1, 0.1}, {2, 3, 0.7}}, std::vector<Surface>(4, Surface{{0.8}, 0.3, 0.2}), true, {}};
  const auto motion = between_walls<3>({WallKind::specular, {{0.9}, 0}});
  Dsmc<3> whole = gas<3>(kinds, motion);
  whole.assign(start<3>(true, 2));
  std::uint64_t step = 0;
  for (; step < 20; ++step) whole.step(0.1, step);
  Particles<3> middle;
  const View<3> view = whole.view();
  middle.phases.assign(view.particles.begin(), view.particles.end());
  for (const ColumnView& column : view.columns) middle.columns.set(column);
  Dsmc<3> second = gas<3>(kinds, motion);
  second.restore(middle, whole.save());
  for (; step < 40; ++step) {
    whole.step(0.1, step);
    second.step(0.1, step);
  }
  const auto spins = whole.view().columns.get(column::spin<3>),
             again = second.view().columns.get(column::spin<3>);
  for (std::size_t i = 0; i < kCount; ++i) {
    ASSERT_EQ(whole.view().particles[i].velocity, second.view().particles[i].velocity);
    ASSERT_EQ(spins[i], again[i]);
  }
}

}  // namespace
}  // namespace sandglass::dsmc::kinds_test
