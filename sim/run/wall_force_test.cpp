#include "sim/base/error.hpp"
#include "sim/run/run.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace sandglass::wall_force_test {
namespace {

/// A bed on a vibrated floor, under a lid at rest, between rough walls or periodic sides.
Scene bed(const std::string& method, const std::string& side) {
  const std::string text = R"(
[run]
duration = {{ time = 5.0 }}
[domain]
dimension = 2
size = [15.0, 30.0]
sides = {{ x = "{}", y = "specular" }}
[[wall]]
side = "y-low"
restitution = 0.9
amplitude = 0.05
frequency = 1.5
[[species]]
count = 150
mass = 0.7
restitution = 0.9
[method]
{}
[forces]
gravity = [0.0, -1.0]
[initial]
positions = "lattice"
[[observe]]
what = "momentum"
every = {{ steps = 8 }}
[[observe]]
what = "wall-force"
every = {{ steps = 8 }}
)";
  return read_scene_text(fmt::format(fmt::runtime(text), side, method), "bed.toml");
}

const Series& series(const Record& record, const std::string& name) {
  for (const Series& series : record.replicas[0].series)
    if (series.quantity.name == name) return series;
  throw InputError("no series " + name);
}

/// Force on all walls = weight - rate of change of the momentum, between any two samples, to rounding: what collisions do
/// inside changes nothing.
void expect_balance(const Scene& scene) {
  const Record record = run_scene(scene);
  const Series &momentum = series(record, "momentum"), &force = series(record, "wall-force");
  const std::size_t components = force.quantity.size();
  ASSERT_EQ(momentum.samples(), force.samples() + 1);
  ASSERT_GT(force.samples(), 3u);
  const double mass = 150 * 0.7 * scene.method.weight;
  for (std::size_t sample = 0; sample < force.samples(); ++sample) {
    const double interval = momentum.time[sample + 1] - momentum.time[sample];
    for (std::size_t axis = 0; axis < 2; ++axis) {
      double total = 0;
      for (std::size_t i = axis; i < components; i += 2) total += force.value[sample * components + i];
      const double change = momentum.value[2 * (sample + 1) + axis] - momentum.value[2 * sample + axis];
      const double weight = axis == 1 ? -mass : 0;
      EXPECT_NEAR(total, weight - change / interval, 1e-11 * mass) << sample << " along " << axis;
    }
  }
}

const std::string cells = "cell-size = 1.5\ntime-step = 0.05\nweight = 2.0";
const std::string methods[] = {"preset = \"dsmc\"\n" + cells, "preset = \"cba\"\n" + cells,
                               "preset = \"collisionless\"\ntime-step = 0.05\nweight = 2.0",
                               "preset = \"event-driven\"\ntime-step = 0.05"};

TEST(WallForce, BalancesWeightAndMomentumInEveryMethod) {
  for (const std::string& method : methods)
    for (const char* side : {"periodic", "specular"}) {
      SCOPED_TRACE(method + side);
      expect_balance(bed(method, side));
    }
}

/// Plain walls have a flight of their own.
TEST(WallForce, BalancesBetweenPlainWalls) {
  for (const std::string& method : methods) {
    SCOPED_TRACE(method);
    Scene scene = bed(method, "specular");
    scene.walls.clear();
    expect_balance(scene);
  }
}

void watch(Scene& scene, std::initializer_list<const char*> words) {
  const Observe any = scene.observe.front();
  scene.observe.clear();
  for (const char* word : words) {
    scene.observe.push_back(any);
    scene.observe.back().what = word;
  }
}

/// Particles that lose nothing among themselves: what they gain, height and spin included, is the power of the walls less
/// the heat that these take.
void expect_energy_balance(const Scene& scene) {
  const Record record = run_scene(scene);
  const Series &centre = series(record, "centre-of-mass"), &power = series(record, "wall-power"),
               &heat = series(record, "wall-heat");
  const std::size_t across = centre.quantity.size(), sides = power.quantity.size();
  std::vector<double> energy = series(record, "energy").value;
  for (std::size_t i = 0; i < energy.size(); ++i) {
    energy[i] += 150 * 0.7 * scene.method.weight * centre.value[i * across + across - 1];
    if (scene.species[0].tangential_restitution > -1)
      energy[i] += series(record, "rotational-energy").value[i];
  }
  double taken = 0;
  for (std::size_t sample = 0; sample < power.samples(); ++sample) {
    double gain = 0;
    for (std::size_t at = sample * sides; at < (sample + 1) * sides; ++at) {
      gain += power.value[at] - heat.value[at];
      taken += std::abs(heat.value[at]);
    }
    gain *= centre.time[sample + 1] - centre.time[sample];
    EXPECT_NEAR(energy[sample + 1] - energy[sample], gain, 1e-10 * energy[0]) << sample;
  }
  EXPECT_GT(taken, 0.01 * energy[0]);
}

