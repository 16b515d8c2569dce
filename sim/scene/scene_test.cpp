#include "sim/scene/scene.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace sandglass::scene_test {
namespace {

Scene box(int dimension, double edge, double weight) {
  Scene scene;
  scene.domain.dimension = dimension;
  scene.domain.size.assign(static_cast<std::size_t>(dimension), edge);
  scene.method.weight = weight;
  return scene;
}

TEST(Scene, VolumeIsTheProductOfTheEdges) {
  Scene scene = box(3, 2, 1);
  scene.domain.size = {2, 3, 0.5};
  EXPECT_DOUBLE_EQ(volume(scene.domain), 3);
}

TEST(Scene, AParticleIsADiskOrASphere) {
  Species species;
  species.diameter = 2;
  EXPECT_DOUBLE_EQ(particle_volume(species, 2), std::numbers::pi);
  EXPECT_DOUBLE_EQ(particle_volume(species, 3), 4 * std::numbers::pi / 3);
}

TEST(Scene, CountFollowsFromTheFraction) {
  const Scene scene = box(2, 10, 1);
  Species species;
  species.fraction = std::numbers::pi / 4 * 0.37;
  EXPECT_EQ(particle_count(scene, species), 37U);
  EXPECT_DOUBLE_EQ(fraction(scene, species), *species.fraction);
}

TEST(Scene, CountFollowsFromTheNumberDensityAndTheWeight) {
  const Scene scene = box(3, 10, 0.25);
  Species species;
  species.number_density = 0.02;
  EXPECT_EQ(particle_count(scene, species), 80U);
  EXPECT_DOUBLE_EQ(number_density(scene, species), 0.02);
}

TEST(Scene, DensityFollowsFromTheCountAndTheWeight) {
  const Scene scene = box(2, 10, 3);
  Species species;
  species.count = 10;
  EXPECT_DOUBLE_EQ(number_density(scene, species), 0.3);
  EXPECT_DOUBLE_EQ(fraction(scene, species), 0.3 * std::numbers::pi / 4);
}

TEST(Scene, SpeciesAddUp) {
  Scene scene = box(2, 10, 1);
  scene.species.resize(2);
  scene.species[0].count = 3;
  scene.species[1] = {"large", 4, {}, {}, 2};
  EXPECT_EQ(particle_count(scene), 7U);
  EXPECT_DOUBLE_EQ(fraction(scene), (3 + 4 * 4) * std::numbers::pi / 4 / 100);
  EXPECT_EQ(largest_diameter(scene), 2);
}

TEST(Scene, CountFollowsFromTheParticlesThatAreGiven) {
  Scene scene = box(2, 10, 1);
  scene.species.resize(2);
  scene.species[1].name = "other";
  scene.given = {{{1, 1}, {0, 0}, {}, 1}, {{5, 5}, {0, 0}, {}, 1}, {{8, 8}, {0, 0}, {}, 0}};
  EXPECT_EQ(particle_count(scene, scene.species[0]), 1U);
  EXPECT_EQ(particle_count(scene, scene.species[1]), 2U);
  EXPECT_EQ(particle_count(scene), 3U);
}

TEST(Scene, TotalsDoNotOverflow) {
  Scene scene = box(2, 1e10, 1);
  scene.species.resize(3);
  for (Species& species : scene.species) species.number_density = 1e10;
  EXPECT_GE(particle_count(scene), 9'200'000'000'000'000'000U);
}

/// I = q m R^2 with q = int r^2 dV / (R^2 V) about a diameter axis: disk int_0^1 r^3 dr / int_0^1 r dr, sphere
/// (2/3) int_0^1 r^4 dr / int_0^1 r^2 dr.
TEST(Scene, InertiaIsThatOfAFullDiskOrSphere) {
  Species species;
  EXPECT_DOUBLE_EQ(inertia_factor(species, 2), (1.0 / 4) / (1.0 / 2));
  EXPECT_DOUBLE_EQ(inertia_factor(species, 3), 2.0 / 3 * (1.0 / 5) / (1.0 / 3));
  species.inertia_factor = 1;
  EXPECT_EQ(inertia_factor(species, 3), 1);
}

TEST(Scene, AnyRoughContactMakesItRough) {
  Scene scene = box(2, 10, 1);
  scene.species.resize(2);
  EXPECT_FALSE(is_rough(scene));
  for (const int which : {0, 1, 2}) {
    Scene rough = scene;
    rough.walls.resize(1);
    rough.obstacles.resize(1);
    EXPECT_FALSE(is_rough(rough));
    if (which == 0) rough.species[1].tangential_restitution = 0;
    if (which == 1) rough.walls[0].surface.tangential_restitution = 1;
    if (which == 2) rough.obstacles[0].surface.tangential_restitution = -0.5;
    EXPECT_TRUE(is_rough(rough)) << which;
  }
}

TEST(Scene, AnAbsurdDensityGivesALargeCountRatherThanAnOverflow) {
  const Scene scene = box(2, 1e10, 1);
  Species species;
  species.number_density = 1e10;
  EXPECT_GT(particle_count(scene, species), 9'000'000'000'000'000'000U);
}

}  // namespace
}  // namespace sandglass::scene_test
