#include "sim/base/random.hpp"
#include "sim/scene/test_bad_scene.hpp"

#include <cmath>

namespace sandglass::rules_given_test {
namespace {

const std::string good = R"([run]
duration = { time = 10.0 }
[domain]
dimension = 2
size = [10.0, 20.0]
sides.y = "specular"
[[species]]
name = "small"
tangential-restitution = 0.5
[[species]]
name = "large"
diameter = 2.0
[[obstacle]]
centre = [5.0, 10.0]
radius = 1.0
[method]
preset = "event-driven"
time-step = 0.1
[initial]
positions = "given"
[[particle]]
position = [0.25, 4.1]
velocity = [1.0, 0.0]
spin = -2.0
[[particle]]
position = [9.25, 4.1]
velocity = [0.0, 0.0]
species = "small"
[[particle]]
position = [5.0, 1.0]
velocity = [0.0, 1.0]
species = "large"
)";

class Given : public testing::TestWithParam<BadEdit> {};

TEST_P(Given, IsRefusedWithPlaceAndReason) { expect_refused(good, GetParam()); }

const std::vector<BadEdit> given_edits = {
    {"temperature",
     "\"given\"",
     "\"given\"\ntemperature = 1.0",
     "21:1",
     {"'initial.temperature' cannot be used with positions = \"given\""}},
    {"exact", "\"given\"", "\"given\"\nexact = false", "21:1", {"'initial.exact' cannot be used"}},
    {"stream",
     "\"given\"",
     "\"given\"\nvelocity = [0.0, 0.0]",
     "21:1",
     {"'initial.velocity' cannot be used"}},
    {"count",
     "name = \"small\"\n",
     "name = \"small\"\ncount = 2\n",
     "9:1",
     {"'species.count' cannot be used with positions = \"given\""}},
    {"fraction",
     "name = \"small\"\n",
     "name = \"small\"\narea-fraction = 0.2\n",
     "9:1",
     {"'species.area-fraction' cannot be used"}},
    {"no_position", "position = [5.0, 1.0]\n", "", "29:1", {"missing 'particle.position'"}},
    {"no_velocity", "velocity = [0.0, 1.0]\n", "", "29:1", {"missing 'particle.velocity'"}},
    {"position_of_3d", "[5.0, 1.0]", "[5.0, 1.0, 5.0]", "30:12", {"'particle.position' has 3 components"}},
    {"velocity_of_1d", "[0.0, 1.0]", "[1.0]", "31:12", {"'particle.velocity' has 1 component,"}},
    {"spin_of_3d",
     "spin = -2.0",
     "spin = [0, 0, 1]",
     "24:8",
     {"'particle.spin' must be a number, not a list"}},
    {"spin_smooth", "tangential-restitution = 0.5\n", "", "23:8", {"'particle.spin' needs rough contacts"}},
    {"species",
     "= \"small\"\n[[particle]]",
     "= \"tiny\"\n[[particle]]",
     "28:11",
     {"unknown species 'tiny'", "'small' or 'large'"}},
    {"outside",
     "[0.25, 4.1]",
     "[10.0, 4.1]",
     "22:13",
     {"'particle.position' is 10 along x, outside the domain; allowed: 0 to 10"}},
    {"in_wall",
     "[5.0, 1.0]",
     "[5.0, 0.9]",
     "30:18",
     {"is 0.9 along y, so that the particle overlaps a wall; allowed: 1 to 19"}},
    {"across_seam",
     "[0.25, 4.1]",
     "[0.2, 4.1]",
     "26:12",
     {"particle 2 overlaps particle 1 (counted from 1): their centres are 0.95 apart, at least 1 is needed"}},
    {"in_obstacle",
     "[5.0, 1.0]",
     "[5.0, 8.1]",
     "30:12",
     {"particle 3 overlaps obstacle 1", "1.9 apart, at least 2 is needed"}},
    {"equilibrate",
     "\"given\"",
     "\"given\"\nequilibrate-collisions-per-particle = 1.0",
     "21:1",
     {"'initial.equilibrate-collisions-per-particle' cannot be used"}},
};

INSTANTIATE_TEST_SUITE_P(Given, Given, testing::ValuesIn(given_edits), edit_name);

TEST(GivenTogether, ReadsWhatItIsGiven) {
  const Scene scene = read_scene_text(good, "");
  ASSERT_EQ(scene.given.size(), 3U);
  EXPECT_EQ(scene.given[0], (GivenParticle{{0.25, 4.1}, {1, 0}, {-2}, 0}));
  EXPECT_EQ(scene.given[1], (GivenParticle{{9.25, 4.1}, {0, 0}, {}, 0}));
  EXPECT_EQ(scene.given[2], (GivenParticle{{5, 1}, {0, 1}, {}, 1}));
  EXPECT_EQ(particle_count(scene, scene.species[0]), 2U);
  EXPECT_EQ(scene.initial, Initial());
}

/// Particles 1 and 2 of the good scene touch across the seam, where rounding makes 9.25 - 0.25 + 1 inexact
/// elsewhere: moved together they must still be accepted.
TEST(GivenTogether, ParticlesMayTouch) {
  for (const double shift : {0.1, 0.3, 1.0 / 3, 0.7}) {
    Scene scene = read_scene_text(good, "");
    scene.given[0].position[0] = shift;
    scene.given[1].position[0] = shift + 1;
    EXPECT_NO_THROW(validate(scene)) << shift;
    scene.given[1].position[0] = shift + 1 - 1e-6;
    EXPECT_THROW(validate(scene), InputError) << shift;
  }
}

TEST(GivenTogether, EachPairAndEachErrorIsNamed) {
  Scene scene = read_scene_text(good, "");
  scene.given[1].position = scene.given[0].position;
  scene.given[2].position = scene.given[0].position;
  try {
    validate(scene);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().size(), 3U) << error.what();
    EXPECT_THAT(error.what(), testing::HasSubstr("particle 3 overlaps particle 2"));
  }
}

