#include "validation/check/column.hpp"

#include "validation/check/check.hpp"
#include "validation/check/synthetic.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

// A column round an obstacle between thermal walls, drawn from the law and from laws that are off.

namespace sandglass::column_test {
namespace {

using namespace synthetic;

const std::string kBox =
    "[run]\nduration = { time = 0.5 }\n[[species]]\ncount = 1000\ndiameter = 1e-8\n"
    "[method]\npreset = \"dsmc\"\ntime-step = 0.25\n"
    "[domain]\ndimension = 2\nsize = [1.0, 1.0]\nsides = { y = \"specular\" }\n[forces]\ngravity = [0.0, "
    "-2.0]\n";
const std::string kFloor = "[[wall]]\nside = \"y-low\"\nrule = \"thermal\"\ntemperature = 1.5\n";
const std::string kDisk = "[[obstacle]]\ncentre = [0.5, 0.4]\nradius = 0.3\n";

/// What the run is drawn from.
struct Drawn {
  double temperature = 1.5, gravity = 2, radius = 0.3, along_x = 1, lid = 1;
};

Record column_of(const std::string& scene, const Drawn& drawn) {
  const law::ObstructedColumn law{{1, drawn.temperature, drawn.gravity, 1}, 2, 1, {{0.4, drawn.radius}}};
  Record record;
  record.scene = kBox + scene;
  record.replicas.resize(16);
  Generator generator(11);
  std::normal_distribution<double> noise(1, 0.01);
  for (std::size_t replica = 0; replica < 16; ++replica) {
    Series& temperature = add_series(record, replica, "temperature", {"x", "y", "total"});
    for (int sample = 1; sample <= 40; ++sample) {
      const double x = drawn.temperature * drawn.along_x * noise(generator),
                   y = drawn.temperature * noise(generator);
      add_sample(temperature, sample, {x, y, (x + y) / 2});
    }
    Series& force = add_series(record, replica, "wall-force", {"y-low-x", "y-low-y", "y-high-x", "y-high-y"});
    for (int sample = 1; sample <= 40; ++sample)
      add_sample(force, sample,
                 {0, -1000 * law::floor_force(law) * noise(generator), 0,
                  1000 * law::lid_force(law) * drawn.lid * noise(generator)});
    Series& fields = add_series(record, replica, "fields", {});
    fields.quantity.shape = {1, 4, 4};
    for (int sample = 1; sample <= 40; ++sample) {
      std::vector<double> values;
      for (int bin = 0; bin < 4; ++bin) {
        const double share =
            law::obstructed_fraction(law, (bin + 1) / 4.0) - law::obstructed_fraction(law, bin / 4.0);
        values.insert(values.end(),
                      {4000 * share * noise(generator), 0, 0, drawn.temperature * noise(generator)});
      }
      add_sample(fields, sample, values);
    }
  }
  return record;
}

double significance(const std::string& check, const std::string& scene, const Drawn& drawn) {
  const Evidence evidence =
      run_check(find_check(check), column_of(scene, drawn), {{{"settle-time", 0.0}}, 0, 0, ""});
  return (std::abs(evidence.value - 1) - evidence.budget.systematic) / evidence.standard_error;
}

TEST(BarometricColumn, RoundAnObstacleOnAThermalFloor) {
  const std::string scene = kFloor + kDisk;
  EXPECT_LT(significance("barometric-column", scene, {}), 4);
  EXPECT_GT(significance("barometric-column", scene, {.temperature = 1.65}), 10);  // not that of the floor
  EXPECT_GT(significance("barometric-column", scene, {.gravity = -2}), 10);
  EXPECT_GT(significance("barometric-column", scene, {.radius = 0.35}), 10);
  EXPECT_GT(significance("barometric-column", scene, {.along_x = 1.05}), 10);
}

TEST(ColumnPressure, SeesGravityObstacleAndEitherEnd) {
  for (const std::string& scene : {kDisk, kFloor + kDisk}) {
    EXPECT_LT(significance("column-pressure", scene, {}), 4);
    EXPECT_GT(significance("column-pressure", scene, {.gravity = 2.04}), 5);
    EXPECT_GT(significance("column-pressure", scene, {.radius = 0.306}), 5);
    EXPECT_GT(significance("column-pressure", scene, {.lid = 1.03}), 5);
  }
  EXPECT_GT(significance("column-pressure", kFloor + kDisk, {.temperature = 1.65}), 10);
}

TEST(Column, IsOneThatSurfacesKeepAtOneTemperature) {
  const auto is_one = [](const std::string& more) { return is_column(read_scene_text(kBox + more, "test")); };
  EXPECT_TRUE(is_one(kFloor + kDisk));
  EXPECT_TRUE(is_one("[[wall]]\nside = \"y-low\"\nrule = \"bounce-back\"\nprobability = 0.5\n"));
  EXPECT_TRUE(is_one("[[wall]]\nside = \"y-high\"\nrule = \"random-tangential-sign\"\n"));
  EXPECT_FALSE(is_one("[[wall]]\nside = \"y-low\"\nrestitution = 0.9\n"));
  EXPECT_FALSE(is_one("[[wall]]\nside = \"y-low\"\nvelocity = [1.0, 0.0]\n"));
  EXPECT_FALSE(is_one(kFloor + "[[wall]]\nside = \"y-high\"\nrule = \"thermal\"\ntemperature = 1.0\n"));
  EXPECT_TRUE(is_one(kFloor + "[[wall]]\nside = \"y-high\"\nrule = \"thermal\"\ntemperature = 1.5\n"));
}

}  // namespace
}  // namespace sandglass::column_test
