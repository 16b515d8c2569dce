#include "validation/check/power_law.hpp"

#include "sim/base/statistics.hpp"
#include "validation/law/vibrated_bed.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace sandglass::power_law_test {
namespace {

struct Data {
  std::vector<double> x, y, error;
};

template <class Function>
Data data_of(Function function, double relative_error, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  Data data;
  for (int i = 0; i < 9; ++i) {
    data.x.push_back(0.1 * std::pow(10, i / 4.0));
    const double exact = function(data.x.back());
    data.error.push_back(relative_error * exact);
    data.y.push_back(exact + data.error.back() * normal(generator));
  }
  return data;
}

TEST(PowerLaw, FindsAnExactExponent) {
  std::mt19937_64 generator(1);
  const Data data = data_of([](double x) { return 3 * std::pow(x, 1.5); }, 1e-9, generator);
  const PowerLawFit fit = fit_power_law(data.x, data.y, data.error);
  EXPECT_NEAR(fit.exponent, 1.5, 1e-8);
  EXPECT_NEAR(std::exp(fit.log_prefactor), 3, 1e-7);
  EXPECT_NEAR(fit.curvature, 0, 1e-8);
}

TEST(PowerLaw, FindsAnExactParabola) {
  std::mt19937_64 generator(1);
  const auto parabola = [](double x) {
    return std::exp(0.3 + 1.2 * std::log(x) - 0.1 * std::pow(std::log(x), 2));
  };
  const Data data = data_of(parabola, 1e-9, generator);
  EXPECT_NEAR(fit_power_law(data.x, data.y, data.error).curvature, -0.2, 1e-7);
}

TEST(PowerLaw, ErrorsAreThoseOfManyFits) {
  std::mt19937_64 generator(2);
  double exponent = 0, curvature = 0, chi_square = 0;
  constexpr int runs = 2000;
  for (int run = 0; run < runs; ++run) {
    const Data data = data_of([](double x) { return std::pow(x, 2); }, 0.02, generator);
    const PowerLawFit fit = fit_power_law(data.x, data.y, data.error);
    exponent += std::pow((fit.exponent - 2) / fit.exponent_error, 2) / runs;
    curvature += std::pow(fit.curvature / fit.curvature_error, 2) / runs;
    chi_square += fit.chi_square / fit.degrees_of_freedom / runs;
  }
  const double error = std::sqrt(2.0 / runs);  // of the mean of a chi square
  EXPECT_NEAR(exponent, 1, 4 * error);
  EXPECT_NEAR(curvature, 1, 4 * error);
  EXPECT_NEAR(chi_square, 1, 4 * error / std::sqrt(7));
}

// The vibrated bed between its exponents 2 and 1: a line alone would call it a power law near 1.5.
TEST(PowerLaw, CurvatureTellsACrossoverFromAPower) {
  std::mt19937_64 generator(3);
  const auto rise = [](double speed) {
    law::VibratedBed bed{.layers = 5,
                         .width = 0.01,
                         .restitution = 0.9,
                         .bottom_restitution = 0.9,
                         .side_restitution = 0.9,
                         .gravity = 9.81,
                         .speed = speed};
    return law::vibrated_bed_rise(bed);
  };
  const Data data = data_of(rise, 0.03, generator);
  const PowerLawFit fit = fit_power_law(data.x, data.y, data.error);
  EXPECT_LT(fit.curvature, -5 * fit.curvature_error);
  EXPECT_GT(fit.exponent, 1.2);
  EXPECT_LT(fit.exponent, 1.8);
}

TEST(LocalExponents, AreTheSlopesBetweenPoints) {
  const std::vector<double> x{1, 4, 16}, y{2, 4, 64}, error{0.02, 0.04, 0.64};
  const LocalExponents local = local_exponents(x, y, error);
  EXPECT_DOUBLE_EQ(local.x[0], 2);
  EXPECT_DOUBLE_EQ(local.exponent[0], 0.5);
  EXPECT_DOUBLE_EQ(local.exponent[1], 2);
  EXPECT_NEAR(local.error[1], 0.01 * std::sqrt(2) / std::log(4), 1e-15);
}

}  // namespace
}  // namespace sandglass::power_law_test