/// The slow twin of the search along x: every pair, in the order of the diagnostics.
std::vector<std::string> overlaps_of_every_pair(const Scene& scene) {
  std::vector<std::string> words;
  const auto radius = [&](std::size_t i) { return scene.species[scene.given[i].species].diameter / 2; };
  const auto hold = [&](std::size_t i, const std::vector<double>& centre, double other,
                        const std::string& word) {
    double step[2] = {scene.given[i].position[0] - centre[0], scene.given[i].position[1] - centre[1]};
    step[0] = std::remainder(step[0], scene.domain.size[0]);
    if (std::hypot(step[0], step[1]) < radius(i) + other)
      words.push_back("particle " + std::to_string(i + 1) + " overlaps " + word + " (");
  };
  for (std::size_t i = 0; i < scene.given.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      hold(i, scene.given[j].position, radius(j), "particle " + std::to_string(j + 1));
    for (std::size_t j = 0; j < scene.obstacles.size(); ++j)
      hold(i, scene.obstacles[j].centre, scene.obstacles[j].radius, "obstacle " + std::to_string(j + 1));
  }
  return words;
}

TEST(GivenTogether, EveryOverlapAmongManyIsNamedInOrder) {
  Scene scene = read_scene_text(good, "");
  scene.domain.size = {60, 80};
  Random random(StreamKey(3, Purpose::positions, 0, 0), 0);
  const auto place = [&](double margin) {
    return std::vector<double>{margin + (60 - 2 * margin) * random.uniform(),
                               margin + (80 - 2 * margin) * random.uniform()};
  };
  scene.obstacles.assign(150, scene.obstacles.front());
  for (Obstacle& obstacle : scene.obstacles) {
    obstacle.radius = 0.1 + random.uniform();
    obstacle.centre = place(obstacle.radius + 2);
  }
  scene.given.assign(300, {{}, {0, 0}, {}, 0});
  for (GivenParticle& particle : scene.given) {
    particle.species = random.uniform() < 0.2 ? 1 : 0;
    particle.position = {60 * random.uniform(), 1 + 78 * random.uniform()};
  }
  const std::vector<std::string> expected = overlaps_of_every_pair(scene);
  ASSERT_GT(expected.size(), 50U);
  try {
    validate(scene);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.diagnostics().size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_THAT(error.diagnostics()[i].message, testing::HasSubstr(expected[i]));
  }
}

TEST(GivenTogether, SpinsOfSpheresHaveThreeComponents) {
  Scene scene = read_scene_text(good, "");
  scene.given[0].spin = {1, 2, 3};
  EXPECT_THROW(validate(scene), InputError);
  scene.domain = {3, {10, 20, 10}, {{}, {Side::specular, Side::specular}, {}}};
  scene.obstacles.clear();
  for (GivenParticle& particle : scene.given) {
    particle.position.push_back(5);
    particle.velocity.push_back(0);
  }
  EXPECT_NO_THROW(validate(scene));
  scene.given[0].spin = {1};
  EXPECT_THROW(validate(scene), InputError);
}

TEST(GivenTogether, NoInitialStateIsDrawnBesideThem) {
  Scene scene = read_scene_text(good, "");
  scene.initial.temperature = 2;
  EXPECT_THROW(validate(scene), InputError);
}

TEST(GivenTogether, AWordWithoutParticlesIsRefused) {
  const std::string text = good.substr(0, good.find("[[particle]]"));
  try {
    read_scene_text(text, "scene.toml");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().size(), 1U) << error.what();
    EXPECT_THAT(error.what(), testing::HasSubstr("missing 'particle': positions = \"given\" needs"));
  }
}

TEST(GivenTogether, OtherMethodsPlacePointsAnywhereInTheBox) {
  const std::string text =
      "run.duration.time = 1.0\ndomain = { dimension = 2, size = [3, 3], sides.y = 'specular' }\n"
      "species = [{ mass = 2 }]\nmethod = { time-step = 0.1 }\ninitial.positions = 'given'\n"
      "particle = [{ position = [1, 0], velocity = [1, 0] }, { position = [1.5, 3], velocity = [0, 0] }]";
  EXPECT_EQ(particle_count(read_scene_text(text, "")), 2U);
  EXPECT_THROW(read_scene_text(text + "\n[output]\nevent-trace = 'x'", ""), InputError);
}

}  // namespace
}  // namespace sandglass::rules_given_test
