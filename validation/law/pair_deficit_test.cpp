#include "validation/law/pair_deficit.hpp"

#include "validation/law/contact.hpp"
#include "validation/law/fluctuation.hpp"
#include "validation/law/state.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::law::pair_deficit_test {
namespace {

Gas gas(int dimension, double fraction) { return {dimension, 1, 1, 1, fraction, 1}; }

double most(const Bounded& part) { return part.value + part.bound; }
double least(const Bounded& part) { return part.value - part.bound; }

/// (1 - S)[1/N_c + (2 nu g'/g + nu^2 g''/(2g))/N_w]; disks at 0.25: g'/g = 2.176, g''/g = 8.05, S = 0.332.
TEST(PairDeficit, MostIsThatOfLongWaves) {
  EXPECT_NEAR(most(pair_deficit(gas(2, 0.25), {400, 35, 1, 1e12})), 0.6682 * (1 + 1.088 + 0.2516) / 400,
              1e-6);
  EXPECT_NEAR(most(pair_deficit(gas(2, 0.25), {25, 9, 3, 1e12})), 0.6682 * (1 / 25. + (1.088 + 0.2516) / 225),
              1e-5);
  const Bounded closed = pair_deficit(gas(2, 0.25), {400, 35, 1, 25});  // no wave with k = 0
  EXPECT_NEAR(most(closed), 24. / 25 * 0.6682 * 2.3396 / 400, 1e-6);
}

/// A long, thin box of large cells in which only waves along it are damped would have the variance of the law of slices; in
/// one dimension of waves that is the sum below.
TEST(PairDeficit, LeastIsTheFluidOfCells) {
  const Gas disks = gas(2, 0.2);
  const double edge = 1e6;  // offsets are short
  const double pairs = 2 * excluded_fraction(disks) * contact_value(2, 0.2);
  const double slope = excluded_fraction(disks) * 0.2 * contact_value_slope(2, 0.2);
  double missing = 0;
  const double step = 0.05;
  for (double x = step / 2; x < 60; x += step)  // plainly over the plane, far beyond what the law sums
    for (double y = step / 2; y < 60; y += step) {
      const double c = std::pow(std::sin(x) / x * std::sin(y) / y, 2);
      missing += c * (1 - 1 / (1 + c * (pairs + slope)));
    }
  const Bounded law = pair_deficit(disks, {100, edge, 1, 1e12});
  const Bounded other = pair_deficit(disks, {1e9, edge, 1, 1e12});
  EXPECT_NEAR(least(other), 0, 1e-8);
  const double growth = most(law) / ((1 - long_wave_structure(disks)) / 100);  // 1 + slope + curvature
  EXPECT_NEAR(least(law), missing * std::pow(step / std::acos(0.0), 2) / 100 * growth, 0.02 * least(law));
}

TEST(PairDeficit, VanishesWithoutCollisions) {
  EXPECT_NEAR(pair_deficit(gas(3, 1e-9), {5, 2, 3, 1e12}).value, 0, 1e-8);
}

struct Measured {
  int dimension;
  double fraction;
  PairCells cells;
  double missing, error;
};

/// Percent of the rate of an elastic gas that is missing with `cba`: 0.1 collisions per particle and step, weight 1, and the
/// table of docs/theory.md, cells of 1.923 diameters.
TEST(PairDeficit, RunsLieBetweenTheLimits) {
  const Measured runs[] = {
      {2, 0.25, {400, 35.45, 1, 25}, 0.264, 0.047}, {2, 0.25, {100, 17.72, 1, 100}, 1.315, 0.046},
      {2, 0.25, {25, 8.86, 3, 400}, 2.407, 0.045},  {2, 0.05, {3, 1.923, 7, 1e6}, 2.77, 0.05},
      {2, 0.05, {10, 1.923, 5, 1e6}, 0.89, 0.05},   {2, 0.3, {3, 1.923, 7, 1e6}, 13.86, 0.05},
      {2, 0.3, {10, 1.923, 5, 1e6}, 4.83, 0.05},    {3, 0.05, {3, 1.923, 5, 1e6}, 5.33, 0.05},
      {3, 0.05, {10, 1.923, 3, 1e6}, 1.82, 0.05},   {3, 0.14, {5, 1.923, 3, 1e6}, 7.46, 0.05},
      {3, 0.3, {10, 1.923, 3, 1e6}, 5.99, 0.05}};
  for (const Measured& run : runs) {
    const Bounded law = pair_deficit(gas(run.dimension, run.fraction), run.cells);
    EXPECT_NEAR(run.missing, 100 * law.value, 100 * law.bound + 2 * run.error)
        << run.dimension << "D " << run.fraction << ", " << run.cells.particles << " a cell";
  }
}

}  // namespace
}  // namespace sandglass::law::pair_deficit_test
