#include "validation/law/sonine.hpp"

#include "validation/law/contact_average.hpp"

#include <gtest/gtest.h>

namespace sandglass::law::sonine_test {
namespace {

double sonine_polynomial(int dimension, double square) {
  return square * square / 2 - (dimension + 2) * square / 2 + dimension * (dimension + 2) / 8.0;
}

/// A moment of the collisions as zeroth + first * a2, exact to first order in a2.
struct Expansion {
  double zeroth, first;
  double relative() const { return first / zeroth; }
};

template <class Function>
Expansion expand(int dimension, double restitution, const Function& function) {
  const auto weighted = [&](const Contact& contact) {
    return function(contact) * (sonine_polynomial(dimension, contact.first.squaredNorm()) +
                                sonine_polynomial(dimension, contact.second.squaredNorm()));
  };
  return {contact_average(dimension, restitution, function),
          contact_average(dimension, restitution, weighted)};
}

double energy_loss(const Contact& contact) {
  return contact.first.squaredNorm() + contact.second.squaredNorm() - contact.first_after.squaredNorm() -
         contact.second_after.squaredNorm();
}

double fourth_power_loss(const Contact& contact) {
  const auto fourth = [](const Vector<3>& c) { return c.squaredNorm() * c.squaredNorm(); };
  return fourth(contact.first) + fourth(contact.second) - fourth(contact.first_after) -
         fourth(contact.second_after);
}

// Stationary kurtosis: mu4 = (D+2) mu2 (1+a2), with mu_p the collisional loss of c^p.
TEST(SonineA2, SolvesTheLinearisedMomentEquation) {
  for (int dimension : {2, 3})
    for (double restitution : {0.0, 0.3, 0.5, 0.8, 0.95}) {
      const Expansion mu2 = expand(dimension, restitution, energy_loss);
      const Expansion mu4 = expand(dimension, restitution, fourth_power_loss);
      const double k = dimension + 2;
      const double a2 = (k * mu2.zeroth - mu4.zeroth) / (mu4.first - k * (mu2.first + mu2.zeroth));
      EXPECT_NEAR(sonine_a2(dimension, restitution), a2, 1e-12);
      const double relinearised = (k * mu2.zeroth - mu4.zeroth) / (mu4.first - mu4.zeroth - k * mu2.first);
      EXPECT_NEAR(sonine_a2_relinearised(dimension, restitution), relinearised, 1e-12);
    }
}

TEST(SonineA2, VanishesForElasticParticlesAndAtInverseRootTwo) {
  for (int dimension : {2, 3})
    for (auto a2 : {sonine_a2, sonine_a2_relinearised}) {
      EXPECT_EQ(a2(dimension, 1), 0);
      EXPECT_NEAR(a2(dimension, std::sqrt(0.5)), 0, 1e-15);
      EXPECT_LT(a2(dimension, 0.9), 0);
      EXPECT_GT(a2(dimension, 0.5), 0);
    }
}

// The same moments by exact algebra over fractions (Gaussian integrals of polynomials), solved apart from this code.
TEST(SonineCoefficients, AreThoseOfExactAlgebra) {
  const auto expect = [](int dimension, double restitution, double a2, double a3) {
    const Eigen::Vector2d a = sonine_coefficients<3>(dimension, restitution);
    EXPECT_NEAR(a[0], a2, 1e-8) << dimension << "D, r = " << restitution;
    EXPECT_NEAR(a[1], a3, 1e-8) << dimension << "D, r = " << restitution;
  };
  expect(2, 0.9, -0.0298144956, -0.0071743031);
  expect(2, 0.6, 0.0334711351, -0.0091458584);
  expect(2, 0.0, 0.2108053325, -0.0166315844);
  expect(3, 0.9, -0.0156987511, -0.0031986969);
  expect(3, 0.6, 0.0212893854, -0.0053197105);
  expect(3, 0.0, 0.1605134044, -0.0090094193);
}

TEST(SonineCoefficients, AtSecondOrderAreTheClosedForms) {
  for (int dimension : {2, 3})
    for (double restitution : {0.0, 0.5, 0.9, 1.0}) {
      EXPECT_NEAR(sonine_coefficients<2>(dimension, restitution)[0],
                  sonine_a2_relinearised(dimension, restitution), 1e-13);
      EXPECT_NEAR(sonine_coefficients<2>(dimension, restitution, Linearised::products)[0],
                  sonine_a2(dimension, restitution), 1e-13);
    }
}

TEST(SonineCoefficients, MoveLittleAtTheNextOrder) {
  for (double restitution : {0.3, 0.5, 0.6, 0.8, 0.9, 0.95, 0.99}) {
    const double scale = 1 - restitution * restitution;
    const Eigen::Vector2d third = sonine_coefficients<3>(2, restitution);
    const Eigen::Vector3d fourth = sonine_coefficients<4>(2, restitution);
    const double sixth = sonine_sixth_moment(third) - (3 * fourth[0] - fourth[1]);
    EXPECT_LT(std::abs(third[0] - fourth[0]), kNextOrderOfA2 * scale);
    EXPECT_LT(std::abs(sixth), kNextOrderOfSixthMoment * scale);
  }
}

TEST(SonineFactors, AreTheFirstOrderPairAverages) {
  for (int dimension : {2, 3}) {
    const double collisions = expand(dimension, 0.7, [](const Contact&) { return 1.0; }).relative();
    const double cooling = expand(dimension, 0.7, energy_loss).relative();
    EXPECT_NEAR(sonine_collision_factor(0.1), 1 + 0.1 * collisions, 1e-12);
    EXPECT_NEAR(sonine_cooling_factor(0.1), 1 + 0.1 * cooling, 1e-12);
  }
}

}  // namespace
}  // namespace sandglass::law::sonine_test
