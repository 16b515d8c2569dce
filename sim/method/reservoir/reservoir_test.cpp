#include "sim/method/reservoir/reservoir.hpp"

#include "sim/base/statistics.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::reservoir::reservoir_test {
namespace {

constexpr std::uint64_t kSteps = 4000;

Parameters stream_of(double speed) {
  Parameters parameters;
  parameters.number_density = 2;
  parameters.area = 3;
  parameters.stream = speed;
  parameters.thermal = 0.7;
  return parameters;
}

struct Passages {
  Mean up, down;
  std::vector<double> histogram;  ///< below -0.7, to 0, to 0.7, above
};

Passages watch(const Parameters& parameters) {
  std::vector<Plane> planes{{0, 0, {-5, -0.7, 0, 0.7, 5}}};
  Reservoir<2> reservoir(parameters, {}, &planes);
  std::vector<double> up, down;
  for (std::uint64_t step = 0; step < kSteps; ++step) {
    const double ups = planes[0].up(), downs = planes[0].down();
    reservoir.step(1.5, step);
    up.push_back(planes[0].up() - ups);
    down.push_back(planes[0].down() - downs);
  }
  EXPECT_EQ(static_cast<double>(reservoir.tally().moves), planes[0].up() + planes[0].down());
  return {mean_of_independent(up), mean_of_independent(down), planes[0].take_histogram()};
}

/// n A dt E[max(v, 0)] of a Gaussian of mean U and width 0.7, by quadrature; a Poisson number of that mean each step.
double expected_upwards(double stream, double from = 0) {
  double sum = 0;
  constexpr double step = 1e-4;
  for (double w = from + step / 2; w < 12; w += step)
    sum += step * w * std::exp(-0.5 * std::pow((w - stream) / 0.7, 2));
  return 2 * 3 * 1.5 * sum / (std::sqrt(2 * M_PI) * 0.7);
}

TEST(Reservoir, CrossingsComeAtTheRateOfTheGas) {
  for (double speed : {-1.5, 0.0, 0.4}) {
    const Passages passages = watch(stream_of(speed));
    EXPECT_NEAR(passages.up.value, expected_upwards(speed), 4.5 * passages.up.standard_error) << speed;
    EXPECT_NEAR(passages.down.value, expected_upwards(-speed), 4.5 * passages.down.standard_error) << speed;
    // Variance of a Poisson number is its mean; 4.5 standard errors of a variance are about 4.5 sqrt(2 / steps) and more.
    const double variance = kSteps * std::pow(passages.up.standard_error, 2);
    EXPECT_NEAR(variance / passages.up.value, 1, 4.5 * std::sqrt((2 + 1 / passages.up.value) / kSteps))
        << speed;
  }
}

TEST(Reservoir, VelocitiesHaveTheSignOfTheirDirection) {
  const Passages passages = watch(stream_of(0.4));
  const double fast = expected_upwards(0.4, 0.7) / expected_upwards(0.4), slow = 1 - fast;
  const double ups = passages.histogram[2] + passages.histogram[3];
  EXPECT_NEAR(ups, kSteps * passages.up.value, 1e-6);
  EXPECT_NEAR(passages.histogram[3] / ups, fast, 4.5 * std::sqrt(fast * slow / ups));
}

TEST(Reservoir, NetRateIsTheNetRate) {
  Parameters parameters = stream_of(-0.4);
  parameters.faults.net_rate = true;
  const Passages passages = watch(parameters);
  EXPECT_NEAR(passages.up.value, 2 * 3 * 1.5 * 0.4, 4.5 * passages.up.standard_error);
  EXPECT_NEAR(passages.down.value, 2 * 3 * 1.5 * 0.4, 4.5 * passages.down.standard_error);
}

/// A Maxwellian at rest has slow particles where the flux has few: erf(1/sqrt 2) = 0.683 below one thermal speed
/// against 1 - exp(-1/2) = 0.393.
TEST(Reservoir, MaxwellianHasTooManySlowOnes) {
  for (bool maxwellian : {false, true}) {
    Parameters parameters = stream_of(0);
    parameters.faults.maxwellian = maxwellian;
    const Passages passages = watch(parameters);
    const double ups = passages.histogram[2] + passages.histogram[3];
    const double slow = maxwellian ? std::erf(M_SQRT1_2) : 1 - std::exp(-0.5);
    EXPECT_NEAR(passages.histogram[2] / ups, slow, 4.5 * std::sqrt(slow * (1 - slow) / ups));
  }
}

TEST(Reservoir, DirectionsAreIndependent) {
  std::vector<Plane> planes{{0, 0, {-5, 5}}};
  Reservoir<2> reservoir(stream_of(0), {}, &planes);
  const double expected = expected_upwards(0);
  double product = 0, ups = 0, downs = 0;
  for (std::uint64_t step = 0; step < kSteps; ++step) {
    reservoir.step(1.5, step);
    product += (planes[0].up() - ups - expected) * (planes[0].down() - downs - expected);
    ups = planes[0].up();
    downs = planes[0].down();
  }
  // Two independent Poisson numbers: the product of their deviations has mean 0 and variance expected^2.
  EXPECT_NEAR(product / (kSteps * expected), 0, 4.5 / std::sqrt(kSteps));
}

TEST(Reservoir, ReplicasAndStepsDiffer) {
  std::vector<Plane> first{{0, 0, {-5, 5}}}, second = first, again = first;
  Reservoir<3> one(stream_of(0), {1, 0}, &first), two(stream_of(0), {1, 1}, &second),
      same(stream_of(0), {1, 0}, &again);
  bool differ = false;
  for (std::uint64_t step = 0; step < 20; ++step) {
    one.step(1, step);
    two.step(1, step);
    same.step(1, step);
    differ |= first[0].up() != second[0].up();
    EXPECT_EQ(first[0].up(), again[0].up());
  }
  EXPECT_TRUE(differ);
}

}  // namespace
}  // namespace sandglass::reservoir::reservoir_test
