#include "sim/run/time_step.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/sums.hpp"
#include "sim/run/initial.hpp"
#include "sim/run/test_scene.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::time_step_test {
namespace {

constexpr std::uint64_t kParticles = 10'000;

/// About 100 000 collisions: a scatter of 0.3%.
template <int D>
void expect_wanted_collisions(double restitution, const std::string& preset, double factor_of_density) {
  Scene scene = test_scene(D, D == 2 ? 250 : 40, kParticles);
  scene.species[0].restitution = restitution;
  choose(scene.method, preset);
  scene.method.weight = factor_of_density;
  scene.method.time_step = {{}, 0.05};
  const Setup<D> setup = set_up<D>(scene, {});
  const auto gas = setup.method->build({1, 0}, {});
  gas->assign(initial_particles<D>(setup, {1, 0}));
  TimeStepper<D> stepper(setup);
  constexpr int kSteps = 400;
  for (std::uint64_t step = 0; step < kSteps; ++step) gas->step(stepper.next(gas->view(), step), step);
  const double per_step =
      2.0 * static_cast<double>(gas->tally().collisions) / (kSteps * static_cast<double>(kParticles));
  EXPECT_NEAR(per_step / 0.05, 1, 0.01) << D << "D, restitution " << restitution << ", " << preset;
}

TEST(TimeStepper, GivesTheWantedCollisionsPerStep) {
  expect_wanted_collisions<2>(1, "dsmc", 1);
  expect_wanted_collisions<3>(1, "dsmc", 1);
  expect_wanted_collisions<2>(1, "dsmc-enskog", 1.5);
  expect_wanted_collisions<3>(1, "dsmc-enskog", 1.2);
}

/// Twenty collisions of each particle cool the disks by exp(-3.6) and the spheres by exp(-2.4): the step must follow.
TEST(TimeStepper, FollowsACoolingGas) {
  expect_wanted_collisions<2>(0.8, "dsmc", 1);
  expect_wanted_collisions<3>(0.8, "dsmc", 1);
}

/// Half the particles collide half as often: the step is twice as long, but for their own temperature.
TEST(TimeStepper, FollowsTheNumberOfParticles) {
  Scene scene = test_scene(2, 100, 2000);
  scene.method.time_step = {{}, 0.05};
  const auto setup = set_up<2>(scene, {});
  const auto gas = setup.method->build({1, 0}, {});
  gas->assign(initial_particles<2>(setup, {1, 0}));
  const double temperature = temperatures(gas->view()).mean();
  const double step = TimeStepper<2>(setup).next(gas->view(), 0);
  std::vector<std::uint32_t> leaving;
  for (std::uint32_t i = 0; i < 2000; i += 2) leaving.push_back(i);
  gas->remove(leaving);
  EXPECT_NEAR(TimeStepper<2>(setup).next(gas->view(), 0),
              2 * step * std::sqrt(temperature / temperatures(gas->view()).mean()), 1e-12 * step);
}

/// Twice the largest speed, a fall through a cell from rest and the fastest wall, over the shorter edge of a cell.
TEST(TimeStepper, KeepsWithinAFractionOfACell) {
  Scene scene = test_scene(2, 12, 30);
  choose(scene.method, "dsmc");
  dsmc_options(scene).cells = {3, 6};
  scene.domain.sides[1] = {Side::specular, Side::specular};
  scene.gravity = {0, -0.5};
  Wall floor;
  floor.axis = 1;
  floor.velocity = {0.6, 0};
  floor.amplitude = 0.2;
  floor.frequency = 0.5;
  scene.walls = {floor};
  scene.method.time_step = {};
  scene.method.time_step.cell_fraction = 0.25;
  const auto setup = set_up<2>(scene, {});
  const auto gas = setup.method->build({1, 0}, {});
  gas->assign({{{{1, 1}, {3, 4}}, {{2, 2}, {-1, 0}}}, {}});
  const double fall = std::sqrt(2 * 0.5 * 2), wall = std::hypot(2 * M_PI * 0.2 * 0.5, 0.6);
  EXPECT_NEAR(TimeStepper<2>(setup).next(gas->view(), 0), 0.25 * 2 / (2 * 5 + fall + wall), 1e-14);
}

template <int D>
double expected_rate(double diameter, ContactFactor factor) {
  Scene scene = test_scene(D, 10, 30);
  scene.species[0].diameter = diameter;
  scene.species[0].mass = 2;
  dsmc_options(scene).contact_factor = factor;
  return set_up<D>(scene, {}).method->collision_rate(0.5);
}

/// Enskog: 2 sqrt(pi) n d g sqrt(T/m) for disks, 4 n d^2 g sqrt(pi T/m) for spheres.
TEST(ExpectedCollisionRate, IsEnskogs) {
  EXPECT_NEAR(expected_rate<2>(0.7, ContactFactor::none), 2 * std::sqrt(M_PI) * 0.3 * 0.7 * 0.5, 1e-14);
  EXPECT_NEAR(expected_rate<3>(0.7, ContactFactor::none), 4 * 0.03 * 0.49 * std::sqrt(M_PI) * 0.5, 1e-14);
  const double disks = 0.3 * M_PI / 4, spheres = 0.03 * M_PI / 6;
  EXPECT_NEAR(expected_rate<2>(1, ContactFactor::local) / expected_rate<2>(1, ContactFactor::none),
              (1 - 7 * disks / 16) / std::pow(1 - disks, 2), 1e-14);
  EXPECT_NEAR(expected_rate<3>(1, ContactFactor::local) / expected_rate<3>(1, ContactFactor::none),
              (1 - spheres / 2) / std::pow(1 - spheres, 3), 1e-14);
}

TEST(TimeStepper, RefusesAGasWithoutMotion) {
  Scene scene = test_scene(2, 10, 30);
  scene.method.time_step = {{}, 0.05};
  scene.initial.temperature = 0;
  const auto setup = set_up<2>(scene, {});
  const auto gas = setup.method->build({1, 0}, {});
  gas->assign(initial_particles<2>(setup, {1, 0}));
  TimeStepper<2> stepper(setup);
  EXPECT_THROW(stepper.next(gas->view(), 0), RunError);
}

}  // namespace
}  // namespace sandglass::time_step_test
