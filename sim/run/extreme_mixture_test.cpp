#include "sim/base/error.hpp"
#include "sim/run/run.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

// Mixtures at the ends of what a scene allows: refused with the remedy, or finite and bounded.

namespace sandglass::extreme_mixture_test {
namespace {

const std::string kMixture = R"(
[run]
seed = 3
duration = { steps = 200 }
[domain]
dimension = 3
size = [10.0, 10.0, 10.0]
sides.y = "specular"
[[species]]
name = "one"
count = 400
diameter = 0.5
mass = 1.0
[[species]]
name = "two"
count = 400
diameter = 0.5
mass = 1.0
[method]
preset = "dsmc"
cells = [5, 5, 5]
time-step = 0.1
weight = 1.0
[initial]
temperature = 1.0
[[observe]]
what = "energy"
[[observe]]
what = "species"
)";

struct Change {
  std::string name, find, replace;
};

std::string changed(std::string text, const Change& change) {
  const std::size_t at = text.rfind(change.find);
  EXPECT_NE(at, std::string::npos) << change.find;
  return text.replace(at, change.find.size(), change.replace);
}

const Series& series(const Record& record, const std::string& name) {
  const auto& all = record.replicas[0].series;
  const auto found = std::ranges::find(all, name, [](const Series& each) { return each.quantity.name; });
  EXPECT_NE(found, all.end()) << name;
  return *found;
}

void expect_finite(const Record& record) {
  for (const Series& each : record.replicas[0].series)
    for (const double value : each.value) ASSERT_TRUE(std::isfinite(value)) << each.quantity.name;
}

class ExtremeMixture : public testing::TestWithParam<Change> {};

/// Elastic: whatever the mixture, its energy is that of the start to rounding.
TEST_P(ExtremeMixture, IsFiniteAndKeepsItsEnergy) {
  const Record record = run_scene(read_scene_text(changed(kMixture, GetParam()), "scene.toml"));
  expect_finite(record);
  const std::vector<double>& energy = series(record, "energy").value;
  EXPECT_GT(energy.front(), 0);
  for (const double value : energy) EXPECT_NEAR(value / energy.front(), 1, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Elastic, ExtremeMixture,
                         testing::Values(Change{"mass_ratio_1e6", "mass = 1.0", "mass = 1e6"},
                                         Change{"mass_ratio_1e_6", "mass = 1.0", "mass = 1e-6"},
                                         Change{"diameter_ratio_1e3", "diameter = 0.5", "diameter = 5e-4"},
                                         Change{"one_of_a_species", "count = 400", "count = 1"},
                                         Change{"light_weight", "weight = 1.0", "weight = 1e-6"},
                                         Change{"long_step", "time-step = 0.1", "time-step = 5.0"}),
                         [](const auto& test) { return test.param.name; });

/// A particle of a pair weighs a million: they collide in every step as often as the budget of candidates allows, or the
/// run says what to change.
TEST(ExtremeMixtures, OfHeavyWeightRunOrSayWhatToChange) {
  std::string text = changed(kMixture, {"", "weight = 1.0", "weight = 1e6"});
  for (int species = 0; species < 2; ++species)
    text = changed(text, {"", "diameter = 0.5", "diameter = 4e-3"});
  const Scene scene = read_scene_text(text, "scene.toml");
  try {
    expect_finite(run_scene(scene));
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("method."), std::string::npos) << error.what();
  }
}

/// A wall at zero temperature takes all that a particle brings: the gas cools and stays a gas of numbers.
TEST(ExtremeMixtures, CoolAtAWallOfZeroTemperature) {
  const std::string text = kMixture + "[[wall]]\nside = \"y-low\"\nrule = \"thermal\"\ntemperature = 0.0\n";
  Scene scene;
  try {
    scene = read_scene_text(text, "scene.toml");
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("temperature"), std::string::npos) << error.what();
    return;
  }
  const Record record = run_scene(scene);
  expect_finite(record);
  const std::vector<double>& energy = series(record, "energy").value;
  EXPECT_LT(energy.back(), 0.5 * energy.front());
  EXPECT_GT(energy.back(), 0);
}

/// Rough as well, and so different that a collision moves only one of the two.
TEST(ExtremeMixtures, OfRoughParticlesKeepTheirEnergyBounded) {
  std::string text = changed(kMixture, {"", "mass = 1.0", "mass = 1e6\ntangential-restitution = 0.5"});
  text = changed(text,
                 {"", "name = \"one\"", "name = \"one\"\nrestitution = 0.0\ntangential-restitution = 1.0"});
  text = changed(text, {"", "temperature = 1.0", "temperature = 1.0\nspin-temperature = 1.0"});
  const Record record = run_scene(read_scene_text(text, "scene.toml"));
  expect_finite(record);
  const std::vector<double>& energy = series(record, "energy").value;
  EXPECT_LE(*std::ranges::max_element(energy), 2.5 * energy.front());  // all that spins held as well
}

}  // namespace
}  // namespace sandglass::extreme_mixture_test
