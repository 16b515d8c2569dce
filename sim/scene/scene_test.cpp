#include "sim/scene/scene.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace sandglass {
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

TEST(Scene, AnAbsurdDensityGivesALargeCountRatherThanAnOverflow) {
  const Scene scene = box(2, 1e10, 1);
  Species species;
  species.number_density = 1e10;
  EXPECT_GT(particle_count(scene, species), 9'000'000'000'000'000'000U);
}

}  // namespace
}  // namespace sandglass
