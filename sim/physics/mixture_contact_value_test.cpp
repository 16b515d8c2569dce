#include "sim/physics/mixture_contact_value.hpp"

#include "sim/physics/contact_value.hpp"

#include <gtest/gtest.h>

namespace sandglass::mixture_contact_value_test {
namespace {

/// Small particles of diameter 1 and large ones of diameter 3 at these number densities.
Crowding crowd(int dimension, double small, double large) {
  return crowding_of(dimension, 1) * small + crowding_of(dimension, 3) * large;
}

TEST(MixtureContactValue, OfAlikeParticlesIsThatOfOneSpecies) {
  for (int dimension : {2, 3})
    for (double fraction : {0.0, 0.1, 0.3, 0.5}) {
      const Crowding one = crowding_of(dimension, 2.5);
      const MixtureContactValue contact(dimension, one * (fraction / one.fraction), 2.5, 2.5);
      const ContactValue expected = contact_formula(dimension)(fraction);
      EXPECT_NEAR(contact.value(), expected.value, 1e-13);
      EXPECT_NEAR(contact.second_derivative(one) / (one.fraction * one.fraction), expected.second_derivative,
                  1e-12 * expected.second_derivative);
    }
}

/// A point touches a particle with the chance that its place is free.
TEST(MixtureContactValue, OfAPointIsTheInverseOfTheRoomLeft) {
  for (int dimension : {2, 3}) {
    const Crowding all = crowd(dimension, 0.05, 0.01);
    EXPECT_NEAR(MixtureContactValue(dimension, all, 3, 0).value(), 1 / (1 - all.fraction), 1e-15);
  }
}

TEST(MixtureContactValue, SecondDerivativeIsThatOfTheValue) {
  constexpr double h = 1e-3;
  for (int dimension : {2, 3})
    for (double added : {1.0, 3.0})
      for (double other : {1.0, 3.0}) {
        const Crowding all = crowd(dimension, 0.08, 0.01), change = crowding_of(dimension, added);
        const auto value = [&](double particles) {
          return MixtureContactValue(dimension, all + change * particles, 1, other).value();
        };
        const double difference = (value(h) - 2 * value(0) + value(-h)) / (h * h);
        EXPECT_NEAR(MixtureContactValue(dimension, all, 1, other).second_derivative(change) / difference, 1,
                    1e-3)
            << dimension << ' ' << added << ' ' << other;
      }
}

}  // namespace
}  // namespace sandglass::mixture_contact_value_test
