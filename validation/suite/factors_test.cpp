#include "validation/suite/factors.hpp"

#include "sim/base/error.hpp"
#include "validation/suite/overlay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sandglass::factors_test {
namespace {

using testing::HasSubstr;

constexpr const char* base_text =
    "run = { replicas = 20, duration.time = 10.0 }\n[domain]\ndimension = 2\nsize = [10.0, 20.0]\n"
    "[[species]]\ncount = 100\n[method]\ncell-size = 5.0\ntime-step = 0.1\n";

Scene multiplied(const Factors& factors, const std::string& set = "") {
  const Override over{parse_document(set, "over.toml"), "over.toml", factors};
  return lay_over(parse_document(base_text, "base.toml"), "base.toml", {&over});
}

std::string error_of(const Factors& factors, const std::string& set = "") {
  try {
    multiplied(factors, set);
  } catch (const InputError& error) {
    return error.diagnostics().front().text();
  }
  return "";
}

TEST(Factors, OfOneChangeNothing) {
  EXPECT_EQ(write_scene(multiplied({})), write_scene(read_scene_text(base_text, "base.toml")));
}

TEST(Factors, MultiplyReplicasAndDuration) {
  const Scene scene = multiplied({.replicas = 0.25, .duration = 2});
  EXPECT_EQ(scene.run.replicas, 5U);
  EXPECT_EQ(scene.run.duration.time, 20);
  EXPECT_EQ(multiplied({.duration = 0.5}, "run.duration = { time = {}, steps = 5 }").run.duration.steps, 3U)
      << "rounded";
}

TEST(Factors, ComeAfterTheirOwnOverride) {
  EXPECT_EQ(multiplied({.replicas = 3}, "run.replicas = 2").run.replicas, 6U);
}

TEST(Factors, ReplicasThatNobodyGaveAreOne) {
  EXPECT_EQ(multiplied({.replicas = 4}, "run.replicas = {}").run.replicas, 4U);
}

TEST(Factors, SizeKeepsTheDensity) {
  const Scene scene = multiplied({.size = 4});
  EXPECT_EQ(scene.species.at(0).count, 400U);
  EXPECT_NEAR(scene.domain.size.at(0), 20, 1e-12);
  EXPECT_NEAR(scene.domain.size.at(1), 40, 1e-12);
  const Scene fitted = multiplied({.size = 4}, "domain.size = {}\nspecies.area-fraction = 0.25");
  EXPECT_NEAR(fitted.domain.size.at(0), std::sqrt(400 * 3.14159265358979 / 4 / 0.25), 1e-9);
}

TEST(Factors, LessThanOneIsRefusedWhereTheFactorStands) {
  EXPECT_THAT(
      error_of({.replicas = 0.04, .place = {7, 3}}),
      testing::AllOf(HasSubstr("over.toml:7:3"), HasSubstr("leaves less than one of 20 'run.replicas'")));
  EXPECT_THAT(error_of({.size = 0.001}), HasSubstr("'species.count'"));
}

TEST(Factors, WhatTheSceneLacksIsNamed) {
  EXPECT_THAT(error_of({.size = 2}, "method = { cell-size = {}, cells = [5, 5] }"),
              HasSubstr("'method.cell-size'"));
  EXPECT_THAT(error_of({.size = 2}, "species = { count = {}, area-fraction = 0.1 }"),
              HasSubstr("needs the 'count'"));
}

}  // namespace
}  // namespace sandglass::factors_test
