#include "validation/law/contact.hpp"

#include "validation/law/quadrature.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace sandglass::law::contact_test {
namespace {

using std::numbers::pi;

/// B3/B2^2 from the overlap of two exclusion regions of radius d = 1: (1/3) int_{r<1} overlap(r) dr / B2^2.
double third_virial_ratio(int dimension) {
  const auto integrand = [=](double r) {
    if (dimension == 2) return 2 * pi * r * (2 * std::acos(r / 2) - r / 2 * std::sqrt(4 - r * r));
    return 4 * pi * r * r * 4 * pi / 3 * (1 - 0.75 * r + r * r * r / 16);
  };
  const double second = dimension == 2 ? pi / 2 : 2 * pi / 3;
  return quadrature::integral(integrand, 0, 1) / 3 / (second * second);
}

double difference_quotient(int dimension, double fraction) {
  const double h = 1e-4;
  return (contact_value(dimension, fraction + h) - contact_value(dimension, fraction - h)) / (2 * h);
}

TEST(ContactValue, IsOneForADiluteGas) {
  for (int dimension : {2, 3}) {
    EXPECT_DOUBLE_EQ(contact_value(dimension, 0), 1);
    EXPECT_DOUBLE_EQ(virial_contact_value(dimension, 0), 1);
  }
}

TEST(ContactValue, VirialSlopeIsTheOverlapIntegral) {
  for (int dimension : {2, 3}) {
    const double h = 1e-7;
    const double excluded = (dimension == 2 ? 2 : 4) * h;
    EXPECT_NEAR((virial_contact_value(dimension, h) - 1) / excluded, third_virial_ratio(dimension), 1e-6);
  }
}

TEST(ContactValue, FirstOrderInDensityIsExactForSpheresAndNearForDisks) {
  EXPECT_NEAR(contact_value_slope(3, 0), 4 * third_virial_ratio(3), 1e-9);
  EXPECT_NEAR(contact_value_slope(2, 0), 2 * third_virial_ratio(2), 0.002);
}

TEST(ContactValue, SlopeIsTheDerivative) {
  for (int dimension : {2, 3})
    for (double fraction : {0.05, 0.25, 0.45})
      EXPECT_NEAR(contact_value_slope(dimension, fraction) / difference_quotient(dimension, fraction), 1,
                  1e-6);
}

// Henderson and Carnahan & Starling are good to about 0.3% at moderate density: the virial series must say
// so.
TEST(ContactValue, ClosedFormsAgreeWithTheVirialSeries) {
  EXPECT_NEAR(contact_value(2, 0.05) / virial_contact_value(2, 0.05), 1, 3e-4);
  EXPECT_NEAR(contact_value(2, 0.25) / virial_contact_value(2, 0.25), 1, 3e-3);
  EXPECT_NEAR(contact_value(3, 0.05) / virial_contact_value(3, 0.05), 1, 1e-3);
  EXPECT_NEAR(contact_value(3, 0.2) / virial_contact_value(3, 0.2), 1, 3e-3);
}

TEST(VirialRatio, OfOrderThreeAndFourIsExact) {
  const double disks = 2 - 9 * std::sqrt(3) / (2 * pi) + 10 / (pi * pi);
  const double spheres = (2707 * pi + 438 * std::sqrt(2) - 4131 * std::acos(1.0 / 3)) / (4480 * pi);
  for (int dimension : {2, 3}) EXPECT_NEAR(virial_ratio(dimension, 3), third_virial_ratio(dimension), 1e-8);
  EXPECT_NEAR(virial_ratio(2, 4), disks, 1e-8);
  EXPECT_NEAR(virial_ratio(3, 4), spheres, 1e-8);
}

/// Virial ratio over that of Henderson or Carnahan & Starling: (k + (k-2)/8)/2^(k-1), (k^2+k-2)/4^(k-1).
double over_closed_form(int dimension, int k) {
  const double closed =
      dimension == 2 ? (k + (k - 2) / 8.0) / std::pow(2, k - 1) : (k * k + k - 2) / std::pow(4, k - 1);
  return virial_ratio(dimension, k) / closed;
}

// The quotient drifts smoothly below 1; a slip of one per cent in any published number makes a kink.
TEST(VirialRatio, DriftsSmoothlyFromTheClosedForms) {
  // From k = 5: B3 and B4 are exact, and Carnahan & Starling round B4 from 18.36 to 18 on purpose.
  for (int dimension : {2, 3})
    for (int k = 5; k < 10; ++k) {
      const double before = over_closed_form(dimension, k - 1);
      const double after = over_closed_form(dimension, k + 1);
      EXPECT_NEAR(over_closed_form(dimension, k), (before + after) / 2, 0.005) << dimension << " " << k;
    }
  EXPECT_NEAR(over_closed_form(2, 10), 0.93, 0.01);
  EXPECT_NEAR(over_closed_form(3, 10), 0.98, 0.01);
}

TEST(VirialContactValue, SumsTheSeries) {
  for (int dimension : {2, 3}) {
    double expected = 0;
    for (int k = 2; k <= 10; ++k) expected += virial_ratio(dimension, k) * std::pow(0.8, k - 2);
    EXPECT_NEAR(virial_contact_value(dimension, dimension == 2 ? 0.4 : 0.2), expected, 1e-14);
  }
}

}  // namespace
}  // namespace sandglass::law::contact_test
