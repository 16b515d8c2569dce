#include "validation/check/finite_size.hpp"
#include "validation/check/synthetic.hpp"
#include "validation/law/sonine.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::velocity_test {
namespace {

using namespace synthetic;

double significance(const Evidence& evidence) {
  return std::abs(evidence.value - evidence.expected) / evidence.standard_error;
}

double moment(const std::vector<double>& v, int order, bool speed) {
  double sum = 0;
  for (std::size_t i = 0; i < v.size(); i += 2)
    sum += speed ? std::pow(v[i] * v[i] + v[i + 1] * v[i + 1], order / 2)
                 : (std::pow(v[i], order) + std::pow(v[i + 1], order)) / 2;
  return 2 * sum / static_cast<double>(v.size());
}

double self_normalised(const std::vector<double>& v, int order, bool speed) {
  if (speed) return moment(v, order, true) / std::pow(moment(v, 2, true), order / 2);
  double x[2] = {0, 0}, x2[2] = {0, 0};
  for (std::size_t i = 0; i < v.size(); ++i) x[i % 2] += std::pow(v[i], order), x2[i % 2] += v[i] * v[i];
  const double count = static_cast<double>(v.size()) / 2;
  return (x[0] / count / std::pow(x2[0] / count, order / 2) +
          x[1] / count / std::pow(x2[1] / count, order / 2)) /
         2;
}

/// `flatten` changes every velocity v to v (1 - flatten v^2): a distribution with too little in the tail.
Record velocity_record(double flatten) {
  GasScene scene{.particles = 50};
  scene.observe =
      "[[observe]]\nwhat = \"velocity-histogram\"\naxis = \"x\"\nrange = [-4.0, 4.0]\nbins = 32\nevery = { "
      "steps = 1 }";
  Record record = record_of(scene, 20);
  Generator generator(8);
  for (std::size_t replica = 0; replica < 20; ++replica) {
    add_series(record, replica, "moments", {"m2", "m4", "m6", "m8", "s4", "s6", "s8"});
    Series& histogram = add_series(record, replica, "velocity-histogram-x", {});
    histogram.quantity.shape = {32};
    for (int edge = 0; edge <= 32; ++edge) histogram.quantity.axis.push_back(-4 + edge / 4.0);
    add_sample(add_series(record, replica, "temperature", {"x", "y", "total"}), 0, {1, 1, 1});
    for (int sample = 0; sample < 100; ++sample) {
      std::vector<double> v = microcanonical(generator, 50);
      for (double& component : v) component *= 1 - flatten * component * component;
      std::vector<double> counts(32, 0.0), moments{1};
      for (std::size_t i = 0; i < v.size(); i += 2)
        counts[static_cast<std::size_t>(std::clamp(4 * (v[i] + 4), 0.0, 31.0))] += 1;
      for (int order : {4, 6, 8}) moments.push_back(self_normalised(v, order, false));
      for (int order : {4, 6, 8}) moments.push_back(self_normalised(v, order, true));
      add_sample(record.replicas[replica].series[0], sample, moments);
      add_sample(record.replicas[replica].series[1], sample, counts);
    }
  }
  return record;
}

TEST(VelocityMoments, FiftyParticlesAreMaxwellianAfterTheirCorrection) {
  const Evidence evidence = run_check(find_check("velocity-moments"), velocity_record(0), {});
  EXPECT_LT(significance(evidence), 4.5);
  EXPECT_LT(evidence.standard_error, 0.02);
  EXPECT_EQ(evidence.comparisons, 6);
}

TEST(VelocityMoments, SeeAThinTail) {
  EXPECT_GT(significance(run_check(find_check("velocity-moments"), velocity_record(0.01), {})), 10);
}

TEST(VelocityDistribution, FiftyParticlesAreMaxwellianAfterTheirCorrection) {
  const Evidence evidence = run_check(find_check("velocity-distribution"), velocity_record(0), {});
  EXPECT_LT(significance(evidence), 5);
  EXPECT_GT(evidence.comparisons, 10);
}

TEST(VelocityDistribution, SeesAThinTail) {
  EXPECT_GT(significance(run_check(find_check("velocity-distribution"), velocity_record(0.03), {})), 10);
}

/// Of a gas whose fourth and sixth moment are off by as much.
Evidence sonine_of(const std::string& check, double fourth_error, double sixth_error = 0) {
  const GasScene scene{.restitution = 0.8};
  Record record = record_of(scene, 10);
  Generator generator(9);
  std::normal_distribution<double> noise(0, 0.01);
  const Eigen::Vector2d a = law::sonine_coefficients<3>(2, 0.8);
  const double a2 = a[0] + fourth_error, sixth = law::sonine_sixth_moment(a) + sixth_error;
  for (std::size_t replica = 0; replica < 10; ++replica) {
    add_series(record, replica, "moments", {"m2", "m4", "m6", "m8", "s4", "s6", "s8"});
    add_series(record, replica, "collisions", {});
    for (int tau = 0; tau < 60; ++tau) {
      const bool settled = tau >= 10;  // a start that must be left out
      const double s4 = 2 * (1 + (settled ? a2 : 0.2)) * self_normalised_factor(4, 2 * 999.0);
      const double s6 = 6 * (1 + (settled ? sixth : 0.6)) * self_normalised_factor(6, 2 * 999.0);
      add_sample(record.replicas[replica].series[0], tau,
                 {1, 3, 15, 105, s4 + noise(generator), s6 + noise(generator), 24});
      add_sample(record.replicas[replica].series[1], tau, {500.0 * tau});
    }
  }
  return run_check(find_check(check), record, {});
}

TEST(SonineCoefficient, SeesTheoryAndAMaxwellian) {
  const double a2 = law::sonine_coefficients<3>(2, 0.8)[0];
  EXPECT_LT(significance(sonine_of("sonine-coefficient", 0)), 4);
  EXPECT_GT(significance(sonine_of("sonine-coefficient", -a2)), 10);
  EXPECT_LT(sonine_of("sonine-coefficient", 0).budget.systematic, 0.05 * std::abs(a2));
}

TEST(SonineSixthMoment, SeesTheoryAMaxwellianAndThatA3IsLeftOut) {
  const Eigen::Vector2d a = law::sonine_coefficients<3>(2, 0.8);
  EXPECT_LT(significance(sonine_of("sonine-sixth-moment", 0)), 4);
  EXPECT_GT(significance(sonine_of("sonine-sixth-moment", 0, -law::sonine_sixth_moment(a))), 10);
  EXPECT_GT(significance(sonine_of("sonine-sixth-moment", 0, a[1])), 8);
}

}  // namespace
}  // namespace sandglass::velocity_test
