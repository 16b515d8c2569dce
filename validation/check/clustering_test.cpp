#include "validation/check/clustering_reference.hpp"
#include "validation/check/synthetic.hpp"
#include "validation/law/haff.hpp"

#include <cmath>
#include <fstream>
#include <functional>

#include <gtest/gtest.h>

namespace sandglass::clustering_test {
namespace {

using namespace synthetic;

/// Energy excess(t/t0) times Haff's law in four replicas that scatter by `noise` as a whole.
Record clustering_record(const std::function<double(double)>& excess, double end, double noise = 0.002) {
  const GasScene scene{.particles = 2500, .restitution = 0.8};
  Record record = record_of(scene, 4);
  const double scale = law::haff_time_scale(scene.gas());
  for (std::size_t replica = 0; replica < 4; ++replica) {
    Series& energy = add_series(record, replica, "energy", {});
    const double factor = 1 + noise * (static_cast<double>(replica) - 1.5);
    for (double time = 0; time <= end; time += 0.05)
      add_sample(energy, time * scale,
                 {2500 * law::haff_energy_ratio(time, 1) * (time > 0 ? factor * excess(time) : 1)});
  }
  return record;
}

const Settings kDeparture{{{"part", 0.1}, {"expected", 2}}, 0, 0, ""};

TEST(HaffDeparture, FindsTheTime) {
  const auto excess = [](double time) { return 1 + 0.05 * time; };
  const Evidence evidence =
      run_check(find_check("haff-departure"), clustering_record(excess, 20), kDeparture);
  EXPECT_NEAR(evidence.value, 2, 0.001);
  EXPECT_EQ(evidence.expected, 2);
  // 1.1 is 0.05 t away, and the replicas scatter by 0.002 sqrt(5/3) about their mean.
  EXPECT_NEAR(evidence.standard_error, 1.1 * 0.002 * std::sqrt(5.0 / 3 / 4) / 0.05, 0.002);
  ASSERT_EQ(evidence.figures.size(), 1U);
}

TEST(HaffDeparture, GasThatStaysOnHaffHasNoTime) {
  const auto excess = [](double) { return 1.0; };
  const Evidence evidence = run_check(find_check("haff-departure"), clustering_record(excess, 5), kDeparture);
  EXPECT_TRUE(std::isnan(evidence.value));
}

TEST(EventDrivenParting, FindsTheTime) {
  const auto excess = [](double time) { return clustering_excess(time) * (1 - 0.01 * time); };
  const Evidence evidence = run_check(find_check("event-driven-parting"), clustering_record(excess, 20),
                                      {{{"part", 0.08}, {"expected", 10}}, 0, 0, ""});
  EXPECT_NEAR(evidence.value, 8, 0.01);
}

Evidence energy_of(double error) {
  const auto excess = [error](double time) { return clustering_excess(time) * (1 + error); };
  return run_check(find_check("clustering-energy"), clustering_record(excess, 20),
                   {{{"last", 10}}, 0, 0, ""});
}

TEST(ClusteringEnergy, SeesWhoLosesMore) {
  EXPECT_NEAR(energy_of(0).value, 1, 1e-3);
  const Evidence wrong = energy_of(-0.05);
  EXPECT_NEAR(wrong.value, 0.95, 1e-3);
  EXPECT_GT(wrong.comparisons, 2);
  EXPECT_GT(0.05, 6 * std::hypot(wrong.standard_error, wrong.budget.reference));
}

/// N = 2500 at t/t0 = 0.2: E/E0 = 1.006/1.44.
TEST(ClusteringEnergy, PinnedMeanVelocityIsAllowedFor) {
  const Evidence evidence = energy_of(-0.05);
  ASSERT_NE(evidence.summary.find("worst at t/t0 = 0.2"), std::string::npos) << evidence.summary;
  EXPECT_NEAR(evidence.budget.systematic, 1 / (2500 * 1.006 / 1.44), 1e-6);
}

TEST(ClusteringEnergy, RunThatEndsBeforeTheComparisonIsNotANumber) {
  const auto excess = [](double time) { return clustering_excess(time); };
  const Evidence evidence =
      run_check(find_check("clustering-energy"), clustering_record(excess, 3), {{{"last", 10}}, 0, 0, ""});
  EXPECT_TRUE(std::isnan(evidence.value));
}

double excluded(const std::vector<double>& pairs) {
  Record record = record_of({.event_driven = true}, 1);
  Series& series = add_series(record, 0, "pair-correlation", {});
  series.quantity.shape = {4};
  series.quantity.axis = {0, 0.5, 1, 1.5, 2};
  add_sample(series, 0, {9, 9, 9, 9});
  add_sample(series, 1, pairs);
  return run_check(find_check("excluded-volume"), record, {}).value;
}

TEST(ExcludedVolume, CountsPairsBelowContactAtTheEnd) {
  EXPECT_EQ(excluded({0, 0, 3, 1}), 0);
  EXPECT_DOUBLE_EQ(excluded({1, 1, 1, 1}), 1);
  EXPECT_DOUBLE_EQ(excluded({0, 1, 1, 1}), 0.75);  // area of the ring over that of the disk
}

/// The numbers of the file that they were copied from: E/E0 of the event-driven runs.
TEST(ClusteringReference, IsWhatTheFileSays) {
  std::ifstream file(SANDGLASS_SOURCE_DIR "/reference/source/MUL/clustering-energy.csv");
  std::size_t found = 0;
  for (std::string line; std::getline(file, line);) {
    double time = 0, energy = 0, error = 0;
    int runs = 0;
    if (std::sscanf(line.c_str(), "event-driven,%lf,%lf,%lf,%d", &time, &energy, &error, &runs) != 4)
      continue;
    for (const ClusteringPoint& point : clustering_reference()) {
      if (point.time != time) continue;
      ++found;
      EXPECT_NEAR(point.excess * law::haff_energy_ratio(time, 1), energy, 1e-4 * energy) << time;
      EXPECT_NEAR(point.standard_error * law::haff_energy_ratio(time, 1), error, 1e-4 * energy) << time;
    }
  }
  EXPECT_EQ(found + 1, clustering_reference().size());  // and time zero
}

TEST(ClusteringReference, StartsOnHaffAndInterpolatesInTheLogarithm) {
  const std::vector<ClusteringPoint>& points = clustering_reference();
  for (const ClusteringPoint& point : points)
    EXPECT_NEAR(clustering_excess(point.time), point.excess, 1e-12) << point.time;
  EXPECT_EQ(clustering_excess(0), 1);
  const ClusteringPoint &a = points[points.size() - 2], &b = points.back();
  const double middle = std::sqrt((1 + a.time) * (1 + b.time)) - 1;
  EXPECT_NEAR(clustering_excess(middle), std::sqrt(a.excess * b.excess), 1e-12);
  EXPECT_THROW(clustering_excess(b.time + 1), InputError);
  EXPECT_THROW(clustering_excess(-1), InputError);
}

}  // namespace
}  // namespace sandglass::clustering_test
