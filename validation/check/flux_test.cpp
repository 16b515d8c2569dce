#include "validation/law/flux.hpp"

#include "validation/check/synthetic.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::flux_test {
namespace {

using namespace synthetic;

constexpr double edge = 56.04991216397928;  // sqrt(1000 pi/4/0.25)

struct Planted {
  double rate = 1;          ///< factor on both fluxes
  bool maxwellian = false;  ///< crossing velocities as in the gas, not as in the flux
};

double probability(const law::Stream& stream, double low, double high, const Planted& planted) {
  const bool up = low >= 0;
  if (planted.maxwellian) {
    const auto below = [&](double w) { return 0.5 * std::erfc((stream.velocity - w) / std::sqrt(2.0)); };
    const double all = up ? 1 - below(0) : below(0);
    return (below(high) - below(low)) / all;
  }
  return up ? law::flux_cumulative_forward(stream, high) - law::flux_cumulative_forward(stream, low)
            : law::flux_cumulative_backward(stream, high) - law::flux_cumulative_backward(stream, low);
}

Record crossing_record(double velocity, const Planted& planted) {
  GasScene scene;
  scene.initial = "velocity = [" + std::to_string(velocity) + ", 0.0]";
  scene.observe =
      "[[observe]]\nwhat = \"crossings\"\naxis = \"x\"\nposition = 10.0\nrange = [-5.0, 5.0]\nbins = 40\n"
      "every = { steps = 1 }";
  Record record = record_of(scene, 1);
  const law::Stream stream{1000 / (edge * edge), 1, 1, velocity};
  const double up = planted.rate * law::flux_forward(stream) * edge * 100;
  const double down = planted.rate * law::flux_backward(stream) * edge * 100;
  add_series(record, 0, "crossings", {});
  Series& histogram = record.replicas[0].series[0];
  histogram.quantity.shape = {40};
  for (int i = 0; i <= 40; ++i) histogram.quantity.axis.push_back(-5 + i / 4.0);
  add_series(record, 0, "crossing-count", {"up", "down"});
  Generator generator(12);
  double total[2] = {0, 0};
  add_sample(record.replicas[0].series[0], 0, std::vector<double>(40, 0.0));
  add_sample(record.replicas[0].series[1], 0, {0, 0});
  for (int sample = 1; sample <= 60; ++sample) {
    std::vector<double> counts;
    for (int i = 0; i < 40; ++i) {
      const double low = -5 + i / 4.0;
      const double mean = (low < 0 ? down : up) * probability(stream, low, low + 0.25, planted);
      counts.push_back(mean > 0 ? std::poisson_distribution<int>(mean)(generator) : 0);
      total[low < 0] += counts.back();
    }
    add_sample(record.replicas[0].series[0], 100 * sample, counts);
    add_sample(record.replicas[0].series[1], 100 * sample, {total[0], total[1]});
  }
  return record;
}

double significance(const std::string& check, double velocity, const Planted& planted) {
  const Evidence evidence = run_check(find_check(check), crossing_record(velocity, planted), {});
  return std::abs(evidence.value - evidence.expected) / evidence.standard_error;
}

TEST(Flux, SeesTheLawInBothDirections) {
  for (double velocity : {0.5, 0.1, -0.3})
    for (const char* check :
         {"flux-rate-up", "flux-rate-down", "flux-distribution-up", "flux-distribution-down"})
      EXPECT_LT(significance(check, velocity, {}), 5) << check << " at U = " << velocity;
}

TEST(Flux, SeesAWrongRate) {
  EXPECT_GT(significance("flux-rate-up", 0.5, {.rate = 1.05}), 10);
  EXPECT_GT(significance("flux-rate-down", 0.5, {.rate = 0.85}), 10);
}

TEST(Flux, SeesTheVelocitiesOfTheGasInsteadOfTheFlux) {
  EXPECT_GT(significance("flux-distribution-up", 0.1, {.maxwellian = true}), 10);
  EXPECT_GT(significance("flux-distribution-down", -0.3, {.maxwellian = true}), 10);
}

}  // namespace
}  // namespace sandglass::flux_test
