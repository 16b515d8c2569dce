#include "sim/method/dsmc/from_scene.hpp"

#include "sim/base/error.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace sandglass::dsmc::from_scene_test {
namespace {

Scene box_of(std::uint64_t particles) {
  Scene scene;
  scene.domain = {2, {10, 20}, {{}, {}}};
  scene.species.emplace_back().count = particles;
  scene.method.time_step.fixed = 0.1;
  return scene;
}

/// The offset carries m l r |c_n| a collision, hard cores m d (1 + r)/2 |c_n|.
TEST(FromScene, CorrectedOffsetCarriesTheVirialOfHardCores) {
  Scene scene = box_of(30);
  scene.species[0].diameter = 0.9;
  scene.species[0].restitution = 0.6;
  choose(scene.method, "cba-corrected");
  const double length = parameters_of<2>(scene).offset.consistent;
  EXPECT_NEAR(length * 0.6, 0.9 * (1 + 0.6) / 2, 1e-14);
}

/// The same for each pair of species, whose restitution is the mean of both.
TEST(FromScene, OffsetsOfAMixtureAreThoseOfItsPairs) {
  Scene scene = box_of(30);
  scene.species[0].restitution = 0.6;
  scene.species.push_back(scene.species[0]);
  scene.species[1].diameter = 3;
  scene.species[1].restitution = 0.8;
  for (const char* preset : {"cba", "cba-corrected"}) {
    choose(scene.method, preset);
    const bool corrected = preset != std::string("cba");
    const Parameters parameters = parameters_of<2>(scene);
    EXPECT_NEAR(parameters.diameter, std::sqrt((1 + 9) / 2.0), 1e-14);
    const auto expect = [&](std::size_t pair, double diameter, double restitution) {
      EXPECT_NEAR(parameters.kinds.offsets[pair] * parameters.offset.consistent,
                  corrected ? diameter * (1 + restitution) / (2 * restitution) : diameter, 1e-13);
    };
    expect(0, 1, 0.6);
    expect(1, 2, 0.7);
    expect(2, 2, 0.7);
    expect(3, 3, 0.8);
  }
}

/// From one at freezing (disks 0.70, spheres 0.494) to zero in a full cell; the fall has a width in loose packings too.
TEST(FromScene, EntryFallsFromFreezingToFull) {
  Scene scene = box_of(30);
  choose(scene.method, "hsmc");
  DsmcOptions& options = std::get<DsmcOptions>(scene.method.options);
  options.entry = Entry::falling;
  options.densest_fraction = 0.9;
  const Curve disks = parameters_of<2>(scene).excluded_volume.entry;
  for (const auto& [fraction, probability] : {std::pair(0.7, 1.0), std::pair(0.8, 0.5), std::pair(0.9, 0.0)})
    EXPECT_NEAR(disks.at(fraction), probability, 1e-12);
  options.densest_fraction = 0.5;
  EXPECT_NEAR(parameters_of<2>(scene).excluded_volume.entry.at(0.85 * 0.5), 1, 1e-12);
  options.densest_fraction = 0.64;
  EXPECT_NEAR(parameters_of<3>(scene).excluded_volume.entry.at(0.494), 1, 1e-12);
  EXPECT_NEAR(parameters_of<3>(scene).excluded_volume.entry.at(0.567), 0.5, 1e-12);
}

TEST(FromScene, ChoosesCellsWhereTheSceneDoesNot) {
  const Grid<2> grid = cells_of<2>(box_of(2000), 10).grid();
  EXPECT_EQ(grid.cells(0), 10u);
  EXPECT_EQ(grid.cells(1), 20u);
}

TEST(FromScene, MoreCellsThanNumbersAreRefused) {
  Scene scene = box_of(30);
  std::get<DsmcOptions>(scene.method.options).cells = {100'000, 100'000};
  EXPECT_THROW(cells_of<2>(scene, 10), InputError);
}

}  // namespace
}  // namespace sandglass::dsmc::from_scene_test
