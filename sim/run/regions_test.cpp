#include "sim/base/error.hpp"
#include "sim/base/statistics.hpp"
#include "sim/run/test_run_text.hpp"
#include "sim/run/test_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Regions of other weights at work, against what needs no weights.

namespace sandglass::regions_test {
namespace {

/// A gas at rest with T = m = 1, half of whose box has half the weight: two borders of length 4.
const std::string kGas = R"(
[run]
replicas = 400
duration = { time = 2.0 }
[domain]
dimension = 2
size = [8.0, 4.0]
[[species]]
count = 200
diameter = 0.05
[[region]]
low = [4.0, 0.0]
high = [8.0, 4.0]
weight = 0.5
[method]
preset = "dsmc"
cells = [8, 4]
time-step = 0.05
[[observe]]
what = "cloning"
every = { time = 2.0 }
[[observe]]
what = "fields"
grid = [4, 1]
every = { time = 2.0 }
[[observe]]
what = "energy"
every = { time = 2.0 }
)";

const Series& series(const Record& record, std::size_t replica, const std::string& name) {
  return *std::ranges::find(record.replicas[replica].series, name,
                            [](const Series& each) { return each.quantity.name; });
}

/// One number of the last sample, of every replica.
std::vector<double> at_end(const Record& record, const std::string& name, std::size_t index) {
  std::vector<double> values;
  for (std::size_t replica = 0; replica < record.replicas.size(); ++replica) {
    const Series& all = series(record, replica, name);
    values.push_back(all.value[all.value.size() - all.quantity.size() + index]);
  }
  return values;
}

/// Area of a bin times its density.
std::vector<double> masses(const Record& record) {
  std::vector<double> sums(record.replicas.size());
  for (std::size_t bin = 0; bin < 4; ++bin) {
    const std::vector<double> density = at_end(record, "fields", 4 * bin);
    for (std::size_t replica = 0; replica < sums.size(); ++replica) sums[replica] += 8 * density[replica];
  }
  return sums;
}

const Record& gas() {
  static const Record record = run_text(kGas);
  return record;
}

/// The start has the mass of the scene to half a particle of each region, and the rest is what crossings have gained.
TEST(Regions, MassIsThatOfTheStartAndOfTheCrossings) {
  const std::vector<double> mass = masses(gas());
  const std::vector<double> cloned = at_end(gas(), "cloning-gained", 0),
                            removed = at_end(gas(), "cloning-gained", 4);
  for (std::size_t replica = 0; replica < mass.size(); ++replica) {
    EXPECT_EQ(cloned[replica], 0) << "whole copies";
    EXPECT_NEAR(mass[replica] - removed[replica], 200, 0.75);
  }
}

void expect_mean(const std::vector<double>& values, double expected) {
  const Mean mean = mean_of_independent(values);
  EXPECT_NEAR(mean.value, expected, 4.5 * mean.standard_error);
}

TEST(Regions, KeepMassMomentumAndEnergyInTheMean) {
  expect_mean(masses(gas()), 200);
  for (std::size_t amount = 0; amount < 8; ++amount) expect_mean(at_end(gas(), "cloning-gained", amount), 0);
  std::vector<double> energy;
  const std::vector<double> end = at_end(gas(), "energy", 0);
  for (std::size_t replica = 0; replica < end.size(); ++replica)
    energy.push_back(end[replica] - series(gas(), replica, "energy").value.front());
  expect_mean(energy, 0);
}

/// The draws of crossings are independent: the scatter of what is gained is the sum of their variances. Of a sample variance
/// over R replicas, normal values, the relative error is sqrt(2/R).
TEST(Regions, KnowTheVarianceThatTheyAdd) {
  for (const std::size_t amount : {4, 5, 6, 7}) {  // of those removed
    const Mean gained = mean_of_independent(at_end(gas(), "cloning-gained", amount)),
               known = mean_of_independent(at_end(gas(), "cloning-variance", amount));
    const double replicas = 400;
    const double variance = gained.standard_error * gained.standard_error * replicas;
    // Squares have a heavier tail than a normal value: the kurtosis of the sum of ~20 is below 4.
    EXPECT_NEAR(variance / known.value, 1, 4.5 * std::sqrt(3 / replicas)) << amount;
  }
}

/// sqrt(T/2 pi m) n real particles cross a unit of length each way; each removal adds w1 (w2 - w1).
TEST(Regions, TheirVarianceIsThatOfTheFluxThroughTheBorders) {
  const double crossed = 200 / 32.0 * std::sqrt(1 / (2 * std::numbers::pi)) * 8 * 2;
  expect_mean(at_end(gas(), "cloning-brought", 4), crossed);
  expect_mean(at_end(gas(), "cloning-brought", 0), crossed);
  expect_mean(at_end(gas(), "cloning-variance", 4), crossed * 0.5);
}

TEST(Regions, AUniformGasStaysUniform) {
  for (std::size_t bin = 0; bin < 4; ++bin) {
    expect_mean(at_end(gas(), "fields", 4 * bin), 200 / 32.0);
    expect_mean(at_end(gas(), "fields", 4 * bin + 1), 0);
  }
}

/// Real particles collide alike everywhere: at sqrt(2) n sigma <v>, a half of them with half of the weight.
TEST(Regions, RealParticlesCollideAtOneRate) {
  std::vector<double> collisions;
  for (const Replica& replica : gas().replicas) collisions.push_back(replica.counters.at("collisions"));
  const double rate = std::sqrt(2) * 200 / 32.0 * 0.1 * std::sqrt(std::numbers::pi / 2);
  // 100 particles of weight one, 200 of weight a half; N (N - 1) pairs of a fixed number N are 1/N fewer than N^2.
  const Mean mean = mean_of_independent(collisions);
  EXPECT_NEAR(mean.value, 300 * rate, 4.5 * mean.standard_error + 0.01 * mean.value);
}

TEST(Regions, FaultsShowInTheMass) {
  const std::string some = edited(kGas, "replicas = 400", "replicas = 40");
  const Mean full = mean_of_independent(masses(run_text(some, "clones-keep-weight"))),
             lost = mean_of_independent(masses(run_text(some, "survivors-keep-weight")));
  EXPECT_GT(full.value - 200, 10 * full.standard_error);
  EXPECT_LT(lost.value - 200, -10 * lost.standard_error);
  expect_mean(masses(run_text(some)), 200);
}

/// A region of the weight that particles have anyway changes no bit.
TEST(Regions, OfTheSameWeightChangeNothing) {
  std::string plain =
      edited(edited(kGas, "400", "2"), "[[observe]]\nwhat = \"cloning\"\nevery = { time = 2.0 }\n", "");
  const Record with = run_text(edited(plain, "weight = 0.5", "weight = 1.0"));
  plain = edited(plain, "[[region]]\nlow = [4.0, 0.0]\nhigh = [8.0, 4.0]\nweight = 0.5\n", "");
  const Record without = run_text(plain);
  EXPECT_EQ(series(with, 1, "energy").value, series(without, 1, "energy").value);
  EXPECT_EQ(with.replicas[1].counters.at("collisions"), without.replicas[1].counters.at("collisions"));
}

/// A mixture of rough spheres that streams in, falls, and passes three weights.
const std::string kStream = R"(
[run]
duration = { steps = 60 }
[domain]
dimension = 3
size = [4.0, 2.0, 0.5]
sides = { x = "open", y = "specular" }
[[species]]
name = "light"
count = 300
diameter = 0.05
tangential-restitution = 0.5
[[species]]
name = "heavy"
count = 300
mass = 3.0
diameter = 0.08
tangential-restitution = 0.5
[[inflow]]
side = "x-low"
species = "heavy"
number-density = 100.0
velocity = [1.0, 0.0, 0.0]
temperature = 0.5
spin-temperature = 0.1
[[region]]
low = [0.0, 1.0, 0.0]
high = [4.0, 1.5, 0.5]
weight = 0.7
[[region]]
low = [0.0, 1.5, 0.0]
high = [4.0, 2.0, 0.5]
weight = 0.2
[method]
preset = "dsmc"
cells = [8, 4, 1]
time-step = 0.05
[forces]
gravity = [0.0, -0.5, 0.0]
[[observe]]
what = "fields"
grid = [1, 4, 1]
every = { steps = 1 }
[[observe]]
what = "cloning"
every = { steps = 10 }
[[observe]]
what = "species"
every = { steps = 10 }
[output]
trajectory = { steps = 20 }
checkpoint = { steps = 25 }
)";

