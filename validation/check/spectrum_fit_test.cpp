#include "validation/check/spectrum_fit.hpp"

#include "sim/base/error.hpp"
#include "validation/law/fluctuation.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace sandglass::spectrum_fit_test {
namespace {

using std::numbers::pi;

std::vector<double> noise(std::size_t count, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  std::vector<double> samples(count);
  for (double& sample : samples) sample = normal(generator);
  return samples;
}

/// Lines drawn around f^exponent, as those of a Gaussian process are.
Spectrum drawn(double exponent, std::size_t lines, std::mt19937_64& generator, double averages = 1) {
  std::gamma_distribution<double> gamma(averages, 1 / averages);
  Spectrum spectrum;
  spectrum.averages = averages;
  for (std::size_t k = 1; k <= lines; ++k) {
    const auto f = static_cast<double>(k);
    spectrum.frequency.push_back(f);
    spectrum.power.push_back(gamma(generator) * std::pow(f, exponent));
  }
  return spectrum;
}

TEST(PowerSpectrum, IsTheSumOfItsDefinition) {
  std::mt19937_64 generator(1);
  for (std::size_t count : {12, 15}) {
    const std::vector<double> samples = noise(count, generator);
    const Spectrum spectrum = power_spectrum(samples, 0.5);
    ASSERT_EQ(spectrum.power.size(), (count - 1) / 2);
    const auto total = static_cast<double>(count);
    for (std::size_t k = 1; k <= spectrum.power.size(); ++k) {
      std::complex<double> sum = 0;
      for (std::size_t j = 0; j < count; ++j)
        sum += samples[j] * std::polar(1.0, 2 * pi * static_cast<double>(j * k) / total);
      EXPECT_NEAR(spectrum.power[k - 1], 2 * std::norm(sum) / (total * total), 1e-14);
      EXPECT_DOUBLE_EQ(spectrum.frequency[k - 1], static_cast<double>(k) / (total * 0.5));
    }
  }
}

TEST(PowerSpectrum, OfNoiseHasTheWhiteLevel) {
  std::mt19937_64 generator(2);
  std::vector<Spectrum> spectra;
  for (int i = 0; i < 400; ++i) spectra.push_back(power_spectrum(noise(128, generator), 1));
  const SpectrumFit fit = fit_spectrum(average(spectra), {0, 1});
  EXPECT_NEAR(fit.exponent, 0, 4 * fit.exponent_error);
  EXPECT_NEAR(fit.power_at(0.2) / law::white_spectrum_level(1, 128), 1, 4 / std::sqrt(400.0 * 63));
}

TEST(SpectrumFit, ErrorsAreThoseOfManyFits) {
  std::mt19937_64 generator(3);
  constexpr int runs = 500;
  for (double averages : {1.0, 20.0}) {
    double exponent = 0, curvature = 0, bias = 0;
    for (int run = 0; run < runs; ++run) {
      const SpectrumFit fit = fit_spectrum(drawn(-4.0 / 3, 400, generator, averages), {4, 400});
      exponent += std::pow((fit.exponent + 4.0 / 3) / fit.exponent_error, 2) / runs;
      curvature += std::pow(fit.curvature / fit.curvature_error, 2) / runs;
      bias += (fit.exponent + 4.0 / 3) / fit.exponent_error / runs;
    }
    EXPECT_NEAR(exponent, 1, 5 * std::sqrt(2.0 / runs)) << averages;
    EXPECT_NEAR(curvature, 1, 5 * std::sqrt(2.0 / runs)) << averages;
    EXPECT_NEAR(bias, 0, 5 / std::sqrt(runs)) << averages;
  }
}

TEST(SpectrumFit, LeavesOutAPeakAndItsMultiples) {
  std::mt19937_64 generator(4);
  Spectrum spectrum = drawn(-4.0 / 3, 400, generator);
  for (std::size_t line : {60, 120, 180}) {
    spectrum.power[line - 1] *= 200;
    spectrum.power[line] *= 50;
  }
  const SpectrumFit fit = fit_spectrum(spectrum, {4, 400});
  ASSERT_FALSE(fit.peaks.empty());
  EXPECT_NEAR(fit.exponent, -4.0 / 3, 4 * fit.exponent_error);
  for (double peak : fit.peaks) EXPECT_LE(std::abs(peak / 60 - std::round(peak / 60)), 1 / 60.0 + 1e-9);
  const SpectrumFit blind = fit_spectrum(spectrum, {4, 400, 3, 0});
  EXPECT_GT(blind.scatter, 20 * fit.scatter);
}

TEST(SpectrumFit, SeesPeaksByChanceAsRarelyAsAsked) {
  std::mt19937_64 generator(5);
  int alarms = 0;
  for (int run = 0; run < 500; ++run)
    alarms += fit_spectrum(drawn(-1, 300, generator), {1, 300, 3, 0.05}).peaks.empty() ? 0 : 1;
  EXPECT_LT(alarms, 25 + 4 * 5);  // binomial
}

// A process with a correlation time: white below the corner, f^-2 above. The curvature shows it.
TEST(SpectrumFit, CurvatureTellsARelaxationFromAPower) {
  std::mt19937_64 generator(6);
  Spectrum spectrum = drawn(0, 400, generator, 4);
  for (std::size_t i = 0; i < 400; ++i) spectrum.power[i] /= 1 + std::pow(spectrum.frequency[i] / 40, 2);
  const SpectrumFit fit = fit_spectrum(spectrum, {4, 400, 3, 0});
  EXPECT_LT(fit.curvature, -5 * fit.curvature_error);
}

TEST(SpectrumFit, FindsTheExponentOfASeries) {
  std::mt19937_64 generator(7);
  std::normal_distribution<double> normal;
  std::vector<Spectrum> spectra;
  for (int run = 0; run < 10; ++run) {  // waves of random amplitude and phase that fit into the series
    std::vector<double> samples(512, 0.0);
    for (std::size_t k = 1; k < 256; ++k) {
      const double size = std::pow(static_cast<double>(k), -2.0 / 3);
      const double cosine = size * normal(generator), sine = size * normal(generator);
      for (std::size_t j = 0; j < 512; ++j) {
        const double phase = 2 * pi * static_cast<double>(k * j % 512) / 512;
        samples[j] += cosine * std::cos(phase) + sine * std::sin(phase);
      }
    }
    spectra.push_back(power_spectrum(samples, 1));
  }
  const SpectrumFit fit = fit_spectrum(average(spectra), {0, 1});
  EXPECT_NEAR(fit.exponent, -4.0 / 3, 4 * fit.exponent_error);
}

TEST(SpectrumFit, RefusesARangeWithTooFewLines) {
  std::mt19937_64 generator(8);
  EXPECT_THROW(fit_spectrum(drawn(0, 100, generator), {50, 55}), InputError);
}

}  // namespace
}  // namespace sandglass::spectrum_fit_test
