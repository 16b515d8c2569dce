#include "sim/scene/species/diameters.hpp"

#include "sim/base/error.hpp"
#include "sim/scene/scene.hpp"

#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sandglass::diameters_test {
namespace {

double deviation_of(const Diameters& diameters) {
  double square = 0;
  for (std::size_t i = 0; i < diameters.values.size(); ++i)
    square += diameters.shares[i] * std::pow(diameters.values[i] - diameters.mean(), 2);
  return std::sqrt(square);
}

/// Classes of a uniform distribution are a lattice: its variance is that of the whole less 1/n^2 of it.
TEST(Diameters, UniformOnesAreEvenlySpaced) {
  for (const std::size_t classes : {std::size_t{2}, std::size_t{16}, std::size_t{100}}) {
    const Diameters diameters = uniform_diameters(0.5, 2, classes);
    EXPECT_EQ(diameters.values.size(), classes);
    EXPECT_NEAR(diameters.mean(), 1.25, 1e-14);
    const double whole = 1.5 / std::sqrt(12);
    EXPECT_NEAR(deviation_of(diameters), whole * std::sqrt(1 - std::pow(classes, -2.0)), 1e-14);
  }
}

/// With many classes the moments are those of the distribution; with few the tails are missing.
TEST(Diameters, BellsHaveTheirMeanAndNearlyTheirWidth) {
  for (const std::size_t classes : {std::size_t{16}, std::size_t{100}}) {
    const double lost = 1.5 / static_cast<double>(classes);
    EXPECT_NEAR(normal_diameters(1, 0.1, classes).mean(), 1, 1e-14);
    EXPECT_NEAR(deviation_of(normal_diameters(1, 0.1, classes)), 0.1, 0.1 * lost);
    EXPECT_NEAR(lognormal_diameters(1, 0.3, classes).mean(), 1, 0.3 * lost);
    EXPECT_NEAR(deviation_of(lognormal_diameters(1, 0.3, classes)), 0.3, 0.3 * 2 * lost);
  }
  EXPECT_NEAR(normal_diameters(1, 0.1, 2).values[1], 1 + 0.1 * 0.6744897501960817, 1e-14);  // the quartile
}

Scene read(const std::string& diameter, const std::string& amount = "count = 100",
           const std::string& more = "") {
  return read_scene_text(
      "run.duration.time = 1.0\ndomain = { dimension = 2, size = [40.0, 40.0] }\n"
      "method = { preset = 'event-driven', time-step = 0.1 }\ninitial.positions = 'lattice'\n"
      "species = [ { name = 'bead', mass = 2.0, diameter = " +
          diameter + ", " + amount + more + " } ]\n",
      "beads.toml");
}

TEST(Diameters, ADistributionBecomesSpeciesOfOneMaterial) {
  const Scene scene = read("{ distribution = 'list', values = [1.0, 2.0], shares = [3, 1] }");
  ASSERT_EQ(scene.species.size(), 2u);
  EXPECT_EQ(scene.species[0].name, "bead-1");
  EXPECT_EQ(*scene.species[0].count, 75u);
  EXPECT_EQ(*scene.species[1].count, 25u);
  EXPECT_DOUBLE_EQ(scene.species[1].mass / scene.species[0].mass, 4);
  EXPECT_DOUBLE_EQ(scene.species[0].mass, 2 / std::pow(1.25, 2));
  EXPECT_EQ(read_scene_text(write_scene(scene), "written.toml"), scene);
}

TEST(Diameters, AmountsAreThoseOfAllTogether) {
  const std::string sizes = "{ distribution = 'lognormal', mean = 1.0, deviation = 0.3, classes = 7 }";
  EXPECT_EQ(particle_count(read(sizes)), 100u);
  EXPECT_EQ(particle_count(read(sizes, "count = 1003")), 1003u);
  double fraction = 0;
  for (const Species& species : read(sizes, "area-fraction = 0.2").species) fraction += *species.fraction;
  EXPECT_NEAR(fraction, 0.2, 1e-15);
  const Scene scene = read(sizes, "area-fraction = 0.2");
  for (const Species& species : scene.species)  // as many of each, to rounding
    EXPECT_NEAR(static_cast<double>(particle_count(scene, species)),
                static_cast<double>(particle_count(scene)) / 7, 1);
}

std::string refusal(const std::string& diameter, const std::string& more = "") {
  try {
    read(diameter, "count = 100", more);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Diameters, WhatIsWrongIsNamed) {
  using testing::HasSubstr;
  EXPECT_THAT(refusal("{ distribution = 'unifrom', low = 1, high = 2 }"),
              HasSubstr("did you mean 'uniform'"));
  EXPECT_THAT(refusal("{ low = 1, high = 2 }"), HasSubstr("missing 'species.diameter.distribution'"));
  EXPECT_THAT(refusal("{ distribution = 'uniform', low = 2, high = 1 }"), HasSubstr("below 'high'"));
  EXPECT_THAT(refusal("{ distribution = 'uniform', low = 1 }"), HasSubstr("'species.diameter.high'"));
  EXPECT_THAT(refusal("{ distribution = 'normal', mean = 1, deviation = 1 }"), HasSubstr("so wide"));
  EXPECT_THAT(refusal("{ distribution = 'normal', mean = 1, deviation = 0.1, classes = 1 }"),
              HasSubstr("2 to 100"));
  EXPECT_THAT(refusal("{ distribution = 'list', values = [1.0, -2.0] }"), HasSubstr("above 0"));
  EXPECT_THAT(refusal("{ distribution = 'list', values = [1.0], shares = [1, 2] }"),
              HasSubstr("as many numbers"));
  EXPECT_THAT(refusal("{ distribution = 'list', values = [1.0], classes = 3 }"), HasSubstr("classes"));
}

}  // namespace
}  // namespace sandglass::diameters_test
