#include "validation/check/check.hpp"
#include "validation/check/synthetic.hpp"
#include "validation/check/two_fluids_reference.hpp"

#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

// Records of Greenspan's two examples made by hand from the reference: right ones agree, wrong ones do not.

namespace sandglass::two_fluids_test {
namespace {

using namespace synthetic;

std::string example_one() {
  std::ifstream file(SANDGLASS_SOURCE_DIR "/validation/case/mixing/two-fluid-mixing/scene.toml");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

constexpr const char* kExampleTwo = R"([run]
duration = { steps = 300 }
[domain]
dimension = 2
size = [100.0, 100.0]
sides = { x = "specular", y = "specular" }
[[species]]
name = "heavy"
diameter = 5.0
count = 64
[[species]]
name = "light"
diameter = 5.0
mass = 0.25
count = 192
[method]
preset = "mixing"
time-step = 1e-2
core-exponent = 2
cutoff = 10.0
softening-length = 0.1
support-blocks = [16, 16]
[forces]
gravity = [0.0, -980.0]
[initial]
positions = "layers"
uniform-velocity = 500.0
)";

Record record_of_example(const std::string& scene, std::size_t replicas) {
  Record record;
  record.scene = scene;
  record.replicas.resize(replicas);
  return record;
}

/// Deviation in standard errors of value and reference together.
double deviation(const Evidence& evidence) {
  return std::abs(evidence.value - evidence.expected) /
         std::hypot(evidence.standard_error, evidence.budget.reference);
}

Evidence evidence(const std::string& check, const Record& record, const law::Arguments& numbers = {}) {
  return run_check(find_check(check), record, {numbers, 0, 0, ""});
}

/// Four replicas about the reference whose standard error is `error`.
double scattered(double mean, double error, std::size_t replica) {
  const double spread = error * std::sqrt(12.0);  // standard deviation spread/sqrt(3) of four
  return mean + spread * (replica % 2 == 0 ? 0.5 : -0.5);
}

void add_steps(Series& series, std::uint64_t step, const std::vector<double>& values) {
  add_sample(series, static_cast<double>(step), values);
  series.step.back() = step;
}

TEST(TwoFluids, StartIsHeldAgainstTheTranscription) {
  for (const double shift : {0.0, 1e-5}) {
    Record record = record_of_example(example_one(), 1);
    for (const FluidPlaces& point : example_one_places()) {
      Frame frame{point.step, 0, {}, {}};
      for (std::uint64_t id = 0; id < point.places.size(); ++id) {
        frame.columns.append(column::id, id);
        frame.position.insert(frame.position.end(), {point.places[id][0] + shift, point.places[id][1]});
        frame.velocity.insert(frame.velocity.end(), {0, 0});
      }
      record.trajectory.push_back(frame);
    }
    const Evidence start = evidence("two-fluids-start", record);
    EXPECT_NEAR(start.value, shift, 1e-12);
    EXPECT_EQ(start.value <= start.budget.systematic, shift == 0);
  }
}

Record with_heights(const std::string& scene, const std::vector<FluidMeans>& reference, double shift) {
  Record record = record_of_example(scene, 4);
  for (std::size_t replica = 0; replica < 4; ++replica) {
    Series& centre =
        add_series(record, replica, "fluid-centre", {"first-x", "first-y", "others-x", "others-y"});
    centre.quantity.shape = {2, 2};
    for (const FluidMeans& point : reference) {
      const double error = std::max(point.heavy.standard_error, 0.01);
      add_steps(centre, point.step,
                {50, scattered(point.heavy.value + shift * error, error, replica), 50,
                 scattered(point.light.value, error, replica)});
    }
  }
  return record;
}

TEST(TwoFluids, HeightsAreHeldAgainstTheTranscription) {
  for (const double shift : {0.0, 10.0}) {
    const Evidence one =
        evidence("two-fluids-heights", with_heights(example_one(), example_one_means(), shift));
    const Evidence two =
        evidence("two-fluids-heights-256", with_heights(kExampleTwo, example_two_means(), shift));
    EXPECT_EQ(one.comparisons, 2 * static_cast<int>(example_one_means().size()));
    for (const Evidence& all : {one, two}) EXPECT_EQ(deviation(all) < 1e-6, shift == 0);
    if (shift > 0) {
      EXPECT_GT(deviation(two), 5);
    }
  }
}

TEST(TwoFluids, EnergiesAreHeldAgainstTheTranscription) {
  for (const double factor : {1.0, 1.1}) {
    Record record = record_of_example(kExampleTwo, 4);
    for (std::size_t replica = 0; replica < 4; ++replica) {
      Series& energy = add_series(record, replica, "energy", {});
      for (const FluidMeans& point : example_two_means())
        add_steps(energy, point.step,
                  {scattered(factor * point.energy.value, point.energy.standard_error, replica)});
    }
    EXPECT_EQ(deviation(evidence("two-fluids-energy-256", record)) < 1e-6, factor == 1);
  }
}

/// Simulated particles of both fluids in the lower and the upper half, as densities of two bins.
void add_halves(Series& density, std::uint64_t step, double heavy_below, double heavy_above,
                double light_below, double light_above) {
  constexpr double kBin = 100.0 * 100.0 / 2;
  add_steps(density, step, {heavy_below / kBin, light_below / kBin, heavy_above / kBin, light_above / kBin});
}

Series& add_density(Record& record, std::size_t replica) {
  Series& density = add_series(record, replica, "fluid-density", {});
  density.quantity.shape = {1, 2, 2};
  return density;
}

/// All four heavy ones at the bottom at step 2080, and three of them until the end: two replicas of eight.
TEST(TwoFluids, OutcomeIsTheShareOfStartsThatEndAsTheSourceSaw) {
  Record record = record_of_example(example_one(), 8);
  for (std::size_t replica = 0; replica < 8; ++replica) {
    Series& density = add_density(record, replica);
    const double first = replica < 3 ? 4 : 3, later = replica == 2 ? 2 : 3;
    add_halves(density, 2040, 0, 4, 6, 6);
    add_halves(density, 2080, first, 4 - first, 6, 6);
    add_halves(density, 2120, later, 4 - later, 6, 6);
  }
  EXPECT_EQ(evidence("two-fluids-outcome", record).value, 2.0 / 8);
}

TEST(TwoFluids, MixSlowDownAndCondenseAsTheirSeriesSay) {
  Record record = record_of_example(kExampleTwo, 4);
  for (std::size_t replica = 0; replica < 4; ++replica) {
    record.replicas[replica].series.reserve(3);
    Series& index = add_series(record, replica, "mixing-index", {});
    Series& energy = add_series(record, replica, "energy", {});
    Series& density = add_density(record, replica);
    for (const std::uint64_t step : {0, 69, 250, 300}) {
      add_steps(index, step, {step < 69 ? 0 : 0.8 + 0.001 * static_cast<double>(replica)});
      add_steps(energy, step, {step < 250 ? 100 : step == 250 ? 10 : 9.0});
      add_halves(density, step, step < 300 ? 32 : 40, step < 300 ? 32 : 24, 96, 96);
    }
  }
  const Evidence mixed = evidence("two-fluids-stay-mixed", record, {{"least", 0.9}});
  EXPECT_NEAR(mixed.value, 0.8015, 1e-12);
  EXPECT_EQ(mixed.kind, Expectation::at_least);
  const Evidence slow = evidence("two-fluids-slow-down", record, {{"most", 0.95}});
  EXPECT_NEAR(slow.value, 0.9, 1e-12);
  EXPECT_EQ(slow.kind, Expectation::at_most);
  EXPECT_NEAR(evidence("two-fluids-condense", record, {{"least", 0.04}}).value, 8.0 / 256, 1e-12);
}

}  // namespace
}  // namespace sandglass::two_fluids_test
