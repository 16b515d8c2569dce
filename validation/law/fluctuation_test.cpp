#include "validation/law/fluctuation.hpp"

#include "validation/law/contact.hpp"
#include "validation/law/state.hpp"

#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace sandglass::law::fluctuation_test {
namespace {

TEST(CountVariance, OfPointsIsBinomial) {
  for (int dimension : {2, 3}) {
    const Gas points{.dimension = dimension, .fraction = 0};
    EXPECT_DOUBLE_EQ(count_variance(points, 200 * 0.3, 0.3), 200 * 0.3 * 0.7);
  }
}

// Two parts of a closed box share its particles: the same variance from either side, none for the whole.
TEST(CountVariance, IsThatOfTheRestOfTheBox) {
  const Gas gas{.dimension = 2, .fraction = 0.4};
  EXPECT_NEAR(count_variance(gas, 100, 0.2), count_variance(gas, 400, 0.8), 1e-12);
  EXPECT_EQ(count_variance(gas, 500, 1), 0);
}

/// Weights e^(-F) of splitting particles between two parts of an isothermal box, F from the pressure alone.
TEST(CountVariance, IsThatOfTheFreeEnergyOfTwoParts) {
  for (int dimension : {2, 3}) {
    Gas gas{.dimension = dimension, .fraction = 0.3};
    const double total = 40000, share = 0.25;
    // Free energy per particle over T beyond the ideal: integral of (Z - 1)/nu, by Simpson's rule from `gas.fraction`.
    const auto excess = [&](double fraction) {
      const auto slope = [&](double at) {
        return (compressibility_factor({.dimension = dimension, .fraction = at}) - 1) / at;
      };
      const double width = fraction - 0.3;
      return width / 6 * (slope(0.3) + 4 * slope(0.3 + width / 2) + slope(fraction));
    };
    double weights = 0, sum = 0, square = 0;
    for (double count = 9000; count <= 11000; ++count) {
      double exponent = 0;
      for (auto [n, part] : {std::pair(count, share), std::pair(total - count, 1 - share)}) {
        const double density = n / (total * part);
        exponent -= n * (std::log(density) - 1) + n * excess(0.3 * density);
      }
      const double weight = std::exp(exponent - total);
      weights += weight;
      sum += weight * (count - 10000);
      square += weight * (count - 10000) * (count - 10000);
    }
    const double variance = square / weights - std::pow(sum / weights, 2);
    EXPECT_NEAR(count_variance(gas, 10000, share) / variance, 1, 2e-3);  // beyond Gauss: O(1/count)
  }
}

constexpr Gas kFluid{.dimension = 2, .fraction = 0.38};

/// Amplitude of the collisional pressure in a density wave of small amplitude, in units of n T: points of the wave are
/// counted in cells, p_c = B nu_cell^2 chi(nu_window) holds in the whole cell. Mean over places of the cells.
double pressure_amplitude(double wave_number, const CellFluid& cells) {
  constexpr int fine = 240, places = 24;
  constexpr double amplitude = 1e-5;
  const auto in_cell = [&](double low) {  // mean of cos k x over a cell, by the midpoint rule
    double sum = 0;
    for (int i = 0; i < fine; ++i) sum += std::cos(wave_number * (low + (i + 0.5) * cells.edge / fine));
    return sum / fine;
  };
  double result = 0;
  for (int place = 0; place < places; ++place) {
    const double low = place * 2 * std::numbers::pi / wave_number / places;  // of one cell
    double around = 0;
    for (double cell = -(cells.window - 1) / 2; cell <= (cells.window - 1) / 2; ++cell)
      around += in_cell(low + cell * cells.edge) / cells.window;
    const auto pressure = [&](double sign) {
      const double cell = 1 + sign * amplitude * in_cell(low);
      return 2 * kFluid.fraction * cell * cell *
             contact_value(2, kFluid.fraction * (1 + sign * amplitude * around));
    };
    result += 2 * (pressure(1) - pressure(-1)) / (2 * amplitude) * in_cell(low) / places;
  }
  return result;
}

TEST(CellStructure, IsTheResponseOfThePressureOfCells) {
  for (const CellFluid& cells : {CellFluid{5, 3}, CellFluid{2.5, 7}, CellFluid{5, 1}})
    for (double wave_number : {0.06, 0.3, 0.7}) {
      const double expected = 1 / (1 + pressure_amplitude(wave_number, cells));
      EXPECT_NEAR(cell_structure(kFluid, wave_number, cells), expected, 1e-4) << wave_number;
    }
}

TEST(CellStructure, OfLongWavesIsThatOfTheFluid) {
  for (const CellFluid& cells : {CellFluid{}, CellFluid{5, 3}})
    EXPECT_NEAR(cell_structure(kFluid, 1e-6, cells), long_wave_structure(kFluid), 1e-10);
  EXPECT_NEAR(cell_structure(kFluid, 2 * std::numbers::pi / 5, {5, 3}), 1, 1e-12);  // a cell is a wave long
}

TEST(CellCountVariance, HasTheLimitsOfTheFluidAndOfPoints) {
  for (double share : {0.5, 0.05})
    EXPECT_NEAR(cell_count_variance(kFluid, 100, share, 300, {}), count_variance(kFluid, 100, share), 1e-9);
  const Gas points{.dimension = 2, .fraction = 0};
  EXPECT_NEAR(cell_count_variance(points, 100, 0.2, 300, {5, 3}), 80, 1e-9);
  EXPECT_GT(cell_count_variance(kFluid, 100, 0.2, 100, {5, 3}), 1.3 * count_variance(kFluid, 100, 0.2));
}

/// Mueller (3.11)-(3.12), as they stand.
std::vector<double> power_spectrum(const std::vector<double>& samples) {
  const std::size_t count = samples.size();
  std::vector<double> power;
  const auto amplitude = [&](std::size_t k) {
    std::complex<double> sum = 0;
    for (std::size_t j = 0; j < count; ++j)
      sum += samples[j] * std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(j * k % count) /
                                              static_cast<double>(count));
    return std::norm(sum);
  };
  for (std::size_t k = 1; k < count / 2; ++k)
    power.push_back((amplitude(k) + amplitude(count - k)) / static_cast<double>(count * count));
  return power;
}

TEST(WhiteSpectrum, OfIndependentSamplesIsFlat) {
  std::mt19937_64 generator(7);
  std::normal_distribution<double> normal(3, 2);
  std::vector<double> mean(31, 0);
  constexpr int runs = 4000;
  for (int run = 0; run < runs; ++run) {
    std::vector<double> samples(64);
    for (double& sample : samples) sample = normal(generator);
    const std::vector<double> power = power_spectrum(samples);
    for (std::size_t k = 0; k < power.size(); ++k) mean[k] += power[k] / runs;
  }
  const double level = white_spectrum_level(4, 64);
  // Each line is exponential: one standard error is level/sqrt(runs); 4.5 of them, 31 lines.
  for (double power : mean) EXPECT_NEAR(power, level, 4.5 * level / std::sqrt(runs));
}

}  // namespace
}  // namespace sandglass::law::fluctuation_test
