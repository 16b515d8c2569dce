#include "validation/check/check.hpp"
#include "validation/check/synthetic.hpp"
#include "validation/law/haff.hpp"
#include "validation/law/uniform_shear.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

// Records of a sheared gas made by hand: uniform shear passes, anything else does not.

namespace sandglass::bagnold_test {
namespace {

using namespace synthetic;

constexpr double kWidth = 100, kHeight = 200, kFraction = 0.01, kWallSpeed = 0.5;

Record cell(double restitution, const std::string& preset = "dsmc") {
  Record record;
  record.scene =
      "[run]\nduration = { time = 100.0 }\n[domain]\ndimension = 2\nsize = [100.0, 200.0]\n"
      "sides = { y = \"specular\" }\n[[species]]\narea-fraction = 0.01\nrestitution = " +
      std::to_string(restitution) + "\n[method]\npreset = \"" + preset +
      "\"\ntime-step = 1.0\n[initial]\npositions = \"lattice\"\n"
      "[[wall]]\nside = \"y-low\"\nrule = \"bounce-back\"\nvelocity = [-0.5, 0.0]\n"
      "[[wall]]\nside = \"y-high\"\nrule = \"bounce-back\"\nvelocity = [0.5, 0.0]\n";
  record.replicas.resize(8);
  for (Replica& replica : record.replicas) replica.counters = {{"collisions", 1000}, {"steps", 100}};
  return record;
}

struct Flow {
  double stress = 1, normal = 1, temperature = 1, power = 1;  ///< over the law
  std::function<double(double)> velocity = [](double y) { return 0.9 * (y / kHeight - 0.5); };
};

law::Gas gas() { return {2, 1, 1, 1, kFraction, 0.9}; }

Record flow_of(const Flow& flow) {
  Record record = cell(0.9);
  const double rate = 0.9 / kHeight, density = law::number_density(gas());
  const double law_temperature = law::dilute_shear_temperature(gas(), rate);
  const law::ReducedStress stress = law::dilute_shear_stress(2, 0.9);
  law::Gas hot = gas();
  hot.temperature = flow.temperature * law_temperature;
  const double shear = flow.stress * density * law_temperature * stress.xy * kWidth,
               normal = flow.normal * density * law_temperature * stress.yy * kWidth;
  Generator generator(5);
  std::normal_distribution<double> noise(1, 1e-3);
  for (std::size_t replica = 0; replica < 8; ++replica) {
    record.replicas[replica].series.reserve(4);  // references stay
    Series& fields = add_series(record, replica, "fields", {});
    fields.quantity.shape = {1, 20, 4};
    Series& force = add_series(record, replica, "wall-force", {"y-low-x", "y-low-y", "y-high-x", "y-high-y"});
    Series& power = add_series(record, replica, "wall-power", {"y-low", "y-high"});
    Series& energy = add_series(record, replica, "energy", {});
    for (int sample = 1; sample <= 10; ++sample) {
      std::vector<double> values;
      for (int bin = 0; bin < 20; ++bin)
        values.insert(values.end(), {density, flow.velocity((bin + 0.5) / 20 * kHeight) * noise(generator), 0,
                                     hot.temperature * noise(generator)});
      add_sample(fields, sample, values);
      add_sample(force, sample, {shear * noise(generator), -normal, -shear * noise(generator), normal});
      const double work = flow.power * density * hot.temperature * law::cooling_rate(hot) * kWidth * kHeight;
      add_sample(power, sample, {work / 2 * noise(generator), work / 2 * noise(generator)});
      add_sample(energy, sample, {1});
    }
  }
  return record;
}

double value(const std::string& check, const Flow& flow) {
  return run_check(find_check(check), flow_of(flow), {{{"settle-time", 1.0}}, 0, 0, ""}).value;
}

TEST(Bagnold, SeesStressFrictionAndTemperature) {
  EXPECT_NEAR(value("shear-stress", {}), 1, 0.003);
  EXPECT_NEAR(value("shear-stress", {.stress = 1.05}), 1.05, 0.003);
  EXPECT_NEAR(value("shear-friction", {}), 1, 0.003);
  EXPECT_NEAR(value("shear-friction", {.normal = 0.9}), 1 / 0.9, 0.003);
  EXPECT_NEAR(value("shear-temperature", {}), 1, 0.003);
  EXPECT_NEAR(value("shear-temperature", {.temperature = 1.1}), 1.1, 0.003);
}

/// Uniform shear at another rate than the walls say is judged at its own.
TEST(Bagnold, UsesTheRateOfTheMiddle) {
  const Flow slipping{.stress = 0.64, .velocity = [](double y) { return 0.72 * (y / kHeight - 0.5); }};
  EXPECT_NEAR(value("shear-stress", slipping), 1, 0.004);
}

TEST(Bagnold, SeesACurvedProfile) {
  const double straight = 2 * kWallSpeed / kHeight;
  EXPECT_NEAR(value("shear-profile", {.velocity = [&](double y) { return straight * y - kWallSpeed; }}), 1,
              0.004);
  EXPECT_NEAR(value("shear-profile", {}), 0.9, 0.004);
  const Flow rigid_middle{.velocity = [](double y) { return 4 * std::pow(y / kHeight - 0.5, 3); }};
  EXPECT_LT(value("shear-profile", rigid_middle), 0.1);
}

TEST(Bagnold, AGasThatWallsDoNotMoveHasNoSlope) {
  const Flow still{.velocity = [](double) { return 0.0; }};
  EXPECT_EQ(value("shear-profile", still), 0);
}

/// Centres of hard disks stay half a diameter away from the walls.
TEST(Bagnold, HardDisksShearBetweenTheirOwnWalls) {
  Record record = flow_of({.velocity = [](double y) { return (y - kHeight / 2) / (kHeight - 1); }});
  record.scene = cell(0.9, "event-driven").scene;
  EXPECT_NEAR(run_check(find_check("shear-profile"), record, {{{"settle-time", 1.0}}, 0, 0, ""}).value, 1,
              0.004);
}

/// Dilute DSMC has no contact value, and the anisotropy of the flow adds 3 S:S/32: here 2%.
TEST(Bagnold, PowerIsDissipation) {
  const law::ReducedStress stress = law::dilute_shear_stress(2, 0.9);
  const double anisotropy =
      3.0 / 32 * (std::pow(stress.xx - 1, 2) + std::pow(stress.yy - 1, 2) + 2 * stress.xy * stress.xy);
  const double contact =
      law::cooling_rate(gas()) / law::cooling_rate({2, 1, 1, 1, 1e-9, 0.9}) * 1e-9 / kFraction;
  EXPECT_NEAR(anisotropy, 0.0174, 5e-4);
  EXPECT_NEAR(value("shear-power", {.power = (1 + anisotropy) / contact}), 1, 0.003);
  EXPECT_NEAR(value("shear-power", {.power = 1.1 * (1 + anisotropy) / contact}), 1.1, 0.003);
}

Record worked(double gain, double power_factor) {
  Record record = cell(1);
  for (std::size_t replica = 0; replica < 8; ++replica) {
    record.replicas[replica].series.reserve(4);
    Series& force = add_series(record, replica, "wall-force", {"y-low-x", "y-low-y", "y-high-x", "y-high-y"});
    Series& power = add_series(record, replica, "wall-power", {"y-low", "y-high"});
    Series& energy = add_series(record, replica, "energy", {});
    add_sample(energy, 0, {10});
    for (int sample = 1; sample <= 4; ++sample) {
      add_sample(force, sample, {2, -9, -2, 9});
      add_sample(power, sample, {2 * kWallSpeed * power_factor, 2 * kWallSpeed * power_factor});
      add_sample(energy, sample, {10 + sample * gain});
    }
  }
  return record;
}

double beyond(const std::string& check, const Record& record) {
  const Evidence evidence = run_check(find_check(check), record, {});
  return evidence.value / evidence.budget.systematic;
}

TEST(WallBalance, WorkOfTheWallsIsTheGainOfAnElasticGas) {
  EXPECT_LT(beyond("wall-work", worked(2, 1)), 1);
  EXPECT_GT(beyond("wall-work", worked(1.999, 1)), 100);
  EXPECT_LT(beyond("wall-power", worked(2, 1)), 1);
  EXPECT_GT(beyond("wall-power", worked(2, 0.999)), 100);
}

TEST(ShearCell, ChecksRefuseOtherScenes) {
  Record still = cell(0.9);
  const Scene shear = read_scene_text(still.scene, "test");
  EXPECT_TRUE(find_check("shear-stress").applies(shear));
  EXPECT_FALSE(find_check("wall-work").applies(shear));
  Scene driven = shear;
  driven.walls[0].velocity = {0.5, 0};
  EXPECT_FALSE(find_check("shear-stress").applies(driven));
}

}  // namespace
}  // namespace sandglass::bagnold_test
