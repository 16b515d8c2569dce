#include "validation/check/free_flight.hpp"

#include "validation/check/check.hpp"
#include "validation/check/synthetic.hpp"
#include "validation/law/free_molecular.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

// Each check sees data drawn from its law, and data from a law that is off.

namespace sandglass::free_flight_test {
namespace {

using namespace synthetic;
using std::numbers::pi;

const std::string head =
    "[run]\nduration = { time = 0.5 }\n[[species]]\ncount = 1000\ndiameter = 1e-8\n"
    "[method]\npreset = \"dsmc\"\ntime-step = 0.25\n";

Record record_with(const std::string& scene, std::size_t replicas) {
  Record record;
  record.scene = head + scene;
  record.replicas.resize(replicas);
  return record;
}

double significance(const Evidence& evidence) {
  return (std::abs(evidence.value - evidence.expected) - evidence.budget.systematic) /
         evidence.standard_error;
}

Series& add_fields(Record& record, std::size_t replica, std::size_t bins) {
  Series& series = add_series(record, replica, "fields", {});
  series.quantity.shape = {1, bins, 4};
  return series;
}

/// Samples of 'temperature' and 'fields' in four bins, all with noise of one part in a hundred.
struct Bins {
  std::function<double(std::size_t)> density;
  double temperature = 1;
  double along_x = 1;  ///< factor on the temperature along x
};

void fill(Record& record, const Bins& bins) {
  Generator generator(7);
  std::normal_distribution<double> noise(1, 0.01);
  for (std::size_t replica = 0; replica < record.replicas.size(); ++replica) {
    Series& temperature = add_series(record, replica, "temperature", {"x", "y", "total"});
    for (int sample = 1; sample <= 40; ++sample) {
      const double x = bins.temperature * bins.along_x * noise(generator),
                   y = bins.temperature * noise(generator);
      add_sample(temperature, 1000 * sample, {x, y, (x + y) / 2});
    }
    Series& fields = add_fields(record, replica, 4);
    for (int sample = 1; sample <= 40; ++sample) {
      std::vector<double> values;
      for (std::size_t bin = 0; bin < 4; ++bin)
        values.insert(values.end(),
                      {bins.density(bin) * noise(generator), 0, 0, bins.temperature * noise(generator)});
      add_sample(fields, 1000 * sample, values);
    }
  }
}

double between_walls(const Bins& bins) {
  Record record = record_with(
      "[domain]\ndimension = 2\nsize = [1.0, 1.0]\nsides = { y = \"specular\" }\n"
      "[[wall]]\nside = \"y-low\"\nrule = \"thermal\"\ntemperature = 1.0\n"
      "[[wall]]\nside = \"y-high\"\nrule = \"thermal\"\ntemperature = 4.0\n",
      16);
  fill(record, bins);
  return significance(run_check(find_check("gas-between-walls"), record, {{{"settle-time", 1.0}}, 0, 0, ""}));
}

TEST(GasBetweenWalls, SeesTemperatureIsotropyAndDensity) {
  const auto even = [](std::size_t) { return 1000.0; };
  const auto tilted = [](std::size_t bin) { return 970.0 + 20.0 * static_cast<double>(bin); };
  EXPECT_LT(between_walls({even, 2.0}), 4);
  EXPECT_GT(between_walls({even, 2.1}), 10);
  EXPECT_GT(between_walls({even, 2.0, 1.05}), 10);
  EXPECT_GT(between_walls({tilted, 2.0}), 10);
}

const std::string column_scene =
    "[domain]\ndimension = 2\nsize = [1.0, 1.0]\nsides = { y = \"specular\" }\n"
    "[forces]\ngravity = [0.0, -2.0]\n";

double column(double drawn_gravity, const Bins& bins) {
  Record record = record_with(column_scene, 16);
  Bins drawn = bins;
  drawn.density = [=](std::size_t bin) {
    const double low = static_cast<double>(bin) / 4, rate = drawn_gravity / bins.temperature;
    return 4000 * (std::exp(-rate * low) - std::exp(-rate * (low + 0.25))) / (1 - std::exp(-rate));
  };
  fill(record, drawn);
  return significance(run_check(find_check("barometric-column"), record, {{{"settle-time", 1.0}}, 0, 0, ""}));
}

TEST(BarometricColumn, SeesProfileAndIsotropy) {
  EXPECT_LT(column(2.0, {{}, 1.3}), 4);
  EXPECT_GT(column(2.2, {{}, 1.3}), 10);
  EXPECT_GT(column(-2.0, {{}, 1.3}), 10);
  EXPECT_GT(column(2.0, {{}, 1.3, 1.05}), 10);
}

double drag(double factor, const std::string& surface, double accommodation) {
  Record record = record_with(
      "[domain]\ndimension = 2\nsize = [5.0, 5.0]\n[initial]\nvelocity = [1.0, 0.0]\n"
      "[[obstacle]]\ncentre = [2.5, 2.5]\nradius = 1.0\n" +
          surface,
      16);
  law::StreamPastObstacle stream{2, 1000 / (25 - pi), 1, 1, 1, 1, 1.5, accommodation, 0};
  const double lost = 0.5 * factor * law::free_molecular_drag(stream);
  Generator generator(3);
  std::normal_distribution<double> noise(1, 0.01);
  for (std::size_t replica = 0; replica < 16; ++replica) {
    Series& momentum = add_series(record, replica, "momentum", {"x", "y"});
    add_sample(momentum, 0, {1000, 0});
    add_sample(momentum, 0.5, {1000 - lost * noise(generator), 0});
  }
  return significance(run_check(find_check("obstacle-drag"), record, {}));
}

TEST(ObstacleDrag, SeesForceAndSurface) {
  const std::string thermal = "rule = \"thermal\"\ntemperature = 1.5\n";
  EXPECT_LT(drag(1, "", 0), 4);
  EXPECT_LT(drag(1, thermal, 1), 4);
  EXPECT_GT(drag(1.04, "", 0), 10);
  EXPECT_GT(drag(1, thermal, 0), 10);
}

TEST(FreeFlight, ProfileWeighsTemperatureByParticles) {
  Record record = record_with(column_scene, 1);
  Series& fields = add_fields(record, 0, 1);  // area 1: density is the number of particles
  add_sample(fields, 0, {99, 0, 0, 99});
  add_sample(fields, 1, {3, 0, 0, 1.0});
  add_sample(fields, 2, {2, 0, 0, 4.0});
  add_sample(fields, 3, {0, 0, 0, 0});
  const Profile profile = profile_along(Subject(record), 0, 1, 1);
  EXPECT_DOUBLE_EQ(profile.density[0], 5.0 / 3);
  EXPECT_DOUBLE_EQ(profile.temperature[0], 2);
}

TEST(FreeFlight, ChecksRefuseOtherScenes) {
  const auto applies = [](const std::string& check, const std::string& text) {
    return find_check(check).applies(read_scene_text(head + text, "test"));
  };
  EXPECT_TRUE(applies("barometric-column", column_scene));
  EXPECT_FALSE(
      applies("barometric-column", column_scene + "[[wall]]\nside = \"y-low\"\nrestitution = 0.9\n"));
  EXPECT_FALSE(applies("gas-between-walls", column_scene));
  EXPECT_FALSE(applies("obstacle-drag", column_scene));
  const std::string container =
      "[domain]\ndimension = 2\nsize = [1.0, 1.0]\nsides = { y = \"specular\" }\n"
      "[[wall]]\nside = \"y-low\"\nrule = \"thermal\"\ntemperature = 1.0\n"
      "[[wall]]\nside = \"y-high\"\nrule = \"thermal\"\ntemperature = ";
  EXPECT_TRUE(applies("flux-rate-up", container + "1.0\n"));
  EXPECT_FALSE(applies("flux-rate-up", container + "2.0\n"));
  EXPECT_FALSE(applies("flux-rate-up", column_scene));
}

}  // namespace
}  // namespace sandglass::free_flight_test
