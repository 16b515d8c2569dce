#include "sim/observe/structure_factor.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/test_view.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::structure_factor_test {
namespace {

ObserverSpec lattice(std::vector<std::size_t> grid, std::size_t bins) {
  ObserverSpec spec;
  spec.grid = std::move(grid);
  spec.bins = bins;
  return spec;
}

template <int D>
std::vector<double> measured(TestSystem<D>& system, const ObserverSpec& spec) {
  StructureFactor<D> observer(spec);
  observer.start(system.view());
  return observer.measure(system.view());
}

/// Slow twin: sum over particles at the corners of their cells, for every wave vector of the lattice.
template <int D>
std::vector<double> direct(const TestSystem<D>& system, const ObserverSpec& spec) {
  std::vector<double> sum(spec.bins), count(spec.bins);
  std::vector<int> extent(spec.grid.begin(), spec.grid.end());
  extent.resize(3, 1);
  const double longest = system.box.maxCoeff();
  for (int x = -(extent[0] - 1) / 2; x <= extent[0] / 2; ++x)
    for (int y = -(extent[1] - 1) / 2; y <= extent[1] / 2; ++y)
      for (int z = -(extent[2] - 1) / 2; z <= extent[2] / 2; ++z) {
        const Vector<D> number = Vector<3>(x, y, z).head<D>();
        const double nearest = std::round(number.cwiseQuotient(system.box).norm() * longest);
        if (nearest < 1 || nearest > static_cast<double>(spec.bins)) continue;
        std::complex<double> wave = 0;
        for (const Phase<D>& particle : system.particles) {
          double phase = 0;
          for (int axis = 0; axis < D; ++axis) {
            const double cells = extent[static_cast<std::size_t>(axis)];
            const double corner = std::floor(particle.position[axis] / system.box[axis] * cells);
            phase += 2 * M_PI * number[axis] * corner / cells;
          }
          wave += std::polar(1.0, -phase);
        }
        sum[static_cast<std::size_t>(nearest) - 1] += std::norm(wave);
        ++count[static_cast<std::size_t>(nearest) - 1];
      }
  for (std::size_t bin = 0; bin < spec.bins; ++bin)
    sum[bin] /= count[bin] * static_cast<double>(system.particles.size());
  return sum;
}

template <int D>
void expect_twin(const Vector<D>& box, const ObserverSpec& spec, std::uint64_t seed) {
  auto system = random_system<D>(box, 60, seed);
  const auto fast = measured(system, spec), slow = direct(system, spec);
  ASSERT_EQ(fast.size(), slow.size());
  for (std::size_t bin = 0; bin < fast.size(); ++bin) EXPECT_NEAR(fast[bin], slow[bin], 1e-11) << bin;
}

TEST(StructureFactor, IsTheDirectSum) {
  expect_twin<2>({4, 4}, lattice({16, 16}, 8), 1);
  expect_twin<2>({4, 6}, lattice({8, 15}, 6), 2);
  expect_twin<2>({10, 3}, lattice({21, 9}, 10), 3);
  expect_twin<3>({4, 4, 4}, lattice({8, 8, 8}, 4), 4);
  expect_twin<3>({4, 5, 8}, lattice({6, 7, 10}, 4), 5);
}

/// Independent particles: every wave has mean square N with standard deviation N (exponential distribution), so the mean
/// over R systems of a shell of w waves, half of them conjugates of the others, is 1 within sqrt(2 / (w R)).
template <int D>
void expect_ideal_gas(const ObserverSpec& spec) {
  const int systems = 40;
  std::vector<double> mean(spec.bins);
  for (int i = 0; i < systems; ++i) {
    auto system = random_system<D>(Vector<D>::Constant(5), 500, 100 + static_cast<std::uint64_t>(i));
    const auto values = measured(system, spec);
    for (std::size_t bin = 0; bin < spec.bins; ++bin) mean[bin] += values[bin] / systems;
  }
  for (std::size_t bin = 0; bin < spec.bins; ++bin) {
    const double shell = static_cast<double>(bin) + 1;
    const double waves = D == 2 ? 2 * M_PI * shell : 4 * M_PI * shell * shell;
    EXPECT_NEAR(mean[bin], 1, 4 * std::sqrt(2 / (waves * systems))) << bin;
  }
}

TEST(StructureFactor, OfAnIdealGasIsOne) {
  expect_ideal_gas<2>(lattice({16, 16}, 8));
  expect_ideal_gas<3>(lattice({8, 8, 8}, 4));
}

/// Density 4 + 2 cos(2 pi 3 x / L) cells: S = 2 (N a / 2)^2 / N in the two waves +-3, nothing elsewhere.
TEST(StructureFactor, OfAPlaneWave) {
  TestSystem<2> system;
  system.box = {12, 12};
  for (int x = 0; x < 12; ++x)
    for (int y = 0; y < 12; ++y) {
      const int count = 4 + static_cast<int>(std::lround(2 * std::cos(2 * M_PI * 3 * x / 12)));
      system.add_cell(std::vector<Phase<2>>(static_cast<std::size_t>(count), {{x + 0.5, y + 0.5}, {0, 0}}));
    }
  const double particles = 4 * 144, amplitude = 0.5;
  const double peak = std::pow(particles * amplitude / 2, 2) / particles;
  const auto values = measured(system, lattice({12, 12}, 6));
  // 16 wave vectors are nearest to length 3: 2.5 <= |n| < 3.5.
  const std::vector<double> expected{0, 0, 2 * peak / 16, 0, 0, 0};
  for (std::size_t bin = 0; bin < 6; ++bin) EXPECT_NEAR(values[bin], expected[bin], 1e-11) << bin;
}

/// The shortest edge has the longest waves only in units of itself: shells count waves along the longest edge.
TEST(StructureFactor, ShellsAreOfTheLongestEdge) {
  TestSystem<2> system;
  system.box = {3, 12};
  for (int x = 0; x < 4; ++x) system.add_cell({{{0.75 * x * (x % 2 == 0), 1.0}, {0, 0}}});
  const auto values = measured(system, lattice({4, 16}, 8));
  const auto expected = direct(system, lattice({4, 16}, 8));
  for (std::size_t bin = 0; bin < 8; ++bin) EXPECT_NEAR(values[bin], expected[bin], 1e-12);
}

TEST(StructureFactor, MoreShellsThanTheLatticeResolvesAreRefused) {
  auto system = random_system<2>({4, 8}, 10, 1);
  EXPECT_NO_THROW(measured(system, lattice({8, 16}, 8)));
  EXPECT_THROW(measured(system, lattice({8, 16}, 9)), InputError);
  EXPECT_THROW(measured(system, lattice({6, 32}, 7)), InputError);
  TestSystem<2> empty;
  EXPECT_THROW(measured(empty, lattice({8, 8}, 2)), InputError);
}

}  // namespace
}  // namespace sandglass::structure_factor_test
