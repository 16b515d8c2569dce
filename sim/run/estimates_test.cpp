#include "sim/run/estimates.hpp"

#include "sim/base/random.hpp"

#include <cmath>

#include <boost/random/normal_distribution.hpp>
#include <gtest/gtest.h>

namespace sandglass::estimates_test {
namespace {

Replica replica_of(const std::vector<double>& values, std::size_t components = 1) {
  Series series;
  series.quantity = {"thing", "length", "a thing", {components}, {}, {}, ""};
  series.value = values;
  for (std::size_t i = 0; i < values.size() / components; ++i) {
    series.step.push_back(i);
    series.time.push_back(0.5 * static_cast<double>(i));
  }
  return {1, {series}, {}};
}

/// x' = memory x + noise, unit variance about `mean`: (1 + memory)/(1 - memory) samples count as one.
std::vector<double> autoregressive(double mean, double memory, std::size_t count, std::uint64_t index) {
  Random random(StreamKey(12, Purpose::velocities, 0, 0), index);
  boost::random::normal_distribution<double> normal;
  std::vector<double> values;
  double x = normal(random);
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(mean + x);
    x = memory * x + std::sqrt(1 - memory * memory) * normal(random);
  }
  return values;
}

TEST(Estimate, OneReplicaKnowsItsCorrelationInTime) {
  constexpr std::size_t kSamples = 100'000;
  const auto estimates = estimate({replica_of(autoregressive(3, 0.9, kSamples, 0))}, {});
  ASSERT_EQ(estimates.size(), 1u);
  const double error = std::sqrt(19.0 / kSamples);
  EXPECT_NEAR(estimates[0].standard_error[0] / error, 1, 0.1);
  EXPECT_NEAR(estimates[0].value[0], 3, 4.5 * error);
  EXPECT_NEAR(estimates[0].effective_samples / (kSamples / 19.0), 1, 0.2);
}

TEST(Estimate, SeveralReplicasKnowTheirScatter) {
  const auto estimates = estimate({replica_of({1, 1, 1}), replica_of({2, 2, 2}), replica_of({6, 6, 6})}, {});
  EXPECT_DOUBLE_EQ(estimates[0].value[0], 3);
  EXPECT_DOUBLE_EQ(estimates[0].standard_error[0], std::sqrt((4 + 1 + 9) / 2.0 / 3));
  EXPECT_DOUBLE_EQ(estimates[0].effective_samples, 3);
}

TEST(Estimate, KeepsComponentsApart) {
  const auto estimates = estimate({replica_of({1, 10, 3, 30}, 2), replica_of({2, 20, 4, 40}, 2)}, {});
  EXPECT_EQ(estimates[0].value, (std::vector<double>{2.5, 25}));
  EXPECT_DOUBLE_EQ(estimates[0].standard_error[1], 5);
}

/// 0, 2, 4, 12 at times 0, 0.5, 1, 1.5: 12 in 1.5.
TEST(Estimate, CumulativeSeriesGiveTheirRate) {
  const auto estimates = estimate({replica_of({0, 2, 4, 12})}, {"thing"});
  EXPECT_EQ(estimates[0].quantity.name, "thing-rate");
  EXPECT_EQ(estimates[0].quantity.units, "length time^-1");
  EXPECT_DOUBLE_EQ(estimates[0].value[0], 8);
}

/// Increments that are independent: the error of the rate is that of their sum.
TEST(Estimate, RateHasTheErrorOfItsIncrements) {
  constexpr std::size_t kSamples = 20'000;
  std::vector<double> sum{0};
  for (double increment : autoregressive(3, 0, kSamples, 1)) sum.push_back(sum.back() + increment);
  const auto estimates = estimate({replica_of(sum)}, {"thing"});
  EXPECT_NEAR(estimates[0].value[0], 6, 4.5 * 2 / std::sqrt(kSamples));
  EXPECT_NEAR(estimates[0].standard_error[0] / (2 / std::sqrt(kSamples)), 1, 0.1);
}

/// 3 + 50 e^(-t/10) in each of four replicas, in the second of two components.
std::vector<Replica> relaxing(std::size_t samples) {
  std::vector<Replica> replicas;
  for (std::uint64_t index = 0; index < 4; ++index) {
    const std::vector<double> even = autoregressive(1, 0, samples, 2 * index),
                              noise = autoregressive(3, 0, samples, 2 * index + 1);
    std::vector<double> values;
    for (std::size_t i = 0; i < samples; ++i) {
      values.push_back(even[i]);
      values.push_back(noise[i] + 50 * std::exp(-0.05 * static_cast<double>(i)));
    }
    replicas.push_back(replica_of(values, 2));
  }
  return replicas;
}

TEST(Estimate, LeavesATransientOut) {
  const auto estimates = estimate(relaxing(1000), {});
  EXPECT_GE(estimates[0].start_time, 40);
  EXPECT_LE(estimates[0].start_time, 250);
  EXPECT_FALSE(estimates[0].drifts);
  EXPECT_NEAR(estimates[0].value[1], 3, 5 / std::sqrt(3000.0));
}

TEST(Estimate, SaysWhenNoPartOfTheRunIsSteady) { EXPECT_TRUE(estimate(relaxing(60), {})[0].drifts); }

TEST(Estimate, LeavesOutWhatWasNeverMeasured) {
  EXPECT_TRUE(estimate({replica_of({})}, {}).empty());
  EXPECT_TRUE(estimate({replica_of({5})}, {"thing"}).empty());
  EXPECT_TRUE(estimate({}, {}).empty());
}

TEST(Estimate, OneSampleHasNoKnownError) {
  const auto estimates = estimate({replica_of({5})}, {});
  EXPECT_EQ(estimates[0].value[0], 5);
  EXPECT_TRUE(std::isnan(estimates[0].standard_error[0]));
}

}  // namespace
}  // namespace sandglass::estimates_test
