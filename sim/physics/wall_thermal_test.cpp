#include "sim/base/statistics.hpp"
#include "sim/physics/wall.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

// What leaves a thermal wall, by its moments within 4.5 standard errors.

namespace sandglass::wall_thermal_test {
namespace {

constexpr double kTemperature = 1.7, kMass = 2, kInertia = 0.3;
constexpr int kHits = 200'000;

template <int D>
struct Leaving {
  Vector<D> velocity;  ///< relative to the wall
  Spin<D> spin;
};

template <int D>
Vector<D> normal() {
  return Vector<D>(Vector<D>::Ones() + 0.5 * Vector<D>::Unit(0)).normalized();
}

template <int D>
std::vector<Leaving<D>> leaving(double flux = 1) {
  Random random(StreamKey(32, Purpose::collisions, 0, 0), 0);
  const Vector<D> wall = Vector<D>::Constant(0.8);
  std::vector<Leaving<D>> list(kHits);
  for (Leaving<D>& one : list) {
    one.velocity = wall - normal<D>();
    one.spin.setZero();
    reflect<D>({WallKind::thermal, {}, flux, kTemperature}, normal<D>(), wall,
               {one.velocity, &one.spin, kMass, 0.5, kInertia}, random);
    one.velocity -= wall;
  }
  return list;
}

template <int D, class Function>
void expect_mean(const std::vector<Leaving<D>>& list, Function function, double expected, const char* what) {
  std::vector<double> samples;
  for (const Leaving<D>& one : list) samples.push_back(function(one));
  const Mean mean = mean_of_independent(samples);
  EXPECT_NEAR(mean.value, expected, 4.5 * mean.standard_error) << what << " in " << D << "D";
}

/// Mean energies over the flux: T along the normal, T/2 for each other direction and each spin. <W> = sqrt(pi T / (2 m)).
template <int D>
void expect_flux() {
  const std::vector<Leaving<D>> list = leaving<D>();
  const auto up = [](const Leaving<D>& one) { return one.velocity.dot(normal<D>()); };
  const auto across = [=](const Leaving<D>& one) { return Vector<D>(one.velocity - up(one) * normal<D>()); };
  expect_mean<D>(list, up, std::sqrt(M_PI * kTemperature / (2 * kMass)), "speed");
  expect_mean<D>(
      list, [=](const auto& one) { return 0.5 * kMass * std::pow(up(one), 2); }, kTemperature,
      "normal energy");
  expect_mean<D>(
      list, [=](const auto& one) { return std::pow(0.5 * kMass * up(one) * up(one), 2); },
      2 * kTemperature * kTemperature, "its square");
  expect_mean<D>(
      list, [=](const auto& one) { return across(one)[0]; }, 0, "slip");
  expect_mean<D>(
      list, [=](const auto& one) { return 0.5 * kMass * across(one).squaredNorm(); },
      0.5 * (D - 1) * kTemperature, "tangential energy");
  expect_mean<D>(
      list, [=](const auto& one) { return 0.5 * kMass * one.velocity.squaredNorm(); },
      0.5 * (D + 1) * kTemperature, "energy flux per particle");
  expect_mean<D>(
      list, [](const auto& one) { return 0.5 * kInertia * one.spin.squaredNorm(); },
      0.5 * kTemperature * (D == 2 ? 1 : 3), "energy of spin");
}

TEST(ThermalWall, HasTheFluxOfAGasAtItsTemperatureInTwoDimensions) { expect_flux<2>(); }
TEST(ThermalWall, HasTheFluxOfAGasAtItsTemperatureInThreeDimensions) { expect_flux<3>(); }

/// The planted fault: T/2 along the normal as along every other axis.
TEST(ThermalWall, OfTheFaultHasMaxwellsNormalVelocities) {
  expect_mean<2>(
      leaving<2>(0),
      [](const Leaving<2>& one) { return 0.5 * kMass * std::pow(one.velocity.dot(normal<2>()), 2); },
      kTemperature / 2, "normal energy");
}

}  // namespace
}  // namespace sandglass::wall_thermal_test
