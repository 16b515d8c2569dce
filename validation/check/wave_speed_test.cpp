#include "validation/check/wave_speed.hpp"

#include "sim/base/error.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace sandglass::wave_speed_test {
namespace {

constexpr std::size_t kSlices = 40;

/// A hump of the given speed in slices per sample, on a fixed background and noise.
std::vector<double> moving_hump(double speed, std::size_t samples, double noise, unsigned seed = 1) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<double> density;
  for (std::size_t t = 0; t < samples; ++t)
    for (std::size_t s = 0; s < kSlices; ++s) {
      const double phase =
          2 * std::numbers::pi * (static_cast<double>(s) - speed * static_cast<double>(t)) / kSlices;
      const double background = s == 7 ? 5 : 0;
      density.push_back(std::exp(3 * std::cos(phase)) / 10 + background + noise * normal(generator));
    }
  return density;
}

TEST(WaveSpeed, IsThatOfTheWave) {
  for (double speed : {1.37, -2.61, 0.07, 17.3}) {
    const std::vector<double> density = moving_hump(speed, 1000, 0.3);
    const Mean found = wave_speed({density, kSlices, 0.5, 0.1}, 6, 10);
    EXPECT_NEAR(found.value, 5 * speed, 4 * found.standard_error);
    EXPECT_LT(found.standard_error, 0.05);
  }
}

TEST(WaveSpeed, OfRunsIsThatOfEach) {
  std::vector<std::vector<double>> density;
  std::vector<SpaceTime> runs;
  for (unsigned run = 0; run < 4; ++run) density.push_back(moving_hump(1.37, 300, 0.3, run + 1));
  for (const std::vector<double>& data : density) runs.push_back({data, kSlices, 0.5, 0.1});
  const Mean found = wave_speed(runs, 6);
  EXPECT_NEAR(found.value, 5 * 1.37, 6 * found.standard_error);
  EXPECT_LT(found.standard_error, 0.05);
  EXPECT_THROW(wave_speed(runs, 200), InputError);
}

// Waves that come and go: each lives for a while, starts anywhere, and has the same speed.
TEST(WaveSpeed, ErrorCoversTheTruth) {
  int covered = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    std::vector<double> re(3, 0.0), im(3, 0.0), density;
    for (int t = 0; t < 1200; ++t) {
      for (std::size_t k = 0; k < 3; ++k) {  // a wave number each: turned by the speed, driven, damped
        const double turn = 2 * std::numbers::pi * static_cast<double>(k + 1) * 1.3 / kSlices;
        const double x = re[k] * std::cos(turn) + im[k] * std::sin(turn),
                     y = im[k] * std::cos(turn) - re[k] * std::sin(turn);
        re[k] = 0.9 * x + normal(generator);
        im[k] = 0.9 * y + normal(generator);
      }
      for (std::size_t s = 0; s < kSlices; ++s) {
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const double phase = 2 * std::numbers::pi * static_cast<double>((k + 1) * s) / kSlices;
          sum += re[k] * std::cos(phase) - im[k] * std::sin(phase);
        }
        density.push_back(sum);
      }
    }
    const Mean found = wave_speed({density, kSlices, 1, 1}, 5, 12);
    covered += std::abs(found.value - 1.3) < 2.2 * found.standard_error ? 1 : 0;  // 95% of Student's t
  }
  EXPECT_GE(covered, 33);  // 38 are expected, 33 or fewer at a probability of 0.003
}

TEST(WaveSpeed, RefusesTooFewSamples) {
  const std::vector<double> density(kSlices * 20, 1.0);
  EXPECT_THROW(wave_speed({density, kSlices, 1, 1}, 5, 10), InputError);
}

}  // namespace
}  // namespace sandglass::wave_speed_test
