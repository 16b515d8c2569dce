#include "sim/method/mixing/pair_forces.hpp"
#include "sim/method/mixing/test_listing.hpp"
#include "sim/space/particle_store.hpp"

#include <gtest/gtest.h>

namespace sandglass::mixing::repulsion_test {
namespace {

TEST(Power, IsThatOfTheLibrary) {
  for (std::uint64_t n = 0; n <= 12; ++n)
    for (const double x : {0.3, 1.0, 7.5})
      EXPECT_NEAR(power(x, n), std::pow(x, static_cast<double>(n)),
                  1e-14 * std::pow(x, static_cast<double>(n)));
}

/// Greenspan (2.11) at r = 3, xi = 1, p = 2, beta = 3, d = 5: 2 / [16 (4/5)^3].
TEST(Repulsion, IsThatOfTheSource) {
  const Repulsion law{2, 1, 2, 3, 5, 10};
  EXPECT_NEAR(law.per_separation(3), 2 / (16 * 0.512), 1e-15);
  EXPECT_NEAR(law.per_separation(5), 2.0 / 36, 1e-15);  // the core begins below a diameter
}

struct Set {
  std::vector<Phase<2>> particles;
  std::vector<double> masses;
};

/// Sorted into the cells of a grid.
Set sorted(const Grid<2>& grid, std::size_t count, std::uint64_t seed, std::vector<std::uint32_t>& offsets) {
  ParticleStore<2> store(grid);
  store.assign({random_particles(grid.box(), count, seed), {}});
  offsets.assign(store.offsets().begin(), store.offsets().end());
  Set set{{store.phases().begin(), store.phases().end()}, {}};
  for (std::size_t i = 0; i < count; ++i) set.masses.push_back(1 + static_cast<double>(i % 3));
  return set;
}

void expect_twin(const Repulsion& law, const Grid<2>& grid, std::size_t count) {
  std::vector<std::uint32_t> offsets;
  const Set set = sorted(grid, count, 1, offsets);
  const auto expected = listed_accelerations(set.particles, set.masses, law);
  std::vector<Vector<2>> found(count, Vector<2>::Zero());
  PairForces(law, grid).add({set.particles, offsets, set.masses}, found);
  for (std::size_t i = 0; i < count; ++i)
    ASSERT_LT((found[i] - expected[i]).norm(), 1e-12 * (1 + expected[i].norm())) << i;
}

TEST(PairForces, AreThoseOfTheListing) {
  expect_twin({1, 0, 2, 5, 20}, Grid<2>({100, 100}, {1, 1}), 16);          // all pairs
  expect_twin({1, 0.1, 2, 2, 5, 10}, Grid<2>({100, 100}, {10, 10}), 256);  // cells as wide as the cutoff
  expect_twin({1, 0.1, 2, 2, 5, 10}, Grid<2>({100, 100}, {7, 9}), 256);    // wider ones
  expect_twin({1, 0.1, 1, 0, 5, 30}, Grid<2>({100, 20}, {3, 1}), 60);      // one row
  expect_twin({1, 0.1, 1, 0, 5, 30}, Grid<2>({20, 100}, {1, 3}), 60);      // one column
}

TEST(PairForces, ConserveMomentum) {
  const Grid<2> grid({100, 100}, {10, 10});
  std::vector<std::uint32_t> offsets;
  const Set set = sorted(grid, 500, 2, offsets);
  std::vector<Vector<2>> found(500, Vector<2>::Zero());
  const Repulsion law{1, 0.1, 2, 2, 5, 10};
  EXPECT_GT(PairForces(law, grid).add({set.particles, offsets, set.masses}, found), 1000u);
  Vector<2> force = Vector<2>::Zero();
  double scale = 0;
  for (std::size_t i = 0; i < 500; ++i) {
    force += set.masses[i] * found[i];
    scale += set.masses[i] * found[i].norm();
  }
  EXPECT_LT(force.norm(), 1e-14 * scale);
}

/// Softened, they neither repel nor break anything.
TEST(PairForces, OfCoincidingParticlesAreZero) {
  const std::vector<Phase<2>> two = {{{5, 5}, {0, 0}}, {{5, 5}, {0, 0}}};
  const std::vector<std::uint32_t> offsets = {0, 2};
  const std::vector<double> masses = {1, 1};
  std::vector<Vector<2>> found(2, Vector<2>::Zero());
  PairForces({1, 0.1, 2, 2, 5, 10}, Grid<2>({10, 10}, {1, 1})).add({two, offsets, masses}, found);
  EXPECT_EQ(found[0], Vector<2>(0, 0));
}

}  // namespace
}  // namespace sandglass::mixing::repulsion_test
