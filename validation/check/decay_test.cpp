#include "validation/check/synthetic.hpp"
#include "validation/law/enskog.hpp"
#include "validation/law/haff.hpp"
#include "validation/law/pair_deficit.hpp"
#include "validation/law/sonine.hpp"
#include "validation/law/transport.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace sandglass::decay_test {
namespace {

using namespace synthetic;

double relative_deviation(const Evidence& evidence) { return evidence.value / evidence.expected - 1; }

/// Energy that follows Haff's law with a cooling rate that is off by `error`, sampled every two collisions
/// per particle.
Record cooling_record(double error) {
  const GasScene scene{.restitution = 0.8};
  Record record = record_of(scene, 3);
  const double a2 = law::sonine_a2(2, 0.8);
  const double edge = std::sqrt(1000 * std::numbers::pi / scene.area_fraction) / 4;  // of four cells
  const double missing = law::pair_deficit(scene.gas(), {250, edge, 1, 4}).value;
  const double time_scale = law::haff_time_scale_sonine(scene.gas()) / (1 - missing) / (1 + error);
  const double rate = law::collision_rate(scene.gas()) * law::sonine_collision_factor(a2) * (1 - missing);
  for (std::size_t replica = 0; replica < 3; ++replica) {
    add_series(record, replica, "energy", {});
    add_series(record, replica, "collisions", {});
    for (int tau = 0; tau < 60; tau += 2) {
      const double time = time_scale * (std::exp(tau / (rate * time_scale)) - 1);
      add_sample(record.replicas[replica].series[0], time, {999 * law::haff_energy_ratio(time, time_scale)});
      add_sample(record.replicas[replica].series[1], time, {500.0 * tau});
    }
  }
  return record;
}

TEST(HaffCooling, FindsTheTimeScale) {
  const Evidence evidence = run_check(find_check("haff-cooling"), cooling_record(0), {});
  EXPECT_NEAR(relative_deviation(evidence), 0, 1e-12);
  EXPECT_LT(evidence.budget.systematic / evidence.expected, 0.006);
}

TEST(HaffCooling, SeesAWrongRate) {
  const Evidence evidence = run_check(find_check("haff-cooling"), cooling_record(0.02), {});
  EXPECT_NEAR(relative_deviation(evidence), 1 / 1.02 - 1, 1e-12);
  EXPECT_GT(std::abs(evidence.value - evidence.expected), evidence.budget.systematic);
}

TEST(CoolingPerCollision, FindsTheLoss) {
  const Evidence evidence = run_check(find_check("cooling-per-collision"), cooling_record(0), {});
  EXPECT_NEAR(relative_deviation(evidence), 0, 1e-12);
  const Evidence wrong = run_check(find_check("cooling-per-collision"), cooling_record(0.02), {});
  EXPECT_NEAR(relative_deviation(wrong), 0.02, 1e-12);
}

TEST(HaffCooling, RunThatDoesNotSettleIsRefused) {
  EXPECT_THROW(
      run_check(find_check("haff-cooling"), cooling_record(0), {{{"settle-collisions", 100}}, 0, 0, ""}),
      InputError);
}

/// A wave that decays with the right viscosity times 1 + error, on a background of thermal noise.
Evidence shear_of(double error) {
  GasScene scene{.particles = 1000, .area_fraction = 1e-4};
  scene.initial = "shear-wave = { amplitude = 0.1, periods = 1 }";
  Record record = record_of(scene, 12);
  const double edge = std::sqrt(1000 * std::numbers::pi / 4 / 1e-4);
  const double square = std::pow(2 * std::numbers::pi / edge, 2);
  const double viscosity = law::enskog_kinematic_viscosity(scene.gas(), law::SonineOrder::converged);
  const double rate = (1 + error) * viscosity * square;
  Generator generator(6);
  std::normal_distribution<double> noise(0, 0.0002);
  for (std::size_t replica = 0; replica < 12; ++replica) {
    add_series(record, replica, "shear-mode", {});
    add_series(record, replica, "collisions", {});
    for (int i = 0; i < 40; ++i) {
      const double time = 0.05 * i / (viscosity * square);
      add_sample(record.replicas[replica].series[0], time, {0.1 * std::exp(-rate * time) + noise(generator)});
      add_sample(record.replicas[replica].series[1], time, {5000.0 * i});
    }
  }
  return run_check(find_check("shear-wave-viscosity"), record, {});
}

TEST(ShearWaveViscosity, FindsTheDecayUnderNoise) {
  for (double error : {0.0, 0.05, -0.1}) {
    const Evidence evidence = shear_of(error);
    EXPECT_NEAR(relative_deviation(evidence), error, 4 * evidence.standard_error / evidence.expected);
    EXPECT_LT(evidence.standard_error, 0.01 * evidence.expected);
  }
}

}  // namespace
}  // namespace sandglass::decay_test
