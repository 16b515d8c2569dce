#include "sim/base/error.hpp"
#include "sim/scene/observe/observers.hpp"
#include "sim/scene/scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sandglass::read_scene_test {
namespace {

using testing::ElementsAre;

/// A short scene with its method, and whatever else is given, as text.
Scene read(const std::string& method, const std::string& more = "") {
  return read_scene_text(
      "run.duration = { steps = 10 }\n"
      "[domain]\ndimension = 2\nsize = [10, 20]\n"
      "[[species]]\ncount = 20\n"
      "[method]\ncells = [2, 4]\ntime-step = 0.1\n" +
          method + '\n' + more,
      "scene.toml");
}

DsmcOptions chosen(const std::string& method) { return std::get<DsmcOptions>(read(method).method.options); }

TEST(ReadScene, DefaultsAreThoseOfTheStructs) {
  const Scene scene = read("");
  EXPECT_EQ(scene.run.seed, 1U);
  EXPECT_EQ(scene.run.replicas, 1U);
  EXPECT_EQ(scene.species.at(0).diameter, 1);
  EXPECT_EQ(scene.species.at(0).restitution, 1);
  EXPECT_EQ(scene.method.preset, "dsmc");
  EXPECT_EQ(scene.method.weight, 1);
  EXPECT_EQ(scene.initial, Initial());
  EXPECT_EQ(scene.output, Output());
  EXPECT_TRUE(scene.gravity.empty());
  for (const auto& pair : scene.domain.sides) EXPECT_EQ(pair[0], Side::periodic);
}

TEST(ReadScene, WholeNumbersServeAsNumbers) {
  const Scene scene = read("", "[forces]\ngravity = [0, 0]\n[initial]\nvelocity = [1, -2]");
  EXPECT_THAT(scene.domain.size, ElementsAre(10.0, 20.0));
  EXPECT_THAT(scene.initial.velocity, ElementsAre(1.0, -2.0));
}

TEST(ReadScene, GravityOfNoStrengthIsNoGravity) {
  EXPECT_TRUE(read("", "[forces]\ngravity = [0.0, 0.0]").gravity.empty());
}

TEST(ReadScene, APresetFillsInItsChoices) {
  EXPECT_EQ(chosen("preset = 'dsmc'").contact_factor, ContactFactor::none);
  EXPECT_EQ(chosen("preset = 'dsmc-enskog'").contact_factor, ContactFactor::local);
  EXPECT_EQ(chosen("preset = 'dsmc-enskog'").offset, Offset::none);
  EXPECT_EQ(chosen("preset = 'cba'").offset, Offset::consistent);
  EXPECT_EQ(chosen("preset = 'cba-corrected'").offset, Offset::corrected);
  EXPECT_EQ(chosen("preset = 'cuba'").offset, Offset::random);
  EXPECT_EQ(chosen("preset = 'cuba'").random_offset, 0.5);
}

TEST(ReadScene, AnOverrideWinsOverThePresetWhicheverComesFirst) {
  const Method method = read("offset = 'consistent'\npreset = 'cuba'\ncontact-factor = 'none'").method;
  EXPECT_EQ(method.preset, "cuba");
  const DsmcOptions& dsmc = std::get<DsmcOptions>(method.options);
  EXPECT_EQ(dsmc.offset, Offset::consistent);
  EXPECT_EQ(dsmc.contact_factor, ContactFactor::none);
  EXPECT_EQ(dsmc.random_offset, 0);
}

TEST(ReadScene, OneWordOrTwoNameTheSidesOfAnAxis) {
  const Scene one = read("", "[domain.sides]\ny = 'specular'");
  const Scene two = read("", "[domain.sides]\ny = ['specular', 'specular']");
  EXPECT_EQ(one.domain, two.domain);
  EXPECT_EQ(one.domain.sides[0][1], Side::periodic);
  EXPECT_EQ(one.domain.sides[1][1], Side::specular);
}

TEST(ReadScene, ATimeStepIsANumberOrCollisions) {
  EXPECT_EQ(read("").method.time_step.fixed, 0.1);
  const std::string text =
      "run.duration.time = 1.0\ndomain = { dimension = 3, size = [3, 3, 3] }\n"
      "species = [{ volume-fraction = 0.1 }]\n"
      "method = { cell-size = 1, time-step.collisions-per-particle = 0.2 }";
  EXPECT_EQ(read_scene_text(text, "").method.time_step, (TimeStep{{}, 0.2}));
}

TEST(ReadScene, ANumberLargerThanAnIntegerIsRefusedWithItsPlace) {
  try {
    read("weight = 99999999999999999999");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.diagnostics().size(), 1U);
    EXPECT_EQ(error.diagnostics()[0].line, 10);
    EXPECT_THAT(error.what(), testing::HasSubstr("not valid TOML"));
  }
}

TEST(ReadScene, AMissingFileIsNamedWithTheReason) {
  try {
    read_scene_file("/no/such/scene.toml");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'/no/such/scene.toml': No such file"));
  }
}

TEST(ReadScene, AFolderIsNotAScene) { EXPECT_THROW(read_scene_file(SANDGLASS_SOURCE_DIR), InputError); }

}  // namespace
}  // namespace sandglass::read_scene_test
