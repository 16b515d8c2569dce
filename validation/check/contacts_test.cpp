#include "validation/check/synthetic.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::contacts_test {
namespace {

using namespace synthetic;

double significance(const Evidence& evidence) {
  return std::abs(evidence.value - evidence.expected) / evidence.standard_error;
}

/// Impact parameters with density 1 + tilt (2b - 1): mean 1/2 + tilt/6. `drift` is added to the tilt from the first
/// sample to the last.
Record impact_record(double tilt, double drift = 0, double restitution = 1) {
  Record record = record_of({.restitution = restitution, .event_driven = true}, 4);
  Generator generator(21);
  std::uniform_real_distribution<double> uniform;
  for (std::size_t replica = 0; replica < 4; ++replica) {
    Series& series = add_series(record, replica, "impact-parameter", {});
    series.quantity.shape = {20};
    for (int edge = 0; edge <= 20; ++edge) series.quantity.axis.push_back(edge / 20.0);
    for (int sample = 0; sample < 30; ++sample) {
      const double now = tilt + drift * sample / 29;
      std::vector<double> counts(20, 0.0);
      for (int i = 0; i < 2000; ++i) {
        double b = uniform(generator);
        while (2 * uniform(generator) > 1 + now * (2 * b - 1)) b = uniform(generator);
        counts[static_cast<std::size_t>(20 * b)] += 1;
      }
      add_sample(series, sample, counts);
    }
  }
  return record;
}

TEST(ImpactParameter, EvenContactsPassATiltDoesNot) {
  const CheckInfo& check = find_check("impact-parameter");
  EXPECT_LT(significance(run_check(check, impact_record(0), {})), 4.5);
  EXPECT_EQ(run_check(check, impact_record(0), {}).comparisons, 20);
  EXPECT_GT(significance(run_check(check, impact_record(0.1), {})), 5);
}

TEST(ImpactParameter, IsHeldAgainstDissipativeGasesOnlyNearElastic) {
  const CheckInfo& check = find_check("impact-parameter");
  EXPECT_TRUE(check.applies(Subject(impact_record(0, 0, 0.9)).scene()));
  EXPECT_FALSE(check.applies(Subject(impact_record(0, 0, 0.8)).scene()));
}

TEST(ImpactParameterGrazing, WantsAnExcess) {
  const CheckInfo& check = find_check("impact-parameter-grazing");
  const Settings settings{{{"least", 0.01}}, 0, 0.005, ""};
  const Evidence grazing = run_check(check, impact_record(0.12), settings);
  EXPECT_EQ(grazing.kind, Expectation::at_least);
  EXPECT_EQ(grazing.expected, 0.01);
  EXPECT_GT(grazing.value, 0.015) << "what was measured, not the bound";
  EXPECT_LT(grazing.standard_error, 0.001);
  EXPECT_GT(significance(run_check(check, impact_record(0), settings)), 10);
  EXPECT_GT(significance(run_check(check, impact_record(-0.12), settings)), 10);
  EXPECT_THROW(run_check(check, impact_record(0), {}), InputError);
}

TEST(ImpactParameterDrift, WantsAChange) {
  const CheckInfo& check = find_check("impact-parameter-drift");
  const Settings settings{{{"least", 0.01}}, 0, 0.005, ""};
  const Evidence drifting = run_check(check, impact_record(0, 0.3), settings);
  EXPECT_EQ(drifting.kind, Expectation::at_least);
  EXPECT_GT(drifting.value, 0.015);
  EXPECT_GT(significance(run_check(check, impact_record(0.3, 0), settings)), 4);
}

Evidence overlap_of(double deepest, std::size_t where = 1) {
  Record record = record_of({.event_driven = true}, 2);
  for (std::size_t replica = 0; replica < 2; ++replica) {
    Series& series = add_series(record, replica, "overlap", {});
    add_sample(series, 0, {0});
    add_sample(series, 1, {replica == where ? deepest : 1e-15});
  }
  return run_check(find_check("overlap"), record, {});
}

TEST(Overlap, RoundingIsAllowedPenetrationIsNot) {
  EXPECT_LT(overlap_of(1e-12).value, overlap_of(1e-12).expected);
  EXPECT_EQ(overlap_of(1e-6).value, 1e-6);
  EXPECT_GT(overlap_of(1e-6).value, overlap_of(1e-6).expected);
  EXPECT_EQ(expectation_text(overlap_of(1e-6)), "at most 1e-09");
  EXPECT_TRUE(std::isnan(overlap_of(std::nan("")).value));
  EXPECT_TRUE(std::isnan(overlap_of(std::nan(""), 0).value)) << "whatever comes after it";
}

}  // namespace
}  // namespace sandglass::contacts_test
