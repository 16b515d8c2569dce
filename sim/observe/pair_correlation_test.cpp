#include "sim/observe/pair_correlation.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/pairs.hpp"
#include "sim/observe/test_view.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::pair_correlation_test {
namespace {

ObserverSpec shells(double low, double high, std::size_t bins) {
  ObserverSpec spec;
  spec.range = {low, high};
  spec.bins = bins;
  return spec;
}

/// Slow twin: every pair with every image of the second partner.
template <int D>
std::vector<double> all_pairs(const TestSystem<D>& system, const ObserverSpec& spec) {
  std::vector<double> pairs(spec.bins);
  const auto edges = bin_edges(spec);
  const int images = D == 2 ? 9 : 27;
  for (std::size_t i = 0; i < system.particles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (int image = 0; image < images; ++image) {
        const Vector<3> shift(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
        const Vector<D> apart = system.particles[i].position - system.particles[j].position +
                                system.box.cwiseProduct(shift.head<D>());
        for (std::size_t bin = 0; bin < spec.bins; ++bin)
          pairs[bin] += apart.norm() >= edges[bin] && apart.norm() < edges[bin + 1];
      }
  const auto count = static_cast<double>(system.particles.size());
  for (std::size_t bin = 0; bin < spec.bins; ++bin) {
    const double a = edges[bin], b = edges[bin + 1];
    const double shell = D == 2 ? M_PI * (b * b - a * a) : 4 * M_PI / 3 * (b * b * b - a * a * a);
    pairs[bin] /= count * (count - 1) / 2 * shell / system.box.prod();
  }
  return pairs;
}

template <int D>
void expect_twin(const Vector<D>& box, std::size_t count, const ObserverSpec& spec, std::uint64_t seed) {
  auto system = random_system<D>(box, count, seed);
  PairCorrelation<D> observer(spec);
  observer.start(system.view());
  const auto fast = observer.measure(system.view()), slow = all_pairs(system, spec);
  for (std::size_t bin = 0; bin < spec.bins; ++bin) EXPECT_NEAR(fast[bin], slow[bin], 1e-12) << bin;
}

/// Ranges that leave many cells, three, and one along an axis.
TEST(PairCorrelation, FindsEveryPairOnce) {
  std::uint64_t seed = 1;
  for (double high : {0.3, 0.9, 1.3, 1.7, 2.0}) {
    expect_twin<2>({4, 7}, 200, shells(0, high, 5), ++seed);
    expect_twin<3>({4, 5, 11}, 150, shells(0, high, 5), ++seed);
    expect_twin<3>({9, 4, 4.1}, 2, shells(0.1, high, 2), ++seed);
  }
}

/// Particles on the edges of the box, also a whole box away.
TEST(PairCorrelation, PeriodicEdgesAreOneSeam) {
  TestSystem<2> system;
  system.add_cell({{{4, 4}, {0, 0}}, {{0.1, 0}, {0, 0}}, {{-0.05, 8}, {0, 0}}});
  const auto values = PairCorrelation<2>(shells(0, 0.2, 1)).measure(system.view());
  EXPECT_NEAR(values[0], 16 / (M_PI * 0.04), 1e-10);  // all three pairs within reach
}

/// Uniform independent particles: 1 in every bin, Poisson counts of pairs.
template <int D>
void expect_ideal_gas(std::uint64_t seed) {
  const std::size_t count = 20'000, bins = 20;
  auto system = random_system<D>(Vector<D>::Constant(D == 2 ? 100 : 20), count, seed);
  const auto spec = shells(0, 2, bins);
  const auto values = PairCorrelation<D>(spec).measure(system.view());
  const auto edges = bin_edges(spec);
  double chi_square = 0;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const double pairs =
        count * (count - 1.0) / 2 * shell_volume(D, edges[bin], edges[bin + 1]) / system.box.prod();
    chi_square += (values[bin] - 1) * (values[bin] - 1) * pairs;
  }
  EXPECT_LT(std::abs(chi_square - bins), 4 * std::sqrt(2.0 * bins));
}

TEST(PairCorrelation, OfAnIdealGasIsOne) {
  expect_ideal_gas<2>(11);
  expect_ideal_gas<3>(12);
}

/// Neighbours at 1, sqrt 2, 2 and sqrt 5: four, four, four and eight.
TEST(PairCorrelation, OfASquareLattice) {
  TestSystem<2> system;
  system.box = {12, 12};
  for (int i = 0; i < 144; ++i) system.add_cell({{{i % 12, i / 12}, {0, 0}}});
  const auto spec = shells(0.05, 2.35, 23);  // 0.05 to 0.15 and so on
  const auto values = PairCorrelation<2>(spec).measure(system.view());
  const auto edges = bin_edges(spec);
  const auto neighbours = [&](std::size_t bin) {
    return values[bin] * (143 / 144.0) * M_PI * (edges[bin + 1] * edges[bin + 1] - edges[bin] * edges[bin]);
  };
  for (std::size_t bin = 0; bin < 23; ++bin) {
    const double expected = bin == 21 ? 8 : bin == 9 || bin == 13 || bin == 19 ? 4 : 0;
    EXPECT_NEAR(neighbours(bin), expected, 1e-10) << bin;
  }
}

TEST(ShellVolume, HasTheLimitOfAThinShell) {
  EXPECT_NEAR(shell_volume(2, 3, 3 + 1e-9), 2 * M_PI * 3 * 1e-9, 1e-14);
  EXPECT_NEAR(shell_volume(3, 3, 3 + 1e-9), 4 * M_PI * 9 * 1e-9, 1e-13);
  EXPECT_DOUBLE_EQ(shell_volume(3, 0, 2), 32 * M_PI / 3);
}

TEST(PairCorrelation, BadRangeIsRefused) {
  EXPECT_THROW(PairCorrelation<2>(shells(-1, 1, 2)), InputError);
  EXPECT_THROW(PairCorrelation<2>(shells(1, 1, 2)), InputError);
  EXPECT_THROW(PairCorrelation<2>(shells(0, INFINITY, 2)), InputError);
  auto system = random_system<2>({4, 9}, 5, 1);
  EXPECT_NO_THROW(PairCorrelation<2>(shells(0, 2, 2)).start(system.view()));
  EXPECT_THROW(PairCorrelation<2>(shells(0, 2.01, 2)).start(system.view()), InputError);
  auto one = random_system<2>({4, 9}, 1, 1);
  EXPECT_THROW(PairCorrelation<2>(shells(0, 2, 2)).start(one.view()), InputError);
}

}  // namespace
}  // namespace sandglass::pair_correlation_test
