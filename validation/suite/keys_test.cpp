#include "validation/suite/keys.hpp"

#include "validation/suite/scene_keys.hpp"
#include "validation/suite/synthetic_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sandglass::keys_test {
namespace {

Scene scene_with(const std::string& more) {
  return read_scene_text(
      "title = \"keys\"\nrun = { duration = { steps = 5 } }\n"
      "domain = { dimension = 2, size = [10.0, 20.0], sides = { y = \"specular\" } }\n"
      "method = { preset = \"dsmc\", time-step = { collisions-per-particle = 0.1 } }\n" +
          more,
      "scene.toml");
}

const std::string kTwo =
    "species = [{ name = \"a\", count = 3, mass = 2.0 }, { name = \"b\", count = 50 }]\n";

TEST(SceneKeys, AreThoseThatReachAMethod) {
  const std::vector<std::string> keys = method_keys(scene_with(kTwo));
  for (const char* key : {"domain.size", "domain.sides.y", "species.mass", "species.count",
                          "method.time-step.collisions-per-particle", "initial.temperature"})
    EXPECT_THAT(keys, testing::Contains(key));
  for (const char* key : {"title", "run.seed", "species.name"})
    EXPECT_THAT(keys, testing::Not(testing::Contains(key)));
}

TEST(SceneKeys, NumbersOfAllTablesGrow) {
  const Scene scene = scene_with(kTwo);
  const auto mass = scaled_key(scene, "species.mass");
  ASSERT_TRUE(mass);
  EXPECT_EQ(mass->how, "5% more");
  EXPECT_NEAR(mass->scene.species[0].mass, 2.1, 1e-12);
  EXPECT_NEAR(mass->scene.species[1].mass, 1.05, 1e-12);
  EXPECT_NEAR(scaled_key(scene, "domain.size")->scene.domain.size[1], 21, 1e-12);
  EXPECT_EQ(scaled_key(scene, "species.count")->scene.species[0].count, 4U);
  EXPECT_EQ(scaled_key(scene, "species.count")->scene.species[1].count, 53U);
}

TEST(SceneKeys, WhatCannotGrowShrinks) {
  const auto smaller = scaled_key(scene_with(kTwo), "species.restitution");
  ASSERT_TRUE(smaller);
  EXPECT_EQ(smaller->how, "5% less");
  EXPECT_NEAR(smaller->scene.species[0].restitution, 0.95, 1e-12);
  EXPECT_FALSE(scaled_key(scene_with(kTwo), "method.preset"));
}

TEST(SceneKeys, AreLeftOutWhereTheSceneCanDoWithout) {
  const Scene scene = scene_with(kTwo);
  EXPECT_NEAR(dropped_key(scene, "species.mass")->scene.species[0].mass, 1, 1e-12);
  EXPECT_EQ(dropped_key(scene, "domain.sides.y")->scene.domain.sides[1][0], Side::periodic);
  EXPECT_FALSE(dropped_key(scene, "domain.dimension"));
  EXPECT_FALSE(dropped_key(scene, "species.diameter"));
  EXPECT_TRUE(is_default(scene, "species.diameter"));
  EXPECT_FALSE(is_default(scene, "domain.dimension"));
  EXPECT_FALSE(is_default(scene, "species.mass"));
}

const KeyResult& result_of(const std::vector<KeyResult>& results, const std::string& key) {
  return *std::ranges::find(results, key, &KeyResult::key);
}

TEST(Keys, ThoseThatNoVerdictSeesAreListed) {
  const SyntheticCase files;
  files.write_case(
      "[[point]]\nname = \"one\"\nset.species.restitution = 0.9\n[[variant]]\nname = \"dsmc\"\n[[check]]\n"
      "check = \"cooling-per-collision\"\nnumbers.settle-collisions = 2.0\n");
  const Case subject = read_case(files.folder().string());
  KeyOptions options;
  options.known = {"species.restitution", "wall.temperature", "run.seed", "domain.sides"};
  const std::vector<KeyResult> results = try_keys(expand(subject, "smoke", ""), options);
  EXPECT_TRUE(result_of(results, "species.restitution").seen());
  EXPECT_EQ(result_of(results, "species.restitution").trials.back().check, "cooling-per-collision");
  EXPECT_FALSE(result_of(results, "domain.size").seen());  // energy lost per collision is the same in any box
  EXPECT_EQ(result_of(results, "domain.size").trials.size(), 1U);
  EXPECT_FALSE(result_of(results, "species.mass").is_used);  // the default
  EXPECT_TRUE(result_of(results, "domain.dimension").is_used);
  EXPECT_TRUE(result_of(results, "domain.dimension").trials.empty());
  EXPECT_EQ(result_of(results, "wall.temperature").family, "");
  EXPECT_EQ(std::ranges::count(results, "run.seed", &KeyResult::key), 0);
}

}  // namespace
}  // namespace sandglass::keys_test
