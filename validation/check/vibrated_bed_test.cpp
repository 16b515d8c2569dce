#include "validation/check/vibrated_bed.hpp"

#include "validation/check/check.hpp"
#include "validation/check/power_law.hpp"
#include "validation/check/synthetic.hpp"
#include "validation/check/vibrated_bed_reference.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

// Each check sees data that are right, and data that are off.

namespace sandglass::vibrated_bed_test {
namespace {

using namespace synthetic;

std::string bed_scene(double restitution, double speed, double wall = 1) {
  const std::string r = std::to_string(restitution), w = std::to_string(wall);
  return "[run]\nduration = { time = 100.0 }\n[domain]\ndimension = 2\nsize = [0.01, 1.0]\n"
         "sides = { x = \"specular\", y = \"specular\" }\n"
         "[[wall]]\nside = \"y-low\"\nrestitution = " +
         w + "\nfrequency = 100.0\namplitude = " + std::to_string(speed / 628.3185307) +
         "\n[[wall]]\nside = \"x-low\"\nrestitution = " + w +
         "\n[[wall]]\nside = \"x-high\"\nrestitution = " + w +
         "\n[[species]]\ncount = 50\ndiameter = 1e-3\nrestitution = " + r +
         "\n[method]\npreset = \"dsmc\"\ntime-step = 0.001\n[forces]\ngravity = [0.0, -9.81]\n";
}

Record record_of_bed(const std::string& scene) {
  Record record;
  record.scene = scene;
  record.replicas.resize(16);
  return record;
}

/// A series of 100 samples whose replicas scatter by a part in a hundred.
void fill(Record& record, const std::string& name, const std::vector<std::string>& components,
          const std::vector<double>& values) {
  Generator generator(11);
  std::normal_distribution<double> noise(1, 0.01);
  for (std::size_t replica = 0; replica < record.replicas.size(); ++replica) {
    Series& series = add_series(record, replica, name, components);
    const double factor = noise(generator);
    for (int sample = 1; sample <= 100; ++sample) {
      std::vector<double> row = values;
      for (double& value : row) value *= factor;
      add_sample(series, sample, row);
    }
  }
}

double beyond(const Evidence& evidence) {
  const double error = std::hypot(evidence.standard_error, evidence.budget.reference);
  return (std::abs(evidence.value - evidence.expected) - evidence.budget.systematic) / error;
}

double against_law(double factor) {
  Record record = record_of_bed(bed_scene(0.999, 0.1));
  const law::VibratedBed bed = bed_of(Subject(record));
  fill(record, "centre-of-mass", {"x", "y"}, {0.005, factor * law::vibrated_bed_rise(bed)});
  return beyond(run_check(find_check("vibrated-bed-law"), record, {}));
}

TEST(VibratedBedLaw, PassesOnTheLawAlone) {
  EXPECT_LT(against_law(1), 4);
  EXPECT_GT(against_law(1.1), 10);
  EXPECT_GT(against_law(0.9), 10);
}

double against_reference(const std::string& check, double rise, const law::Arguments& numbers) {
  Record record = record_of_bed(bed_scene(0.9, 2));
  fill(record, "centre-of-mass", {"x", "y"}, {0.005, rise});
  return beyond(run_check(find_check(check), record, {numbers, 0, 0, ""}));
}

TEST(VibratedBedHeight, ComparesWithHardDisks) {
  const law::Arguments numbers{{"rest-height", 0.0}};
  EXPECT_LT(against_reference("vibrated-bed-height", 0.2289, numbers), 4);
  EXPECT_GT(against_reference("vibrated-bed-height", 0.26, numbers), 6);
}

TEST(VibratedBedExponent, IsTheSlopeFromTheOtherSpeed) {
  const law::Arguments numbers{{"rest-height", 0.0}, {"other-speed", 1.0}, {"expected", 2.0}};
  EXPECT_LT(against_reference("vibrated-bed-exponent", 4 * 0.0574, numbers), 4);
  EXPECT_GT(against_reference("vibrated-bed-exponent", 2.8 * 0.0574, numbers), 20);
}

/// V^2 from 1 to 5 m/s: with the run's point off by 30 percent the line bends.
TEST(VibratedBedCurvature, SeesAPointThatIsOffALine) {
  const law::Arguments numbers{
      {"rest-height", 0.0}, {"from-speed", 1.0}, {"to-speed", 5.0}, {"expected", 0.0}};
  EXPECT_LT(against_reference("vibrated-bed-curvature", 0.2289, numbers), 4);
  EXPECT_GT(against_reference("vibrated-bed-curvature", 1.3 * 0.2289, numbers), 10);
}

/// Heat that the walls take of the 1 that the bottom gives.
Evidence power(double restitution, double heat, double collisions_per_sample) {
  Record record = record_of_bed(bed_scene(restitution, 0.1, 0.9));
  fill(record, "wall-power", {"x-low", "x-high", "y-low", "y-high"}, {0, 0, 1, 0});
  fill(record, "wall-heat", {"x-low", "x-high", "y-low", "y-high"}, {heat / 4, heat / 4, heat / 2, 0});
  fill(record, "energy", {}, {50.0});
  fill(record, "centre-of-mass", {"x", "y"}, {0.005, 0.1});
  for (std::size_t replica = 0; replica < record.replicas.size(); ++replica) {
    Series& series = add_series(record, replica, "collisions", {});
    for (int sample = 1; sample <= 100; ++sample)
      add_sample(series, sample, {collisions_per_sample * sample});
  }
  return run_check(find_check("vibrated-bed-power"), record, {});
}

TEST(VibratedBedPower, BalancesWallsAndCollisions) {
  EXPECT_LT(std::abs(power(1, 1, 10).value), 1e-9);
  EXPECT_NEAR(power(1, 0.9, 10).value, 0.1, 1e-9);
  const double loss = 1 - 0.999 * 0.999;  // of T = 1 at each collision
  EXPECT_NEAR(power(0.999, 0, 1 / loss).value, 0, 0.01);
  EXPECT_NEAR(power(0.999, 0, 0.8 / loss).value, 0.2, 0.01);
}

/// Vertical velocities with a tail upwards or without; the horizontal ones are even.
void add_histograms(Record& record, double tail) {
  Generator generator(5);
  std::normal_distribution<double> normal;
  std::exponential_distribution<double> upwards(1);
  for (std::size_t replica = 0; replica < record.replicas.size(); ++replica)
    for (const char* name : {"velocity-histogram-x", "velocity-histogram-y"}) {
      Series& series = add_series(record, replica, name, {});
      series.quantity.shape = {60};
      for (int edge = 0; edge <= 60; ++edge) series.quantity.axis.push_back(-6 + 0.2 * edge);
      const double part = name[19] == 'y' ? tail : 0;
      for (int sample = 1; sample <= 50; ++sample) {
        std::vector<double> counts(60);
        for (int i = 0; i < 200; ++i) {
          const double velocity = normal(generator) + part * (upwards(generator) - 1);
          ++counts[static_cast<std::size_t>(std::clamp((velocity + 6) / 0.2, 0.0, 59.0))];
        }
        add_sample(series, sample, counts);
      }
    }
}

TEST(VibratedBedVelocities, SeeATailUpwardsAndNothingElse) {
  for (const char* check : {"vibrated-bed-skewness", "vibrated-bed-descent"}) {
    Record skewed = record_of_bed(bed_scene(0.9, 2)), even = record_of_bed(bed_scene(0.9, 2));
    add_histograms(skewed, 1);
    add_histograms(even, 0);
    const Settings settings{{{"least", 0.02}}, 0, 0, ""};
    const Evidence there = run_check(find_check(check), skewed, settings);
    const Evidence absent = run_check(find_check(check), even, settings);
    EXPECT_GT(there.value - 5 * there.standard_error, 0.02) << check;
    EXPECT_LT(absent.value, 0.02) << check;
  }
}

TEST(VibratedBedVelocities, HorizontalOnesAreEvenOrNot) {
  Record even = record_of_bed(bed_scene(0.9, 2)), lossless_side = record_of_bed(bed_scene(0.9, 2));
  add_histograms(even, 1);
  add_histograms(lossless_side, 1);
  for (Replica& replica : lossless_side.replicas) std::swap(replica.series[0].value, replica.series[1].value);
  EXPECT_LT(beyond(run_check(find_check("vibrated-bed-evenness"), even, {})), 4);
  EXPECT_GT(beyond(run_check(find_check("vibrated-bed-evenness"), lossless_side, {})), 10);
}

/// Points of the reference from one speed to another.
PowerLawFit fit_between(double restitution, double wall, double low, double high) {
  law::VibratedBed bed;
  bed.layers = 5;
  bed.restitution = restitution;
  bed.side_restitution = wall;
  std::vector<double> speed, rise, error;
  for (const BedPoint& point : reference_of(bed))
    if (point.speed > low * 0.999 && point.speed < high * 1.001) {
      speed.push_back(point.speed);
      rise.push_back(point.rise);
      error.push_back(point.standard_error);
    }
  return fit_power_law(speed, rise, error);
}

TEST(VibratedBedReference, BendsOrDoesNotAsTheReadmeOfTheCaseSays) {
  const PowerLawFit elastic = fit_between(0.9, 1, 0.6, 5);
  EXPECT_NEAR(elastic.exponent, 1.95, 4 * elastic.exponent_error);
  const PowerLawFit inelastic = fit_between(0.9, 0.9, 0.3, 10);
  EXPECT_NEAR(inelastic.exponent, 1.45, 4 * inelastic.exponent_error);
  EXPECT_LT(std::abs(inelastic.curvature), 4 * inelastic.curvature_error);
  const PowerLawFit sides = fit_between(1, 0.9, 0.06, 10);
  EXPECT_GT(sides.curvature, 5 * sides.curvature_error);
}

TEST(VibratedBedReference, RepeatsTheFile) {
  std::ifstream file(SANDGLASS_SOURCE_DIR "/reference/source/MUL/vibrated-bed.csv");
  std::string line;
  ASSERT_TRUE(std::getline(file, line));
  for (const BedPoint& point : vibrated_bed_reference()) {
    ASSERT_TRUE(std::getline(file, line));
    std::istringstream row(line);
    for (const double value :
         {point.restitution, point.wall_restitution, point.speed, point.rise, point.standard_error}) {
      std::string cell;
      std::getline(row, cell, ',');
      EXPECT_EQ(std::stod(cell), value) << line;
    }
  }
  EXPECT_FALSE(std::getline(file, line));
}

TEST(VibratedBedReference, NamesTheSpeedsThatItHas) {
  law::VibratedBed bed;
  bed.layers = 5;
  bed.restitution = 0.9;
  bed.side_restitution = 1;
  try {
    reference_at(bed, 0.5);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("0.6"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace sandglass::vibrated_bed_test
