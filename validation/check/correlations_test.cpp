#include "validation/check/check.hpp"
#include "validation/check/correlations_reference.hpp"
#include "validation/check/synthetic.hpp"
#include "validation/law/impact.hpp"

#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace sandglass::correlations_test {
namespace {

using namespace synthetic;

constexpr double kParticles = 2500, kFraction = 0.245, kTau = 60;

/// Eight replicas whose ln(E/E0) falls evenly to `end` at 60 collisions per particle, apart by 0.05.
Record cooling_record(const std::string& method, double end) {
  const GasScene scene{.particles = 2500, .area_fraction = kFraction, .restitution = 0.85};
  Record record = record_of(scene, 8);
  const std::string before = "preset = \"";
  const std::size_t at = record.scene.find(before) + before.size();
  record.scene.replace(at, record.scene.find('"', at) - at, method);
  for (std::size_t replica = 0; replica < 8; ++replica) {
    const double slope = (end + 0.05 * (static_cast<double>(replica) - 3.5)) / kTau;
    Series& energy = add_series(record, replica, "energy", {});
    for (int i = 0; i <= 13; ++i) add_sample(energy, i, {1000 * std::exp(slope * 5 * i)});
    Series& collisions = add_series(record, replica, "collisions", {});
    for (int i = 0; i <= 13; ++i) add_sample(collisions, i, {kParticles / 2 * 5 * i});
  }
  return record;
}

Evidence evaluate(const std::string& check, const Record& record, law::Arguments numbers) {
  numbers["collisions"] = kTau;
  return run_check(find_check(check), record, {numbers, 0, 0, ""});
}

TEST(EnergyAtCollisions, IsHeldAgainstHardDisks) {
  const CoolingPoint& point = correlations_reference_at(kParticles, kFraction, kTau);
  const auto value = [&](double end) {
    return evaluate("energy-at-collisions", cooling_record("dsmc", end), {}).value;
  };
  EXPECT_NEAR(value(point.event_driven), point.event_driven, 1e-9);
  EXPECT_NEAR(value(point.dsmc), point.dsmc, 1e-9);
  EXPECT_NEAR(evaluate("energy-at-collisions", cooling_record("dsmc", -7), {}).expected, point.event_driven,
              0);
}

TEST(EnergyBelowHardDisks, IsTheirDistance) {
  const CoolingPoint& point = correlations_reference_at(kParticles, kFraction, kTau);
  const Evidence evidence =
      evaluate("energy-below-hard-disks", cooling_record("dsmc", point.dsmc), {{"least", 0.1}});
  EXPECT_NEAR(evidence.value, point.event_driven - point.dsmc, 1e-9);
  EXPECT_EQ(evidence.kind, Expectation::at_least);
}

TEST(ImpactCorrection, IsZeroForThePlainMethodAndOneForHardDisks) {
  const CoolingPoint& point = correlations_reference_at(kParticles, kFraction, kTau);
  EXPECT_NEAR(evaluate("impact-correction", cooling_record("dsmc", point.dsmc), {}).value, 0, 1e-9);
  EXPECT_NEAR(evaluate("impact-correction", cooling_record("dsmc", point.event_driven), {}).value, 1, 1e-9);
  EXPECT_NEAR(evaluate("impact-correction", cooling_record("hsmc", point.hsmc), {}).value, 0, 1e-9);
}

/// c from counts in the window alone; outside of it the collisions are uniform.
TEST(ImpactCoefficient, IsThatOfTheWindow) {
  Record record = record_of({.particles = 1000, .restitution = 0.85, .event_driven = true}, 8);
  for (std::size_t replica = 0; replica < 8; ++replica) {
    Series& series = add_series(record, replica, "impact-parameter", {});
    series.quantity.shape = {20};
    for (int edge = 0; edge <= 20; ++edge) series.quantity.axis.push_back(0.05 * edge);
    for (int sample = 1; sample <= 8; ++sample) {
      const double c = sample > 4 ? 0.3 : 0;
      std::vector<double> counts;
      for (int bin = 0; bin < 20; ++bin)
        counts.push_back(
            2500 * 2 *
            (law::impact_cumulative(2, c, 0.05 * (bin + 1)) - law::impact_cumulative(2, c, 0.05 * bin)));
      add_sample(series, sample, counts);
    }
  }
  const auto value = [&](double from, double to) {
    return run_check(find_check("impact-coefficient"), record, {{{"from", from}, {"to", to}}, 0, 0, ""})
        .value;
  };
  EXPECT_NEAR(value(20, 40), 0.3, 1e-3);
  EXPECT_NEAR(value(0, 20), 0, 1e-3);
}

TEST(CorrelationsReference, RepeatsTheFileAndNamesItsPoints) {
  std::ifstream file(SANDGLASS_SOURCE_DIR "/reference/source/MUL/correlations-energy.csv");
  std::string line;
  ASSERT_TRUE(std::getline(file, line));
  for (const CoolingPoint& point : correlations_reference()) {
    ASSERT_TRUE(std::getline(file, line));
    std::istringstream row(line);
    for (const double value :
         {point.particles, point.area_fraction, point.collisions, point.event_driven,
          point.event_driven_error, point.hsmc, point.hsmc_error, point.dsmc, point.dsmc_error}) {
      std::string cell;
      std::getline(row, cell, ',');
      EXPECT_EQ(std::stod(cell), value) << line;
    }
  }
  EXPECT_THROW(correlations_reference_at(2500, 0.245, 33), InputError);
  EXPECT_THROW(correlations_reference_at(2500, 0.1, 60), InputError);
}

}  // namespace
}  // namespace sandglass::correlations_test