/// Every particle has the weight of where it is, whoever brought it there.
TEST(Regions, GiveEveryParticleItsWeight) {
  for (const char* preset : {"dsmc", "dsmc-bird"}) {
    const Record record = run_text(edited(kStream, "\"dsmc\"", '"' + std::string(preset) + '"'));
    for (const Frame& frame : record.trajectory) {
      const auto weights = frame.columns.get(column::weight);
      ASSERT_GT(weights.size(), 500u);
      for (std::size_t i = 0; i < weights.size(); ++i) {
        const double y = frame.position[3 * i + 1];
        ASSERT_EQ(weights[i], y < 1 ? 1 : y < 1.5 ? 0.7 : 0.2) << y;
      }
    }
  }
}

TEST(Regions, GoOnBitwiseFromACheckpoint) {
  const Scene scene = read_scene_text(kStream, "stream.toml");
  const Record whole = run_scene(scene);
  RunOptions options;
  options.checkpoint_path = testing::TempDir() + "regions_test.checkpoint.h5";
  run_scene(scene, options);
  const Record resumed = resume(read_record(options.checkpoint_path));
  EXPECT_EQ(resumed.replicas[0].counters, whole.replicas[0].counters);
  for (std::size_t i = 0; i < whole.replicas[0].series.size(); ++i)
    EXPECT_EQ(resumed.replicas[0].series[i].value, whole.replicas[0].series[i].value);
  EXPECT_EQ(resumed.trajectory.back().position, whole.trajectory.back().position);
  EXPECT_GT(whole.replicas[0].counters.at("particles-cloned"), 100);
  EXPECT_GT(whole.replicas[0].counters.at("particles-removed"), 100);
}

