#include "validation/check/check.hpp"
#include "validation/check/pair_reference.hpp"
#include "validation/check/synthetic.hpp"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace sandglass::pair_correlations_test {
namespace {

using namespace synthetic;

constexpr double kParticles = 2500, kFraction = 0.245, kHeat = 0.01;

void add_pairs(Record& record, std::size_t replica, const std::string& name, double inside, double tau) {
  Series& series = add_series(record, replica, name, {});
  series.quantity.shape = {40};
  for (int edge = 0; edge <= 40; ++edge) series.quantity.axis.push_back(0.25 * edge);
  std::vector<double> values(40, 7.0);  // what lies outside of the shell does not count
  for (int bin = 8; bin < 20; ++bin) values[bin] = inside;
  add_sample(series, 0, std::vector<double>(40, -3.0));
  add_sample(series, tau, values);
}

/// Eight replicas, a collision per particle and time; `factor` times the correlations of the reference, apart by 1 percent.
Record pairs_record(double factor, double tau = kPairCollisions) {
  const PairPoint& point = pair_reference_at(kParticles, kFraction, 0.85);
  Record record = record_of(
      {.particles = static_cast<int>(kParticles), .area_fraction = kFraction, .restitution = 0.85}, 8);
  const std::string before = "duration = { steps = 100 }";
  record.scene.replace(record.scene.find(before), before.size(),
                       "duration = { collisions-per-particle = 145.0 }");
  for (std::size_t replica = 0; replica < 8; ++replica) {
    const double off = factor * (1 + 0.01 * (static_cast<double>(replica) - 3.5));
    add_pairs(record, replica, "pair-correlation", 1 + off * point.density, tau);
    add_pairs(record, replica, "pair-velocity-parallel", off * point.parallel * kHeat, tau);
    add_pairs(record, replica, "pair-velocity-transverse", off * point.transverse * kHeat, tau);
    const auto times = {0.0, tau, 2 * tau};
    Series& energy = add_series(record, replica, "energy", {});
    for (const double time : times) add_sample(energy, time, {(time == tau ? kHeat : 1.0) * kParticles});
    Series& collisions = add_series(record, replica, "collisions", {});
    for (const double time : times) add_sample(collisions, time, {time * kParticles / 2});
  }
  return record;
}

Evidence evaluate(const std::string& check, const Record& record) {
  return run_check(find_check(check), record, {});
}

TEST(PairCorrelations, AreHeldAgainstHardDisksInTheShell) {
  const PairPoint& point = pair_reference_at(kParticles, kFraction, 0.85);
  for (const double factor : {1.0, 0.5}) {
    const Record record = pairs_record(factor);
    for (const auto& [check, expected, error] :
         {std::tuple{"density-correlation", point.density, point.density_error},
          {"parallel-correlation", point.parallel, point.parallel_error},
          {"transverse-correlation", point.transverse, point.transverse_error}}) {
      const Evidence evidence = evaluate(check, record);
      EXPECT_NEAR(evidence.value, factor * expected, 1e-9) << check;
      EXPECT_EQ(evidence.expected, expected) << check;
      EXPECT_EQ(evidence.budget.reference, error) << check;
      EXPECT_GT(evidence.standard_error, 0) << check;
    }
  }
}

TEST(PairCorrelations, NeedASampleAt140CollisionsPerParticle) {
  EXPECT_THROW(evaluate("density-correlation", pairs_record(1, 100)), InputError);
}

TEST(PairReference, RepeatsTheFileAndNamesItsPoints) {
  std::ifstream file(SANDGLASS_SOURCE_DIR "/reference/source/MUL/correlations-pairs.csv");
  std::string line;
  ASSERT_TRUE(std::getline(file, line));
  for (const PairPoint& point : pair_reference()) {
    ASSERT_TRUE(std::getline(file, line));
    std::istringstream row(line);
    for (const double value :
         {point.particles, point.area_fraction, point.restitution, point.density, point.density_error,
          point.parallel, point.parallel_error, point.transverse, point.transverse_error}) {
      std::string cell;
      std::getline(row, cell, ',');
      EXPECT_EQ(std::stod(cell), value) << line;
    }
  }
  EXPECT_FALSE(std::getline(file, line));
  EXPECT_THROW(pair_reference_at(1000, kFraction, 0.85), InputError);
}

}  // namespace
}  // namespace sandglass::pair_correlations_test
