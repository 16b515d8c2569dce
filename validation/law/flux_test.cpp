#include "validation/law/flux.hpp"

#include "validation/law/quadrature.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace sandglass::law::flux_test {
namespace {

using std::numbers::pi;

constexpr double kMass = 1.3, kTemperature = 0.02, kDensity = 0.8;
const double kRoot = std::sqrt(kMass / (2 * kTemperature));

/// A stream whose velocity is s in units of sqrt(2T/m).
Stream stream(double s) { return {kDensity, kMass, kTemperature, s / kRoot}; }

/// Velocity beyond which less than 1e-17 of the forward crossings lie.
double far(double s) { return ((s > 0 ? s : 0) + 7) / kRoot; }

double maxwellian(double velocity, double mean) {
  const double w = kRoot * (velocity - mean);
  return kRoot / std::sqrt(pi) * std::exp(-w * w);
}

const auto kStreams = {-20.0, -5.0, -2.1, -2.0, -1.9, -0.3, 0.0, 0.4, 3.0, 20.0};

TEST(Flux, RatesAreTheMaxwellianIntegrals) {
  for (double s : kStreams) {
    const double mean = s / kRoot;
    const double forward = quadrature::integral([=](double w) { return w * maxwellian(w, mean); }, 0, far(s));
    EXPECT_NEAR(flux_forward(stream(s)) / (kDensity * forward), 1, 1e-9) << s;
    EXPECT_NEAR(flux_backward(stream(-s)) / (kDensity * forward), 1, 1e-9) << s;
  }
}

TEST(Flux, ForwardLessBackwardIsDensityTimesVelocity) {
  for (double s : kStreams)
    EXPECT_NEAR(flux_forward(stream(s)) - flux_backward(stream(s)), flux_net(stream(s)), 1e-14) << s;
  EXPECT_DOUBLE_EQ(flux_net(stream(1)), kDensity / kRoot);
}

TEST(Flux, DensitiesIntegrateToOne) {
  for (double s : kStreams) {
    EXPECT_NEAR(quadrature::integral([=](double w) { return flux_density_forward(stream(s), w); }, 0, far(s)),
                1, 1e-9)
        << s;
    EXPECT_NEAR(
        quadrature::integral([=](double w) { return flux_density_backward(stream(s), w); }, -far(-s), 0), 1,
        1e-9)
        << s;
  }
}

TEST(Flux, DensityIsTheMaxwellianTimesTheVelocity) {
  for (double s : {-1.5, 0.0, 2.0})
    for (double w : {0.05, 0.2}) {
      const Stream gas = stream(s);
      EXPECT_NEAR(flux_density_forward(gas, w) * flux_forward(gas),
                  kDensity * w * maxwellian(w, gas.velocity), 1e-12);
      EXPECT_EQ(flux_density_forward(gas, -w), 0);
      EXPECT_EQ(flux_density_backward(gas, w), 0);
    }
}

TEST(Flux, CumulativeIsTheIntegralOfTheDensity) {
  for (double s : kStreams)
    for (double quantile : {0.05, 0.5, 2.0}) {
      const double w = quantile * flux_mean_forward(stream(s));
      const double below =
          quadrature::integral([=](double v) { return flux_density_forward(stream(s), v); }, 0, w);
      EXPECT_NEAR(flux_cumulative_forward(stream(s), w), below, 1e-10) << s;
      EXPECT_NEAR(flux_cumulative_backward(stream(-s), -w), 1 - below, 1e-10) << s;
    }
}

TEST(Flux, MeanIsTheFirstMoment) {
  for (double s : kStreams) {
    const double mean =
        quadrature::integral([=](double w) { return w * flux_density_forward(stream(s), w); }, 0, far(s));
    EXPECT_NEAR(flux_mean_forward(stream(s)) / mean, 1, 1e-9) << s;
    EXPECT_DOUBLE_EQ(flux_mean_backward(stream(-s)), -flux_mean_forward(stream(s)));
  }
}

// Baryshev (3.40) and (3.47) as printed, errata applied: the stable forms must say the same.
TEST(Flux, CumulativeIsBaryshevsFormula) {
  const auto f = [](double x0, double x1, int sign) {
    return std::exp(-x1 * x1) + std::sqrt(pi) * x0 * (std::erf(x1) + sign);
  };
  for (double s : {-1.0, -0.2, 0.0, 1.5})
    for (double y : {0.1, 1.0, 2.5}) {
      EXPECT_NEAR(flux_cumulative_forward(stream(s), y / kRoot), 1 - f(s, s - y, 1) / f(s, s, 1), 1e-13);
      EXPECT_NEAR(flux_cumulative_backward(stream(s), -y / kRoot), f(s, s + y, -1) / f(s, s, -1), 1e-13);
    }
}

// (3.20)-(3.22) and the first terms of the asymptotic series of f.
TEST(Flux, HasTheLimitsOfFastAndStandingStreams) {
  EXPECT_NEAR(flux_forward(stream(20)) / flux_net(stream(20)), 1, 1e-15);
  EXPECT_DOUBLE_EQ(flux_forward(stream(0)), kDensity / (2 * std::sqrt(pi) * kRoot));
  const double x = 20;
  const double series = std::exp(-x * x) / (2 * x * x) * (1 - 1.5 / (x * x) + 3.75 / std::pow(x, 4));
  EXPECT_NEAR(flux_forward(stream(-x)) / (flux_forward(stream(0)) * series), 1, 1e-6);
}

TEST(Flux, StaysFiniteFarAgainstTheStream) {
  for (double s : {-30.0, -1e3, -1e6}) {
    EXPECT_EQ(flux_forward(stream(s)), 0);  // exp(-900) is below the smallest double
    EXPECT_NEAR(flux_mean_forward(stream(s)) * kRoot * -s, 1, 2 / (s * s));
    const double w = std::log(2) / -s / kRoot;  // w exp(-2|s|w) is left: its distribution is elementary
    EXPECT_NEAR(flux_cumulative_forward(stream(s), w), 1 - (1 + 2 * std::log(2)) / 4, 2 / (s * s));
    EXPECT_NEAR(flux_density_forward(stream(s), w) / (-s * kRoot * std::log(2)), 1, 2 / (s * s));
  }
}

}  // namespace
}  // namespace sandglass::law::flux_test