TEST(WallForce, PowerLessHeatIsWhatElasticParticlesGain) {
  for (const std::string& method : methods)
    for (const char* side : {"periodic", "specular"}) {
      if (method.find("cba") != std::string::npos) continue;  // an offset beyond the floor lifts a particle
      SCOPED_TRACE(method + side);
      Scene scene = bed(method, side);
      scene.species[0].restitution = 1;
      watch(scene, {"energy", "centre-of-mass", "wall-force"});
      expect_energy_balance(scene);
    }
}

/// Perfectly rough disks between a warm wall and a rough one that slides.
TEST(WallForce, HeatCountsSpinsAndThermalWalls) {
  Scene scene = bed(methods[3], "specular");
  scene.species[0].restitution = scene.species[0].tangential_restitution = 1;
  Wall warm, rough;
  warm.axis = rough.axis = 0;
  warm.surface.rule = SurfaceKind::thermal;
  warm.surface.temperature = 1.5;
  rough.high = true;
  rough.surface.tangential_restitution = 0.5;
  rough.velocity = {0, 2};
  scene.walls.push_back(warm);
  scene.walls.push_back(rough);
  watch(scene, {"energy", "rotational-energy", "centre-of-mass", "wall-force"});
  expect_energy_balance(scene);
}

/// An ideal gas presses with n T on a wall. Hits are independent, each gives 2 m v, and over those who come <v^2> is 2 T/m:
/// the momentum given by n hits has the variance 8 m T n.
TEST(WallForce, OfAGasIsItsPressure) {
  Scene scene = bed(methods[2], "periodic");
  scene.walls.clear();
  scene.gravity.clear();
  scene.method.weight = 1;
  scene.species[0].count = 20000;
  scene.species[0].diameter = 0.01;
  scene.initial.positions = Positions::random;
  scene.initial.temperature = 2;
  scene.initial.exact = false;
  const Record record = run_scene(scene);
  const Series& force = series(record, "wall-force");
  double low = 0, high = 0, time = 0;
  for (std::size_t sample = 0; sample < force.samples(); ++sample) {
    low -= force.value[4 * sample + 1] / static_cast<double>(force.samples());
    high += force.value[4 * sample + 3] / static_cast<double>(force.samples());
    time = force.time[sample];
  }
  const double pressure = 20000 / (15.0 * 30.0) * 2, expected = pressure * 15;
  const double speed = std::sqrt(2 / 0.7), hits = 20000 / 30.0 * speed / std::sqrt(2 * M_PI) * time;
  const double error = std::sqrt(hits * 8 * 0.7 * 2) / time;
  EXPECT_NEAR(low, expected, 4 * error);
  EXPECT_NEAR(high, expected, 4 * error);
  EXPECT_LT(4 * error, 0.1 * expected);
}

TEST(WallForce, GoesOnFromACheckpointBitwise) {
  for (const std::string& method : methods) {
    Scene scene = bed(method, "specular");
    const Record whole = run_scene(scene);
    scene.output.checkpoint = Cadence{Cadence::Unit::steps, 61};
    RunOptions options;
    options.checkpoint_path = testing::TempDir() + "wall_force.checkpoint.h5";
    run_scene(scene, options);
    const Record resumed = resume(read_record(options.checkpoint_path));
    for (const char* name : {"wall-force", "wall-power", "wall-heat"})
      EXPECT_EQ(series(resumed, name).value, series(whole, name).value) << method;
  }
}

TEST(WallForce, NeedsWalls) {
  Scene scene = bed(methods[0], "specular");
  scene.walls.clear();
  scene.gravity.clear();
  scene.domain.sides.assign(2, {Side::periodic, Side::periodic});
  EXPECT_THROW(run_scene(scene), InputError);
}

}  // namespace
}  // namespace sandglass::wall_force_test