TEST(Regions, SourcesPourTheirWeight) {
  const std::string poured =
      edited(edited(kGas, "replicas = 400", "replicas = 1"), "count = 200", "count = 0") +
      "[[source]]\nrate = 100.0\ncentre = [1.0, 1.0]\n"
      "[[source]]\nrate = 100.0\ncentre = [5.0, 1.0]\n";
  EXPECT_NEAR(masses(run_text(poured))[0], 200 + 100, 1e-9);
}

/// Of the real particles that a stream sends in evenly over its side, each region gets its share.
TEST(Regions, InflowsBringTheFluxOfRealParticles) {
  const std::string text = R"(
[run]
replicas = 200
duration = { steps = 1 }
[domain]
dimension = 2
size = [4.0, 4.0]
sides.x = "open"
[[species]]
count = 0
diameter = 0.01
[[inflow]]
side = "x-low"
number-density = 50.0
velocity = [1.0, 0.0]
temperature = 0.0
ARRIVALS
[[region]]
low = [0.0, 1.0]
high = [4.0, 2.0]
weight = 0.25
[[region]]
low = [0.0, 2.0]
high = [4.0, 3.0]
weight = 3.0
[method]
preset = "dsmc"
cells = [4, 4]
time-step = 1.0
[[observe]]
what = "fields"
grid = [1, 4]
every = { steps = 1 }
)";
  for (const char* arrivals : {"", "arrivals = \"even\""}) {
    const Record record = run_text(edited(text, "ARRIVALS", arrivals));
    for (std::size_t row = 0; row < 4; ++row) expect_mean(at_end(record, "fields", 4 * row), 50 / 4.0);
    for (const Replica& replica : record.replicas) {
      const double expected = 50 * (1 + 4 + 1 / 3.0 + 1);
      EXPECT_NEAR(replica.counters.at("particles-entered"), expected,
                  *arrivals == 0 ? 6 * std::sqrt(expected) : 1);
    }
  }
}

TEST(Regions, StartWithTheirShareOfParticles) {
  const std::string thin =
      edited(edited(edited(kGas, "replicas = 400", "replicas = 1"), "time = 2.0", "steps = 1"),
             "weight = 0.5", "weight = 0.3");
  const Record lattice =
      run_text(thin + "[initial]\npositions = \"lattice\"\n[output]\ntrajectory = { steps = 1 }\n");
  const auto weights = lattice.trajectory.front().columns.get(column::weight);
  EXPECT_NEAR(static_cast<double>(std::ranges::count(weights, 1.0)), 100, 5) << "a row of the lattice";
  EXPECT_NEAR(static_cast<double>(std::ranges::count(weights, 0.3)), 333, 17);
}

/// Its momentum and temperature are exact, as those of real particles.
TEST(Regions, StartExactly) {
  const Record record =
      run_text(edited(edited(kGas, "400", "3"), "what = \"energy\"", "what = \"temperature\"") +
               "[[observe]]\nwhat = \"momentum\"\nevery = { time = 2.0 }\n");
  for (std::size_t replica = 0; replica < 3; ++replica) {
    EXPECT_NEAR(series(record, replica, "temperature").value[2], 1, 1e-12);
    EXPECT_NEAR(series(record, replica, "momentum").value[0], 0, 1e-10);
  }
}

TEST(Regions, PlanSaysTheMostParticles) {
  const Plan planned = plan(read_scene_text(kGas, "gas.toml"));
  EXPECT_EQ(planned.particles, 300u);
  EXPECT_EQ(planned.most_particles, 400u);
  EXPECT_THAT(planned.columns, testing::Contains("weight"));
}

/// Far apart, weights stay finite, and there are no more particles than their mass allows.
TEST(Regions, BearExtremes) {
  const std::string small =
      edited(edited(kGas, "replicas = 400", "replicas = 1"), "count = 200", "count = 20");
  const Record heavy = run_text(edited(small, "weight = 0.5", "weight = 1e6"));
  EXPECT_EQ(heavy.replicas[0].counters.at("particles-cloned"), 0)
      << "a million times: nobody is left to clone";
  const Record light = run_text(edited(small, "weight = 0.5", "weight = 1e-4"));
  const double mass = masses(light)[0];
  EXPECT_LT(light.replicas[0].counters.at("particle-moves"), 40 * (std::max(mass, 20.0) + 20) / 1e-4);
  EXPECT_NEAR(mass, 20 + at_end(light, "cloning-gained", 4)[0], 0.75);
}

}  // namespace
}  // namespace sandglass::regions_test
