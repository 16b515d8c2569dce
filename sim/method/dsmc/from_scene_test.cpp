#include "sim/method/dsmc/from_scene.hpp"

#include "sim/base/error.hpp"

#include <gtest/gtest.h>

namespace sandglass::dsmc {
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
}  // namespace sandglass::dsmc
