#include "validation/law/rough.hpp"

#include "sim/base/random.hpp"
#include "sim/base/statistics.hpp"
#include "sim/base/vector.hpp"

#include <cmath>

#include <boost/random/normal_distribution.hpp>
#include <gtest/gtest.h>

namespace sandglass::law::rough_test {
namespace {

TEST(SolidInertia, IsTheMeanSquareDistanceFromTheAxis) {
  const auto moment = [](double power) { return 1 / (power + 1); };  // integral of x^power from 0 to 1
  EXPECT_DOUBLE_EQ(solid_inertia(2), moment(3) / moment(1));
  EXPECT_DOUBLE_EQ(solid_inertia(3), 2. / 3 * moment(4) / moment(2));  // of shells, 2/3 r^2
}

Vector<3> normal_vector(Random& random, int dimension, double deviation) {
  boost::random::normal_distribution<double> normal(0, deviation);
  Vector<3> v = Vector<3>::Zero();
  for (int i = 0; i < dimension; ++i) v[i] = normal(random);
  return v;
}

/// The derivation by brute force: pairs of Maxwell's velocities and normal spins touch along x, weighted by their speed of
/// approach; the contact velocity leaves as -e along x and as -e_t across. Mass and radius one. 4.5 standard errors.
void expect_change(const RoughGas& gas, const Temperatures& now) {
  Random random(StreamKey(9, Purpose::velocities, 0, 0), static_cast<std::uint64_t>(gas.dimension));
  const double q = gas.inertia;
  std::vector<double> translation, rotation, weights;
  for (int i = 0; i < 200'000; ++i) {
    const Vector<3> v_1 = normal_vector(random, gas.dimension, std::sqrt(now.translation));
    const Vector<3> v_2 = normal_vector(random, gas.dimension, std::sqrt(now.translation));
    Vector<3> w = Vector<3>::Zero();  // w_1 + w_2: only the sum touches the contact
    w[2] = std::sqrt(2 * now.rotation / q) * boost::random::normal_distribution<double>()(random);
    if (gas.dimension == 3)
      w[1] = std::sqrt(2 * now.rotation / q) * boost::random::normal_distribution<double>()(random);
    const Vector<3> c = v_1 - v_2, n = Vector<3>::UnitX(), slip_by_spin(0, w[2], -w[1]);  // w x n
    const double weight = std::max(0.0, -c.x());
    Vector<3> across = c - slip_by_spin;
    across.x() = 0;
    Vector<3> impulse = -0.5 * (1 + gas.restitution) * c.x() * n;
    impulse -= (1 + gas.tangential) / (2 * (1 + 1 / q)) * across;
    const Vector<3> turn(0, -impulse.z(), impulse.y());  // n x J; each spin changes by -turn/q
    translation.push_back(weight * (impulse.dot(c) + impulse.squaredNorm()));
    rotation.push_back(weight * (-turn.dot(w) + turn.squaredNorm() / q));
    weights.push_back(weight);
  }
  const double total = mean_of_independent(weights).value;
  const Mean of_translation = mean_of_independent(translation), of_rotation = mean_of_independent(rotation);
  const Temperatures expected = rough_energy_change(gas, now);
  EXPECT_NEAR(of_translation.value / total, expected.translation, 6 * of_translation.standard_error / total);
  EXPECT_NEAR(of_rotation.value / total, expected.rotation, 6 * of_rotation.standard_error / total);
  EXPECT_LT(of_translation.standard_error / total, 0.01);
}

TEST(Rough, EnergyChangeIsThatOfCollidingPairs) {
  for (const int dimension : {2, 3})
    for (const auto& [e, tangential] : {std::pair{1.0, 0.5}, std::pair{0.6, 0.0}, std::pair{0.8, -0.7}})
      for (const double rotation : {0.3, 2.0})
        expect_change({dimension, e, tangential, dimension == 2 ? 0.5 : 0.4}, {1, rotation});
}

TEST(Rough, PerfectlyRoughElasticContactsKeepTheEnergyAndEquipartition) {
  for (const int dimension : {2, 3}) {
    const RoughGas gas{dimension, 1, 1, 0.4};
    const Temperatures change = rough_energy_change(gas, {1, 3});
    EXPECT_NEAR(change.translation + change.rotation, 0, 1e-14);
    EXPECT_GT(change.translation, 0);
    EXPECT_NEAR(rough_energy_change(gas, {2, 2}).translation, 0, 1e-14);
    EXPECT_NEAR(rough_temperature_ratio(gas), 1, 1e-12);
  }
}

/// Smooth particles cool as Haff says and keep their spin.
TEST(Rough, SmoothParticlesAreHaffs) {
  const Temperatures later = rough_cooling({3, 0.6, -1, 0.4}, {1, 0.7}, 12);
  EXPECT_NEAR(later.translation, std::exp(-(1 - 0.36) * 12 / 3), 1e-12);
  EXPECT_NEAR(later.rotation, 0.7, 1e-12);
  EXPECT_EQ(rough_temperature_ratio({3, 0.6, -1, 0.4}), HUGE_VAL);
}

/// The matrix exponential against small steps of the equation, and its long run against the ratio.
TEST(Rough, CoolingSolvesItsEquation) {
  for (const RoughGas& gas : {RoughGas{2, 0.9, 0.3, 0.5}, RoughGas{3, 0.6, 1, 0.4}, RoughGas{3, 1, 0, 0.4}}) {
    Temperatures now{1, 0.2};
    constexpr int kSteps = 40'000;
    const double step = 4.0 / kSteps, freedom = gas.dimension == 2 ? 1 : 3;
    for (int i = 0; i < kSteps; ++i) {
      const Temperatures slope = rough_energy_change(gas, now);
      const Temperatures middle{now.translation + step / 2 * slope.translation / gas.dimension,
                                now.rotation + step / 2 * slope.rotation / freedom};
      const Temperatures change = rough_energy_change(gas, middle);
      now.translation += step * change.translation / gas.dimension;
      now.rotation += step * change.rotation / freedom;
    }
    const Temperatures exact = rough_cooling(gas, {1, 0.2}, 4);
    EXPECT_NEAR(exact.translation, now.translation, 1e-8);
    EXPECT_NEAR(exact.rotation, now.rotation, 1e-8);
    const Temperatures late = rough_cooling(gas, {1, 0.2}, 200);
    EXPECT_NEAR(late.rotation / late.translation, rough_temperature_ratio(gas), 1e-9);
  }
}

/// In time t(tau) = integral of T_t^-1/2 dtau.
TEST(Rough, CoolingInTimeIsCoolingPerCollision) {
  for (const RoughGas& gas : {RoughGas{2, 0.9, 0.3, 0.5}, RoughGas{3, 0.6, 0, 0.4}}) {
    double time = 0;
    constexpr int kSteps = 20'000;
    const double step = 5.0 / kSteps;
    for (int i = 0; i < kSteps; ++i)
      time += step / std::sqrt(rough_cooling(gas, {1, 1}, (i + 0.5) * step).translation);
    const Temperatures in_time = rough_cooling_in_time(gas, {1, 1}, time),
                       exact = rough_cooling(gas, {1, 1}, 5);
    EXPECT_NEAR(in_time.translation, exact.translation, 1e-7);
    EXPECT_NEAR(in_time.rotation, exact.rotation, 1e-7);
  }
}

/// Closed form of e = 0.95, e_t = -0.9 in 3D: the ratio is 8.
TEST(Rough, RatioIsNotMonotone) {
  EXPECT_NEAR(rough_temperature_ratio({3, 0.95, -0.9, 0.4}), 8, 1e-9);
  EXPECT_NEAR(rough_temperature_ratio({3, 0.95, -0.5, 0.4}), 0.2171, 5e-5);
  EXPECT_NEAR(rough_temperature_ratio({3, 0.6, 1, 0.4}), 1.4661, 5e-5);
}

}  // namespace
}  // namespace sandglass::law::rough_test
