#include "sim/physics/contact_value.hpp"

#include <gtest/gtest.h>

namespace sandglass::contact_value_test {
namespace {

double slope(ContactFormula formula, double fraction) {
  constexpr double h = 1e-6;
  return (formula(fraction + h).value - formula(fraction - h).value) / (2 * h);
}

TEST(ContactValue, SecondDerivativeIsThatOfTheValue) {
  for (ContactFormula formula : {henderson, carnahan_starling})
    for (double fraction : {0.0, 0.05, 0.25, 0.5, 0.7}) {
      constexpr double h = 1e-6;
      const double difference =
          (slope(formula, fraction + 1e3 * h) - slope(formula, fraction - 1e3 * h)) / (2e3 * h);
      EXPECT_NEAR(formula(fraction).second_derivative / difference, 1, 1e-4) << "fraction " << fraction;
    }
}

/// p/(nT) = 1 + 2 nu g with B3 = (4/3 - sqrt(3)/pi) (2 nu)^2 (exact) and B4 = 0.53223 (2 nu)^3 (Rowlinson 1964): Henderson's
/// form keeps both within 0.2%.
TEST(ContactValue, DisksHaveTheirVirialNumbers) {
  EXPECT_EQ(henderson(0).value, 1);
  EXPECT_NEAR(slope(henderson, 0) / (2 * 0.782004), 1, 0.002);
  EXPECT_NEAR(henderson(0).second_derivative / 2 / (4 * 0.532232), 1, 0.002);
}

/// p/(nT) = 1 + 4 nu g with B3 = 5/8 (4 nu)^2 and B4 rounded to 18 nu^3 (18.365): the integers of Carnahan & Starling.
TEST(ContactValue, SpheresHaveTheIntegersOfCarnahanAndStarling) {
  EXPECT_EQ(carnahan_starling(0).value, 1);
  EXPECT_NEAR(4 * slope(carnahan_starling, 0), 10, 1e-8);
  EXPECT_NEAR(4 * carnahan_starling(0).second_derivative / 2, 18, 1e-12);
}

/// Worked by hand.
TEST(ContactValue, DenseValues) {
  EXPECT_NEAR(henderson(0.5).value, 3.125, 1e-14);
  EXPECT_NEAR(carnahan_starling(0.4).value, 0.8 / 0.216, 1e-14);
}

TEST(ContactValue, DimensionChoosesTheFormula) {
  EXPECT_EQ(contact_formula(2)(0.3).value, henderson(0.3).value);
  EXPECT_EQ(contact_formula(3)(0.3).value, carnahan_starling(0.3).value);
}

}  // namespace
}  // namespace sandglass::contact_value_test
