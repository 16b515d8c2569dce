#include "sim/base/error.hpp"
#include "sim/scene/method/family.hpp"
#include "sim/scene/scene.hpp"

#include <filesystem>

#include <gtest/gtest.h>

namespace sandglass::write_scene_test {
namespace {

DsmcOptions& dsmc_of(Scene& scene) { return std::get<DsmcOptions>(scene.method.options); }
Guard& guard_in(Scene& scene) { return std::get<EventDrivenOptions>(scene.method.options).guard; }

Scene plain_scene(int dimension) {
  Scene scene;
  scene.domain.dimension = dimension;
  scene.domain.size.assign(static_cast<std::size_t>(dimension), 10.0);
  scene.domain.sides.assign(static_cast<std::size_t>(dimension), {Side::periodic, Side::periodic});
  scene.species.emplace_back().count = 50;
  dsmc_of(scene).cell_size = 1.0;
  scene.method.time_step.fixed = 0.1;
  scene.run.duration.time = 10;
  return scene;
}

Scene event_driven_scene(int dimension) {
  Scene scene = plain_scene(dimension);
  choose(scene.method, "event-driven");
  scene.initial.positions = Positions::lattice;
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
  for (const Preset& preset : method_families().front()->presets)
    for (const ContactFactor factor : {ContactFactor::none, ContactFactor::local})
      for (const Offset offset : {Offset::none, Offset::consistent, Offset::corrected, Offset::random}) {
        Scene scene = plain_scene(2);
        scene.method.preset = preset.name;
        DsmcOptions& dsmc = dsmc_of(scene);
        dsmc.contact_factor = factor;
        dsmc.offset = offset;
        if (offset == Offset::random) dsmc.random_offset = 0.25;
        if (factor == ContactFactor::local) dsmc.density = DensityEstimate::cell;
        expect_round_trip(scene);
      }
}

TEST(WriteScene, NumbersReadBackToTheSameBits) {
  for (const double value : {0.1, 1.0 / 3, 1e-300, 4.9e-324, 1e17, 123456789.123456789, 2.0}) {
    Scene scene = plain_scene(2);
    scene.initial.temperature = value;
    scene.species[0].mass = std::max(value, 1e-100);
    scene.run.duration = {value, {}, {}};
    scene.method.time_step.fixed = value;
    expect_round_trip(scene);
  }
}

TEST(WriteScene, TextsWithQuotesAndControlCharactersReadBackEqual) {
  Scene scene = plain_scene(2);
  scene.title = "a \"quoted\" \\ title\n\twith \x01 and \x7f and \xc3\xa9";
  scene.output.record = "folder with space/x.h5";
  expect_round_trip(scene);
}

/// Of a periodic domain, or those that need walls along z; those of mixtures with the walls. Without that of regions.
std::vector<Observe> every_observer(bool walled) {
  std::vector<Observe> list;
  for (const ObserverKind& kind : observer_kinds()) {
    const bool needs_walls = kind.needs == ObserverSetting::bounded ||
                             kind.needs == ObserverSetting::mixture || kind.name == "free-surface";
    if (needs_walls != walled || kind.needs == ObserverSetting::regions) continue;
    Observe& observe = list.emplace_back();
    observe.what = kind.name;
    if (observer_uses(kind.name, "axis")) observe.axis = 2;
    if (observer_uses(kind.name, "position")) observe.position = 2.5;
    if (observer_uses(kind.name, "range")) observe.range = {{0.5, 4.0}};
    if (observer_uses(kind.name, "bins")) observe.bins = 17;
    if (observer_uses(kind.name, "grid")) observe.grid = {2, 30, 1};
  }
  return list;
}

TEST(WriteScene, EveryObserverReadsBackEqual) {
  Scene scene = event_driven_scene(3);
  scene.domain.sides[2] = {Side::specular, Side::specular};
  scene.species.push_back(scene.species[0]);
  scene.species[1].name = "other";
  scene.observe = every_observer(true);
  expect_round_trip(scene);
  scene = event_driven_scene(3);
  scene.species[0].tangential_restitution = 0.5;
  scene.observe = every_observer(false);
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
  dsmc_of(scene).cell_size.reset();
  dsmc_of(scene).cells = {4, 5};
  dsmc_of(scene).contact_factor = ContactFactor::local;
  dsmc_of(scene).density_window = 7;
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

TEST(WriteScene, EventDrivenScenesReadBackEqual) {
  for (const int dimension : {2, 3}) {
    Scene scene = event_driven_scene(dimension);
    expect_round_trip(scene);
    guard_in(scene) = {CollapseGuard::contact_time, 1e-5, 0};
    expect_round_trip(scene);
    guard_in(scene) = {CollapseGuard::velocity_dependent, 0, 0.25};
    scene.species[0].tangential_restitution = 0.3;
    scene.species[0].friction = 0.0;
    scene.species[0].inertia_factor = 0.75;
    scene.species.emplace_back().name = "second";
    scene.species[1].fraction = 0.125;
    scene.initial.spin_temperature = 0.5;
    scene.output.event_trace = "events \"1\".csv";
    expect_round_trip(scene);
  }
}

TEST(WriteScene, WallsAndObstaclesReadBackEqual) {
  Scene scene = event_driven_scene(2);
  for (auto& pair : scene.domain.sides) pair = {Side::specular, Side::specular};
  scene.walls = {{0, false, {SurfaceKind::specular, 0.5, 0.25, 0.1}, {}, 0, 0},
                 {0, true, {SurfaceKind::bounce_back, 0.75, -1, {}, 0.5}, {0.25, -1}, 0, 0},
                 {1, true, {SurfaceKind::thermal, 1, -1, {}, 1, 2.5}, {3, 0}, 0.125, 8},
                 {1, false, {SurfaceKind::random_tangential_sign, 0.9}, {}, 0.5, 0.1}};
  scene.obstacles = {{{5, 5}, 1.5, {SurfaceKind::specular, 0.9, 1}},
                     {{2.5, 5}, 0.25, {SurfaceKind::thermal, 1, -1, {}, 1, 0.5}}};
  expect_round_trip(scene);
}

TEST(WriteScene, GivenParticlesReadBackEqual) {
  for (const int dimension : {2, 3}) {
    Scene scene = event_driven_scene(dimension);
    scene.initial = {};
    scene.species[0].count.reset();
    scene.species[0].tangential_restitution = 0;
    scene.species.emplace_back().name = "second";
    const std::vector<double> here(static_cast<std::size_t>(dimension), 2.5), there(here.size(), 1.0 / 3);
    scene.given = {{here, there, {}, 0}, {there, here, std::vector<double>(dimension == 2 ? 1 : 3, -0.1), 1}};
    expect_round_trip(scene);
  }
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
}  // namespace sandglass::write_scene_test
