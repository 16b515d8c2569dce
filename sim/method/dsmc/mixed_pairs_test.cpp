#include "sim/base/statistics.hpp"
#include "sim/method/dsmc/test_cells.hpp"
#include "sim/physics/collision.hpp"

#include <numeric>

#include <gtest/gtest.h>

// Mixtures. Statistical bounds are 4.5 standard errors.

namespace sandglass::dsmc::mixed_pairs_test {
namespace {

Parameters mixture(int dimension, const std::vector<SpeciesTraits>& species, double restitution) {
  Parameters parameters;
  parameters.kinds.species = species;
  parameters.kinds.surfaces.assign(species.size() * species.size(), Surface{{restitution}});
  double largest = 0;
  for (const SpeciesTraits& kind : species) largest = std::max(largest, kind.diameter);
  parameters.cross_section = cross_section(dimension, largest);
  parameters.restitution = restitution;
  return parameters;
}

template <int D>
TestCells<D> cells_of_two(std::size_t count, std::size_t species) {
  TestCells<D> cells;
  cells.add_cell(random_velocities<D>(count, 3));
  for (std::size_t i = 0; i < count; ++i) cells.species.push_back(static_cast<std::uint8_t>(i % species));
  return cells;
}

/// Two species that are alike are one: the same bits.
template <int D>
void expect_same_as_one() {
  Parameters one;
  one.restitution = 0.8;
  auto expected = cells_of_two<D>(20, 2), mixed = expected;
  const auto alike = make_collision_stage<D>(mixture(D, {{1, 1}, {1, 1}}, 0.8));
  const auto plain = make_collision_stage<D>(one);
  for (std::uint64_t step = 0; step < 50; ++step) {
    expected.collide(*plain, 0.01, step);
    mixed.collide(*alike, 0.01, step);
  }
  EXPECT_GT(mixed.tally.collisions, 50u);
  EXPECT_EQ(mixed.tally.candidates, expected.tally.candidates);
  for (std::size_t i = 0; i < mixed.particles.size(); ++i)
    EXPECT_EQ(mixed.particles[i].velocity, expected.particles[i].velocity);
}

TEST(MixedPairs, OfAlikeSpeciesAreSmoothPairs) {
  expect_same_as_one<2>();
  expect_same_as_one<3>();
}

/// Collisions of each pair of species in one cell, against the sum over pairs of cross-section times relative speed.
template <int D>
void expect_rates(const std::vector<SpeciesTraits>& species, std::size_t count, double candidates) {
  constexpr std::uint64_t kStreams = 40'000;
  const Parameters parameters = mixture(D, species, -1);  // transparent: the rate stays what it is
  const auto stage = make_collision_stage<D>(parameters);
  TestCells<D> cells = cells_of_two<D>(count, species.size());
  const auto fresh = cells.particles;
  const std::size_t kinds = species.size();
  std::vector<double> sums(kinds * kinds, 0);
  double widest = 0;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double reach = (species[cells.species[i]].diameter + species[cells.species[j]].diameter) / 2;
      const double section = D == 2 ? 2 * reach : M_PI * reach * reach;
      widest = std::max(widest, section);
      sums[cells.species[i] * kinds + cells.species[j]] +=
          2 * section / parameters.cross_section * (fresh[i].velocity - fresh[j].velocity).norm();
    }
  const double coefficient = candidates / candidates_per_coefficient(random_velocities<D>(count, 3));
  std::vector<std::vector<double>> counts(kinds * kinds);
  for (std::uint64_t stream = 0; stream < kStreams; ++stream) {
    cells.particles = fresh;
    cells.tally.by_species.assign(kinds * kinds, 0);
    cells.collide(*stage, coefficient, stream);
    for (std::size_t a = 0; a < kinds; ++a)
      for (std::size_t b = 0; b <= a; ++b)
        counts[a * kinds + b].push_back(static_cast<double>(
            cells.tally.by_species[a * kinds + b] + (a == b ? 0 : cells.tally.by_species[b * kinds + a])));
  }
  for (std::size_t a = 0; a < kinds; ++a)
    for (std::size_t b = 0; b <= a; ++b) {
      const Mean mean = mean_of_independent(counts[a * kinds + b]);
      double expected = coefficient * sums[a * kinds + b];
      if (a != b) expected += coefficient * sums[b * kinds + a];
      EXPECT_NEAR(mean.value, expected, 4.5 * mean.standard_error + 1e-12) << D << ' ' << a << b;
    }
}

TEST(MixedPairs, CollideAtTheRateOfTheirCrossSection) {
  expect_rates<2>({{1, 1}, {3, 5}}, 9, 2.3);
  expect_rates<3>({{1, 1}, {3, 5}}, 9, 2.3);
  expect_rates<3>({{0.5, 1}, {1, 2}, {4, 0.1}}, 7, 5.0);
}

/// One large particle among small ones: the bound is that of the widest pair, not of two large ones.
TEST(MixedPairs, DrawCandidatesForTheWidestPairOfTheCell) {
  const Parameters parameters = mixture(2, {{1, 1}, {9, 1}}, -1);
  const auto stage = make_collision_stage<2>(parameters);
  const auto velocities = random_velocities<2>(6, 3);
  const double coefficient = 200 / candidates_per_coefficient(velocities);
  for (const auto& [large, section] : {std::pair{0, 1.0 / 9}, std::pair{1, 5.0 / 9}, std::pair{2, 1.0}}) {
    TestCells<2> cells;
    cells.add_cell(velocities);
    cells.species.assign(6, 0);
    for (int i = 0; i < large; ++i) cells.species[static_cast<std::size_t>(i)] = 1;
    cells.collide(*stage, coefficient, 0);
    EXPECT_NEAR(static_cast<double>(cells.tally.candidates), 200 * section, 1);
  }
}

/// Momentum, and energy of elastic particles, whatever the masses; the energy lost is (1 - r^2)/2 M c_n^2 on average
/// (1 - r^2)/2 M c^2 <cos^2>, with <cos^2> = 2/3 in 2D and 1/2 in 3D.
template <int D>
void expect_conserved(double restitution, double mass_2) {
  const Parameters parameters = mixture(D, {{1, 1}, {2, mass_2}}, restitution);
  const auto stage = make_collision_stage<D>(parameters);
  std::vector<double> losses;
  const Vector<D> apart = Vector<D>::Unit(0);
  for (std::uint64_t stream = 0; stream < 20'000; ++stream) {
    TestCells<D> cells;
    cells.add_cell({apart, -apart});
    cells.species = {0, 1};
    cells.collide(*stage, 0.3, stream);
    if (cells.tally.collisions != 1) continue;
    const Vector<D> momentum = cells.particles[0].velocity + mass_2 * cells.particles[1].velocity;
    ASSERT_NEAR((momentum - (1 - mass_2) * apart).norm(), 0, 1e-12 * (1 + mass_2));
    const double energy = 0.5 * (cells.particles[0].velocity.squaredNorm() +
                                 mass_2 * cells.particles[1].velocity.squaredNorm());
    losses.push_back(0.5 * (1 + mass_2) - energy);
  }
  const double reduced = mass_2 / (1 + mass_2), cosine = D == 2 ? 2.0 / 3 : 1.0 / 2;
  const Mean mean = mean_of_independent(losses);
  EXPECT_GT(losses.size(), 1000u);
  EXPECT_NEAR(mean.value, (1 - restitution * restitution) / 2 * reduced * 4 * cosine,
              4.5 * mean.standard_error + 1e-12);
}

TEST(MixedPairs, KeepMomentumAndLoseTheEnergyOfTheReducedMass) {
  for (double mass : {1.0, 0.01, 30.0, 1e6}) {
    expect_conserved<2>(1, mass);
    expect_conserved<3>(1, mass);
    expect_conserved<2>(0.6, mass);
    expect_conserved<3>(0.6, mass);
  }
}

TEST(MixedPairs, FaultOfTheReducedMassBreaksTheEnergyAndKeepsMomentum) {
  Parameters parameters = mixture(3, {{1, 1}, {1, 4}}, 1);
  parameters.faults.first_reduced_mass = true;
  TestCells<3> cells;
  cells.add_cell({{1, 0, 0}, {-1, 0, 0}});
  cells.species = {0, 1};
  for (std::uint64_t stream = 0; cells.tally.collisions < 1; ++stream)
    cells.collide(*make_faulty_collision_stage<3>(parameters), 0.3, stream);
  const Vector<3> momentum = cells.particles[0].velocity + 4 * cells.particles[1].velocity;
  EXPECT_NEAR((momentum - Vector<3>(-3, 0, 0)).norm(), 0, 1e-12);
  EXPECT_LT(cells.particles[0].velocity.squaredNorm() + 4 * cells.particles[1].velocity.squaredNorm(), 4.99);
}

}  // namespace
}  // namespace sandglass::dsmc::mixed_pairs_test
