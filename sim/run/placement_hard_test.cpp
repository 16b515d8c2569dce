#include "sim/base/error.hpp"
#include "sim/run/initial_species.hpp"
#include "sim/run/placement.hpp"
#include "sim/run/test_hard.hpp"

#include <numbers>
#include <string>

#include <gtest/gtest.h>

namespace sandglass::placement_hard_test {
namespace {

constexpr double kTouch = -1e-11;  // overlap by rounding

template <int D>
std::vector<Phase<D>> placed(const Scene& scene, std::uint64_t replica = 0) {
  return place<D>(scene, particle_count(scene), {1, replica}, shuffled_species(scene, {1, replica}));
}

template <int D>
void expect_room(const Scene& scene) {
  const auto species = shuffled_species(scene, {1, 0});
  const auto particles = placed<D>(scene);
  ASSERT_EQ(particles.size(), particle_count(scene));
  EXPECT_GE(narrowest_gap<D>(scene, particles, species), kTouch);
}

Obstacle obstacle_at(std::vector<double> centre, double radius) { return {std::move(centre), radius, {}}; }

std::string refusal(const Scene& scene) {
  try {
    scene.domain.dimension == 2 ? void(placed<2>(scene)) : void(placed<3>(scene));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// 30^2 disks in 30^2 reach pi/4, 8^3 spheres in 8^3 reach pi/6.
TEST(PlacementHard, SquareLatticesAreFilledToTheLast) {
  expect_room<2>(hard_scene({30, 30}, 900));
  expect_room<3>(hard_scene({8, 8, 8}, 512));
  Scene walled = hard_scene({30, 30}, 900);
  wall_in(walled, 0);
  wall_in(walled, 1);
  expect_room<2>(walled);
  EXPECT_NEAR(narrowest_gap<2>(walled, placed<2>(walled)), 0, 1e-12);
}

TEST(PlacementHard, ALatticeThatFitsAsItIsStaysTheOneOfTheOtherMethods) {
  const Scene hard = hard_scene({30, 20}, 150);
  Scene soft = hard;
  choose(soft.method, "dsmc");
  const auto a = placed<2>(hard), b = placed<2>(soft);
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(a[i].position, b[i].position);
}

/// Square boxes whose edge is no multiple of a diameter; 240 at 0.7495 is Mueller's (2001).
TEST(PlacementHard, DenseDisksStandOnATriangularLattice) {
  for (const double fraction : {0.7495, 0.785, 0.82}) {
    for (const std::uint64_t count : {240u, 1000u}) {
      const double edge = std::sqrt(static_cast<double>(count) * std::numbers::pi / 4 / fraction);
      Scene scene = hard_scene({edge, edge}, count);
      expect_room<2>(scene);
      if (fraction > 0.8) continue;
      wall_in(scene, 1);
      if (count == 1000) expect_room<2>(scene);
    }
  }
}

/// A box made for it: 0.9069 of the area.
TEST(PlacementHard, ClosePackingFitsItsOwnBox) {
  expect_room<2>(hard_scene({20, 24 * std::sqrt(3) / 2}, 480));
  expect_room<2>(hard_scene({24 * std::sqrt(3) / 2, 20}, 480));
  const double cell = std::sqrt(2.0);
  expect_room<3>(hard_scene({4 * cell, 4 * cell, 5 * cell}, 320));
}

TEST(PlacementHard, DenseSpheresStandOnAFaceCentredLattice) {
  const double edge = std::cbrt(864 * std::numbers::pi / 6 / 0.6);
  expect_room<3>(hard_scene({edge, edge, edge}, 864));
  Scene walled = hard_scene({edge, edge, edge}, 700);
  wall_in(walled, 2);
  expect_room<3>(walled);
}

TEST(PlacementHard, LatticesLeaveObstaclesFree) {
  for (const std::uint64_t count : {100u, 333u, 500u}) {
    Scene scene = hard_scene({30, 24}, count);
    scene.obstacles = {obstacle_at({12, 10}, 4), obstacle_at({22, 18}, 2.5)};
    expect_room<2>(scene);
    wall_in(scene, 1);
    expect_room<2>(scene);
  }
  Scene spheres = hard_scene({10, 10, 10}, 550);
  spheres.obstacles = {obstacle_at({5, 5, 5}, 3)};
  wall_in(spheres, 0);
  expect_room<3>(spheres);
}

Scene mixture(std::vector<double> box, std::uint64_t small, std::uint64_t large, Positions positions) {
  Scene scene = hard_scene(box, small, positions);
  scene.species.push_back(scene.species[0]);
  scene.species[1].name = "large";
  scene.species[1].count = large;
  scene.species[1].diameter = 2.5;
  return scene;
}

TEST(PlacementHard, MixturesDoNotOverlap) {
  for (const Positions positions : {Positions::lattice, Positions::random_without_overlap}) {
    Scene disks = mixture({40, 30}, 100, 40, positions);
    expect_room<2>(disks);
    disks.obstacles = {obstacle_at({10, 10}, 3)};
    wall_in(disks, 0);
    expect_room<2>(disks);
    Scene spheres = mixture({14, 15, 16}, 120, 15, positions);
    wall_in(spheres, 2);
    expect_room<3>(spheres);
  }
}

/// Each small disk alone between two walls knows its own radius, not the largest.
TEST(PlacementHard, RandomPlacesUseTheRoomOfEachSpecies) {
  Scene scene = mixture({40, 2.6}, 20, 5, Positions::random_without_overlap);
  wall_in(scene, 1);
  expect_room<2>(scene);
  const auto species = shuffled_species(scene, {1, 0});
  const auto particles = placed<2>(scene);
  double lowest = HUGE_VAL;
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (species[i] == 0) lowest = std::min(lowest, particles[i].position[1]);
  EXPECT_LT(lowest, 1.0);
}

TEST(PlacementHard, RandomPlacesAvoidWallsAndObstacles) {
  Scene scene = hard_scene({20, 20}, 120, Positions::random_without_overlap);
  wall_in(scene, 0);
  wall_in(scene, 1);
  scene.obstacles = {obstacle_at({10, 10}, 5)};
  expect_room<2>(scene);
  EXPECT_NE(placed<2>(scene, 1)[0].position, placed<2>(scene, 0)[0].position);
}

TEST(PlacementHard, WhatDoesNotFitIsRefusedWithARemedy) {
  Scene dense = hard_scene({10.5, 10.5}, 125);
  EXPECT_NE(refusal(dense).find("triangular lattice of 125"), std::string::npos) << refusal(dense);
  EXPECT_NE(refusal(dense).find("larger domain"), std::string::npos);
  Scene blocked = hard_scene({10, 10}, 60);
  blocked.obstacles = {obstacle_at({5, 5}, 4)};
  EXPECT_NE(refusal(blocked).find("'initial.positions'"), std::string::npos);
  const Scene spheres = hard_scene({4.2, 4.2, 4.2}, 100);
  EXPECT_NE(refusal(spheres).find("face-centred cubic"), std::string::npos);
  const Scene random = hard_scene({20, 20}, 10, Positions::random);
  EXPECT_NE(refusal(random).find("overlap"), std::string::npos);
  blocked.initial.positions = Positions::random_without_overlap;
  EXPECT_NE(refusal(blocked).find("no room for particle"), std::string::npos);
}

}  // namespace
}  // namespace sandglass::placement_hard_test
