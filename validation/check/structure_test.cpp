#include "validation/check/extrapolation.hpp"
#include "validation/check/finite_size.hpp"
#include "validation/check/synthetic.hpp"
#include "validation/law/virial.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::structure_test {
namespace {

using namespace synthetic;

/// Deviation beyond the systematic part, in standard errors.
double excess(const Evidence& evidence) {
  return (std::abs(evidence.value - evidence.expected) - evidence.budget.systematic) /
         evidence.standard_error;
}

TEST(InterceptWeights, ReproducePolynomialsOfTheirDegree) {
  const std::vector<double> x = {0.05, 0.2, 0.3, 0.55, 0.7, 0.95};
  for (int degree : {0, 1, 3}) {
    const std::vector<double> weights = intercept_weights(x, degree);
    for (int power = 0; power <= degree; ++power) {
      double sum = 0;
      for (std::size_t i = 0; i < x.size(); ++i) sum += weights[i] * std::pow(x[i], power);
      EXPECT_NEAR(sum, power == 0 ? 1 : 0, 1e-10);
    }
  }
}

Record with_bins(const std::string& quantity, int bins, double low, double high, std::size_t replicas) {
  Record record = record_of({.event_driven = true}, replicas);
  for (std::size_t replica = 0; replica < replicas; ++replica) {
    Series& series = add_series(record, replica, quantity, {});
    series.quantity.shape = {static_cast<std::size_t>(bins)};
    for (int edge = 0; edge <= bins; ++edge) series.quantity.axis.push_back(low + (high - low) * edge / bins);
  }
  return record;
}

Evidence growth_of(double factor) {
  Record record = with_bins("structure-factor", 10, 0.5, 10.5, 2);
  for (Replica& replica : record.replicas) {
    add_sample(replica.series[0], 0, std::vector<double>(10, 0.4));
    add_sample(replica.series[0], 1, std::vector<double>(10, 0.4 * factor));
  }
  return run_check(find_check("structure-factor-growth"), record, {{{"least", 5}}, 0, 0, ""});
}

TEST(StructureFactorGrowth, WantsTheFactor) {
  EXPECT_EQ(growth_of(20).kind, Expectation::at_least);
  EXPECT_NEAR(growth_of(20).value, std::log(20), 1e-12);
  EXPECT_GT(excess(growth_of(1.2)), 4);
  // 36 vectors have |n| rounded to 1, 2 or 3 in the plane: 18 waves, two replicas, two samples.
  EXPECT_NEAR(growth_of(2).standard_error, std::sqrt(2 / (18.0 * 2)), 1e-12);
}

Evidence contact_of(double error) {
  Record record = with_bins("pair-correlation", 40, 0.8, 1.2, 8);
  Generator generator(41);
  std::normal_distribution<double> noise(0, 0.01);
  const double g =
      law::reference_contact_value(2, 0.25).value * fixed_count_factor(2, 0.25, 1000) * 1000 / 999;
  for (Replica& replica : record.replicas)
    for (int sample = 0; sample < 100; ++sample) {
      std::vector<double> values;
      for (int bin = 0; bin < 40; ++bin) {
        const double r = 0.805 + 0.01 * bin;
        values.push_back(r < 1 ? 0 : g * (1 + error) * std::exp(-2 * (r - 1)) + noise(generator));
      }
      add_sample(replica.series[0], sample, values);
    }
  return run_check(find_check("contact-value"), record, {});
}

TEST(ContactValue, IsFoundByContinuation) {
  EXPECT_LT(excess(contact_of(0)), 4);
  EXPECT_LT(contact_of(0).budget.systematic, 0.001 * contact_of(0).expected);
  EXPECT_GT(excess(contact_of(-0.03)), 5);
}

TEST(ContactValue, WideBinsAreRefused) {
  Record record = with_bins("pair-correlation", 4, 0.8, 1.2, 2);
  for (Replica& replica : record.replicas) add_sample(replica.series[0], 0, {0, 0, 1, 1});
  EXPECT_THROW(run_check(find_check("contact-value"), record, {}), InputError);
}

}  // namespace
}  // namespace sandglass::structure_test
