#include "sim/base/error.hpp"
#include "sim/scene/catalogue.hpp"
#include "sim/scene/scene.hpp"

#include <filesystem>

#include <gtest/gtest.h>

namespace sandglass {
namespace {

Scene plain_scene(int dimension) {
  Scene scene;
  scene.domain.dimension = dimension;
  scene.domain.size.assign(static_cast<std::size_t>(dimension), 10.0);
  scene.domain.sides.assign(static_cast<std::size_t>(dimension), {Side::periodic, Side::periodic});
  scene.species.emplace_back().count = 50;
  scene.method.cell_size = 1.0;
  scene.method.time_step.fixed = 0.1;
  scene.run.duration.time = 10;
  return scene;
}

void expect_round_trip(const Scene& scene) {
  ASSERT_NO_THROW(validate(scene)) << write_scene(scene);
  const std::string text = write_scene(scene);
  const Scene again = read_scene_text(text, "written.toml");
  EXPECT_EQ(again, scene) << text;
  EXPECT_EQ(write_scene(again), text);
}

TEST(WriteScene, PlainScenesReadBackEqual) {
  expect_round_trip(plain_scene(2));
  expect_round_trip(plain_scene(3));
}

TEST(WriteScene, EveryChoiceOfAPresetReadsBackEqual) {
  for (const Preset& preset : presets())
    for (const ContactFactor factor : {ContactFactor::none, ContactFactor::local})
      for (const Offset offset : {Offset::none, Offset::consistent, Offset::corrected, Offset::random}) {
        if (preset.name == reservoir_preset) continue;
        Scene scene = plain_scene(2);
        scene.method.preset = preset.name;
        scene.method.contact_factor = factor;
        scene.method.offset = offset;
        if (offset == Offset::random) scene.method.random_offset = 0.25;
        if (factor == ContactFactor::local) scene.method.density = DensityEstimate::cell;
        expect_round_trip(scene);
      }
}

TEST(WriteScene, NumbersReadBackToTheSameBits) {
  for (const double value : {0.1, 1.0 / 3, 1e-300, 4.9e-324, 1e17, 123456789.123456789, 2.0}) {
    Scene scene = plain_scene(2);
    scene.initial.temperature = value;
    scene.species[0].mass = value;
    scene.run.duration = {value, {}, {}};
    expect_round_trip(scene);
  }
}

TEST(WriteScene, TextsWithQuotesAndControlCharactersReadBackEqual) {
  Scene scene = plain_scene(2);
  scene.title = "a \"quoted\" \\ title\n\twith \x01 and \x7f and \xc3\xa9";
  scene.output.record = "folder with space/x.h5";
  expect_round_trip(scene);
}

TEST(WriteScene, EveryObserverReadsBackEqual) {
  Scene scene = plain_scene(3);
  for (const std::string& what : observer_names()) {
    Observe& observe = scene.observe.emplace_back();
    observe.what = what;
    if (observer_uses(what, "axis")) observe.axis = 2;
    if (observer_uses(what, "position")) observe.position = 2.5;
    if (observer_uses(what, "range")) observe.range = {{-3.5, 4.0}};
    if (observer_uses(what, "bins")) observe.bins = 17;
    if (observer_uses(what, "grid")) observe.grid = {1, 2, 30};
  }
  scene.observe[0].cadence = {Cadence::Unit::time, 0.125};
  scene.observe[1].cadence = {Cadence::Unit::collisions, 1.5};
  scene.observe[2].cadence = {Cadence::Unit::steps, 7};
  expect_round_trip(scene);
}

TEST(WriteScene, EveryOtherKeyReadsBackEqual) {
  Scene scene = plain_scene(2);
  scene.domain.sides[1] = {Side::specular, Side::specular};
  scene.gravity = {0, -0.5};
  scene.species[0] = {"bead_1", {}, 0.3, {}, 1.25, 2.5, 0.85};
  scene.method.cell_size.reset();
  scene.method.cells = {4, 5};
  scene.method.time_step = {{}, 0.2};
  scene.initial.positions = Positions::random_without_overlap;
  scene.initial.velocity = {1, -2};
  scene.initial.exact = false;
  scene.initial.equilibrate_collisions = 3.5;
  scene.output.trajectory = Cadence{Cadence::Unit::steps, 3};
  scene.output.checkpoint = Cadence{Cadence::Unit::time, 2.5};
  scene.output.ids = true;
  scene.run = {9223372036854775807U, 12, {{}, 1000, {}}};
  expect_round_trip(scene);
}

TEST(WriteScene, ShearWaveAndWeightReadBackEqual) {
  Scene scene = plain_scene(2);
  scene.species[0].count.reset();
  scene.species[0].number_density = 2.0;
  scene.species[0].diameter = 0.1;
  scene.method.weight = 0.25;
  scene.initial.shear_wave = ShearWave{-0.1, 3};
  expect_round_trip(scene);
}

TEST(WriteScene, ExamplesOfTheDocumentationReadBackEqual) {
  int examples = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SANDGLASS_SOURCE_DIR "/docs/examples")) {
    if (entry.path().extension() != ".toml") continue;
    expect_round_trip(read_scene_file(entry.path().string()));
    ++examples;
  }
  EXPECT_GE(examples, 5);
}

}  // namespace
}  // namespace sandglass
