#include "validation/law/virial.hpp"

#include "validation/law/contact.hpp"
#include "validation/law/enskog.hpp"
#include "validation/law/state.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace sandglass::law::virial_test {
namespace {

TEST(VirialCompressibility, IsTheSeriesWhereThatConverges) {
  for (int dimension : {2, 3}) {
    const double fraction = dimension == 2 ? 0.2 : 0.1;
    const double excluded = (dimension == 2 ? 2 : 4) * fraction;
    const double series = 1 + excluded * virial_contact_value(dimension, fraction);
    EXPECT_NEAR(virial_compressibility(dimension, fraction).value / series, 1, 1e-5);
  }
}

TEST(VirialCompressibility, KeepsEveryCoefficient) {
  for (int dimension : {2, 3}) {
    const auto left_out = [&](double fraction) {
      const double excluded = (dimension == 2 ? 2 : 4) * fraction;
      return virial_compressibility(dimension, fraction).value - 1 -
             excluded * virial_contact_value(dimension, fraction);
    };
    // What is left out starts at nu^10.
    EXPECT_NEAR(std::log2(left_out(0.16) / left_out(0.08)), 10, 0.7) << dimension;
  }
}

// Event-chain Monte Carlo (straight chains; Michel, Kapfer & Krauth 2014), written apart from everything here,
// 1024 disks: Z = 4.1049(5), 6.4532(8), 8.4064(18) at 0.5, 0.6, 0.65, of which O(1/N) is taken away by the sum
// rule of Lebowitz & Percus (1961). Erpenbeck & Luban (1985): 8.306 at V/V0 = 1.4.
TEST(ReferenceContactValue, AgreesWithEventChains) {
  const auto z = [](double fraction) {
    return reference_compressibility({.dimension = 2, .fraction = fraction}).value;
  };
  EXPECT_NEAR(z(0.5), 4.1049 + 3.1 * 0.6 / 1024, 0.0015);
  EXPECT_NEAR(z(0.6), 6.4532 + 5.45 * 0.45 / 1024, 0.0025);
  EXPECT_NEAR(z(0.65), 8.4064 + 7.4 * 0.41 / 1024, 0.006);
  EXPECT_NEAR(z(std::numbers::pi / (2 * std::sqrt(3) * 1.4)), 8.306, 0.01);
}

TEST(ReferenceContactValue, AgreesWithEventChainsOfSpheres) {
  for (const auto& [fraction, measured, error] :
       {std::array{0.3, 3.9832, 0.0010}, {0.45, 9.4033, 0.0031}, {0.49, 12.1555, 0.0069}}) {
    const Bounded z = reference_compressibility({.dimension = 3, .fraction = fraction});
    const double large_system = measured + 0.4 * (measured - 1) / 864;
    EXPECT_NEAR(z.value, large_system, 3 * error + z.bound + z.standard_error);
  }
}

TEST(ReferenceContactValue, HoldsItsOwnErrorAgainstClosedForms) {
  for (double fraction : {0.05, 0.2, 0.4, 0.49}) {
    const Bounded g = reference_contact_value(3, fraction);
    EXPECT_NEAR(g.value / contact_value(3, fraction), 1, 0.004);
    EXPECT_LT((g.standard_error + g.bound) / g.value, 0.0025);
  }
  for (double fraction : {0.05, 0.25, 0.5}) {
    const Bounded g = reference_contact_value(2, fraction);
    EXPECT_LT((g.standard_error + g.bound) / g.value, 0.001);
    EXPECT_NEAR(g.value / contact_value(2, fraction), 1, 0.007);
  }
}

TEST(ReferenceContactValue, JoinsWithinItsBounds) {
  const Bounded below = reference_contact_value(2, 0.6), above = reference_contact_value(2, 0.6000001);
  EXPECT_LT(std::abs(below.value - above.value), below.bound + above.bound);
}

TEST(ReferenceContactValue, IsNotANumberWhereNobodyKnows) {
  EXPECT_TRUE(std::isnan(reference_contact_value(2, 0.67).value));
  EXPECT_TRUE(std::isnan(reference_contact_value(3, 0.50).value));
  EXPECT_EQ(reference_contact_value(2, 0).value, 1);
}

// BAR-2: measured mean free time 0.43; Enskog with Henderson's g 0.413.
TEST(ReferenceCollisionRate, OfBaryshevsGas) {
  const Gas gas{.dimension = 2, .temperature = 0.02, .fraction = 0.65};
  EXPECT_NEAR(1 / collision_rate(gas), 0.413, 0.0005);
  EXPECT_NEAR(1 / reference_collision_rate(gas).value, 0.4229, 0.0005);
}

// omega and Z - 1 are both proportional to g.
TEST(ReferenceCollisionRate, SharesItsContactValueWithThePressure) {
  const Gas gas{
      .dimension = 3, .diameter = 0.7, .mass = 1.3, .temperature = 2.1, .fraction = 0.3, .restitution = 0.6};
  const double pressure = (reference_compressibility(gas).value - 1) / (compressibility_factor(gas) - 1);
  EXPECT_NEAR(reference_collision_rate(gas).value / collision_rate(gas), pressure, 1e-12);
}

}  // namespace
}  // namespace sandglass::law::virial_test
