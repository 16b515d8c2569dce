#include "sim/scene/test_bad_scene.hpp"

namespace sandglass::rules_single_test {
namespace {

const std::string ball = R"([run]
duration = { time = 10.0 }
[domain]
dimension = 2
size = [4.0, 20.0]
sides.y = "specular"
[[species]]
count = 1
[method]
preset = "event-driven"
time-step = 0.1
[initial]
positions = "lattice"
exact = false
[[observe]]
what = "energy"
)";

TEST(EventDrivenAlone, ASingleParticleNeedsWalls) {
  expect_refused(ball, {"", "count = 1", "count = 0", "8:9", {"gives 0 particles; at least 1 is needed"}});
  expect_refused(ball,
                 {"", "sides.y = \"specular\"\n", "", "7:9", {"gives 1 particle; at least 2 are needed"}});
}

TEST(EventDrivenAlone, ASingleParticleMeetsNoOther) {
  const std::string reason = "cannot serve a single particle, which collides with none: use a time or steps";
  expect_refused(ball, {"", "time = 10.0", "collisions-per-particle = 5", "2:12", {reason}});
  expect_refused(ball, {"", "= 0.1", "= { collisions-per-particle = 0.1 }", "11:13", {reason}});
  expect_refused(ball, {"", "", "every = { collisions-per-particle = 1 }", "17:9", {reason}});
}

TEST(EventDrivenAlone, ASingleParticleHasNoTemperatureAboutItsMean) {
  expect_refused(ball, {"", "exact = false", "exact = true", "14:9", {"whose mean velocity is its own"}});
}

TEST(EventDrivenAlone, AWalledAxisIsWiderThanAParticle) {
  EXPECT_NO_THROW(read_scene_text(spoiled(ball, {"", "20.0]", "1.01]", "", {}}), ""));
  expect_refused(ball, {"", "20.0]", "1.0]", "5:14", {"a walled axis must be more than 1 long"}});
}

TEST(EventDrivenAlone, APeriodicAxisHoldsFourParticles) {
  expect_refused(ball, {"", "[4.0", "[3.9", "5:9", {"a periodic axis must be at least 4 long, 4 times the"}});
}

TEST(EventDrivenAlone, ManySpeciesHaveALimit) {
  std::string text = spoiled(ball, {"", "count = 1", "count = 1\ndiameter = 0.1", "", {}});
  const auto with = [&text](int species) {
    std::string longer = text;
    for (int i = 1; i < species; ++i)
      longer += "[[species]]\nname = 's" + std::to_string(i) + "'\ncount = 1\ndiameter = 0.1\n";
    return longer;
  };
  EXPECT_NO_THROW(read_scene_text(with(255), ""));
  EXPECT_THROW(read_scene_text(with(256), ""), InputError);
}

TEST(EventDrivenAlone, ASceneMadeInCodeIsCheckedByTheSameRules) {
  Scene scene = read_scene_text(ball, "");
  scene.method.options = EventDrivenOptions{{CollapseGuard::none, 0, 1}};
  scene.walls = {{7, false, {}, {}, 0, 0}};
  try {
    validate(scene);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    for (const std::string word : {"not used by this collapse guard", "'wall.side' is ''"})
      EXPECT_THAT(error.what(), testing::HasSubstr(word));
  }
}

}  // namespace
}  // namespace sandglass::rules_single_test
