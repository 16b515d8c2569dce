#include "sim/method/mixing/support.hpp"

#include "sim/method/mixing/test_listing.hpp"

#include <gtest/gtest.h>

namespace sandglass::mixing::support_test {
namespace {

SupportParameters blocks_of_25() { return {{100, 100}, 4, 4, 20, 1e-3}; }

double share_of_last(const std::vector<Phase<2>>& particles,
                     const SupportParameters& parameters = blocks_of_25()) {
  Support support(parameters);
  support.prepare(particles);
  return support.share(particles.size() - 1);
}

Phase<2> at(double x, double y) { return {{x, y}, {0, 0}}; }

TEST(Support, NobodyBelowLeavesGravityWhole) { EXPECT_EQ(share_of_last({at(50, 60)}), 1); }

/// Up to a diameter above the floor in the lowest row.
TEST(Support, TheFloorCarriesTheLowest) {
  EXPECT_EQ(share_of_last({at(50, 20)}), 0);
  EXPECT_EQ(share_of_last({at(50, 20.001)}), 1);
}

/// The lowest row of the strip 37.5 to 62.5 holds the square 40 to 60, 0 to 20: 400 of 625.
TEST(Support, IsTheShareOfTheStripThatSquaresLeaveFree) {
  EXPECT_NEAR(share_of_last({at(50, 10), at(50, 30)}), 1 - 400 / (625 + 1e-3), 1e-15);
  EXPECT_NEAR(share_of_last({at(65, 10), at(50, 30)}), 1 - 7.5 * 20 / (625 + 1e-3), 1e-15);
}

TEST(Support, AnEmptyRowCarriesNothing) {
  EXPECT_EQ(share_of_last({at(50, 10), at(50, 80)}), 1);
  EXPECT_LT(share_of_last({at(50, 12), at(50, 30), at(50, 60), at(50, 80)}), 1);
}

TEST(Support, WallsCutTheStripAndTheSquares) {
  EXPECT_NEAR(share_of_last({at(5, 5), at(0, 30)}), 1 - 12.5 * 15 / (12.5 * 25 + 1e-3), 1e-15);
}

/// Greenspan (2.9): antigravity where many are compressed below.
TEST(Support, SquaresThatOverlapLiftAParticle) {
  EXPECT_LT(share_of_last({at(50, 10), at(50, 11), at(50, 12), at(50, 30)}), 0);
}

/// The listing skips what is higher, not what is as high.
TEST(Support, EqualHeightsSupportEachOther) {
  EXPECT_LT(share_of_last({at(60, 24), at(50, 24)}), 1);
  EXPECT_EQ(share_of_last({at(60, 24.001), at(50, 24)}), 1);
}

TEST(Support, TheFaultCountsTheParticleItself) {
  SupportParameters parameters = blocks_of_25();
  parameters.counts_itself = true;
  EXPECT_LT(share_of_last({at(50, 24)}, parameters), 1);
}

void expect_twin(const SupportParameters& parameters, std::size_t count, std::uint64_t seed) {
  const auto particles = random_particles(parameters.box, count, seed);
  const std::vector<double> expected = listed_shares(particles, parameters);
  Support support(parameters);
  support.prepare(particles);
  // Rounding of a sum of `count` areas, relative to the strip, whose squares may overlap many times.
  for (std::size_t i = 0; i < count; ++i)
    ASSERT_NEAR(support.share(i), expected[i],
                1e-15 * static_cast<double>(count) * (1 + std::abs(expected[i])))
        << i << " of " << count;
}

TEST(Support, IsThatOfTheListing) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) expect_twin(blocks_of_25(), 16, seed);
  expect_twin({{100, 100}, 16, 16, 5, 1e-3}, 256, 1);
  expect_twin({{100, 100}, 16, 16, 5, 1e-3}, 60, 2);    // many empty rows
  expect_twin({{300, 40}, 7, 3, 9, 0}, 200, 3);         // squares wider than a strip is long
  expect_twin({{10, 100}, 1, 30, 8, 1e-3}, 50, 4);      // one block wide, squares higher than a row
  expect_twin({{100, 100}, 200, 2, 1, 1e-3}, 2000, 5);  // strips narrower than a square
  expect_twin({{200, 200}, 3, 130, 7, 1e-3}, 1000, 6);  // more rows than a word has bits, none of them empty
  expect_twin({{200, 200}, 20, 130, 7, 1e-3}, 1000, 7);
  expect_twin({{200, 200}, 30, 1, 7, 1e-3}, 500, 8);      // one row
  expect_twin({{100, 100}, 2, 100000, 5, 1e-3}, 200, 9);  // too many rows for fine columns
}

/// Centres and edges on the boundaries of rows and columns.
TEST(Support, IsThatOfTheListingOnALattice) {
  std::vector<Phase<2>> particles;
  for (int x = 0; x <= 20; ++x)
    for (int y = 0; y <= 20; ++y) particles.push_back(at(5 * x, 5 * y));
  const SupportParameters parameters{{100, 100}, 10, 10, 5, 1e-3};
  const std::vector<double> expected = listed_shares(particles, parameters);
  Support support(parameters);
  support.prepare(particles);
  for (std::size_t i = 0; i < particles.size(); ++i) EXPECT_NEAR(support.share(i), expected[i], 1e-12) << i;
}

}  // namespace
}  // namespace sandglass::mixing::support_test
