#include "validation/check/finite_size.hpp"
#include "validation/check/synthetic.hpp"
#include "validation/law/contact.hpp"
#include "validation/law/enskog.hpp"
#include "validation/law/state.hpp"
#include "validation/law/virial.hpp"

#include <cmath>

#include <gtest/gtest.h>

// Each check sees data drawn from its law (within four errors) and from a law that is off (beyond ten).

namespace sandglass::equilibrium_test {
namespace {

using namespace synthetic;

double significance(const Evidence& evidence) {
  return std::abs(evidence.value - evidence.expected) / evidence.standard_error;
}

Evidence collision_rate_of(double rate_error) {
  const GasScene scene;
  Record record = record_of(scene, 2);
  Generator generator(4);
  const double rate = (1 + rate_error) * law::collision_rate(scene.gas()) * collision_rate_factor(1000, 2);
  for (std::size_t replica = 0; replica < 2; ++replica) {
    std::poisson_distribution<int> collisions(rate * 1000 / 2);
    add_sample(add_series(record, replica, "temperature", {"x", "y", "total"}), 0, {1, 1, 1});
    Series& series = add_series(record, replica, "collisions", {});
    double total = 0;
    for (int i = 0; i < 200; ++i) {
      add_sample(series, i, {total});
      total += collisions(generator);
    }
  }
  return run_check(find_check("collision-rate"), record, {});
}

TEST(CollisionRate, SeesEnskogAndFivePercentOff) {
  EXPECT_LT(significance(collision_rate_of(0)), 4);
  EXPECT_GT(significance(collision_rate_of(0.05)), 10);
  EXPECT_LT(collision_rate_of(0).standard_error, 0.003 * collision_rate_of(0).expected);
}

Evidence compressibility_of(double restitution, double collisional_error) {
  const GasScene scene{.restitution = restitution};
  Record record = record_of(scene, 10);
  Generator generator(5);
  std::normal_distribution<double> noise(0, 0.01);
  const double ratio = law::compressibility_factor(scene.gas()) - 1;
  for (std::size_t replica = 0; replica < 10; ++replica) {
    Series& series = add_series(record, replica, "pressure", {"kinetic", "collisional", "total"});
    add_sample(series, 0, {0, 0, 0});
    for (int i = 1; i < 20; ++i) {
      const double collisional = ratio * (1 + collisional_error) + noise(generator);
      add_sample(series, i, {1, collisional, 1 + collisional});
    }
  }
  return run_check(find_check("compressibility"), record, {});
}

TEST(Compressibility, SeesTheEquationOfStateAndADroppedOffset) {
  EXPECT_LT(significance(compressibility_of(1, 0)), 4);
  EXPECT_GT(significance(compressibility_of(1, -0.1)), 10);
}

TEST(Compressibility, MissingPairsAreExpected) {
  // By hand, all waves as long ones: d(nu Z)/dnu of disks at nu = 0.25 is 1 + 4 nu g + 2 nu^2 dg/dnu = 1 + 19/12 + 31/72;
  // 250 particles in each of four cells, which are their own windows: 1 + 2 nu g'/g + nu^2 g''/(2g) = 2.3396.
  const double inverse_structure = 1 + 19.0 / 12 + 31.0 / 72;
  const double most = 3.0 / 4 * (1 - 1 / inverse_structure) * 2.3396 / 250;
  const Evidence evidence = compressibility_of(1, 0);
  const double all = (law::compressibility_factor(GasScene{}.gas()) - 1) * 0.999;
  const double bound = evidence.budget.systematic * 0.999 / all;
  EXPECT_NEAR(1 - (evidence.expected - 1) / all + bound, most, 1e-6);
  EXPECT_GT(bound, 0.1 * most);
}

/// A dense gas of event-driven disks whose rate is that of the reference contact value times 1 + error.
Evidence dense_rate_of(const std::string& check, double error, const Settings& settings) {
  const GasScene scene{.area_fraction = 0.65, .event_driven = true};
  Record record = record_of(scene, 8);
  Generator generator(14);
  const double rate = (1 + error) * law::reference_collision_rate(scene.gas()).value *
                      fixed_count_factor(2, 0.65, 1000) * relative_speed_factor(2 * 999);
  std::poisson_distribution<int> collisions(rate * 1000 / 2);
  for (std::size_t replica = 0; replica < 8; ++replica) {
    add_sample(add_series(record, replica, "temperature", {"x", "y", "total"}), 0, {1, 1, 1});
    Series& series = add_series(record, replica, "collisions", {});
    double total = 0;
    for (int i = 0; i < 50; ++i) {
      add_sample(series, i, {total});
      total += collisions(generator);
    }
  }
  return run_check(find_check(check), record, settings);
}

TEST(CollisionRateReference, TellsHendersonFromTheFluid) {
  const auto excess = [](const Evidence& evidence) {
    return (std::abs(evidence.value - evidence.expected) - evidence.budget.systematic) /
           evidence.standard_error;
  };
  EXPECT_LT(excess(dense_rate_of("collision-rate-reference", 0, {})), 4);
  EXPECT_GT(excess(dense_rate_of("collision-rate-reference", 0.025, {})), 10);  // Henderson's g
  EXPECT_GT(excess(dense_rate_of("collision-rate", 0, {})), 10);
}

TEST(MeanFreeTime, IsHeldAgainstTheStatedNumber) {
  const double time = 1 / law::reference_collision_rate({.dimension = 2, .fraction = 0.65}).value;
  const Evidence evidence =
      dense_rate_of("mean-free-time", 0, {{{"stated", time}, {"digit", 0.0001}}, 0, 0, ""});
  EXPECT_NEAR(evidence.value, time, 0.001 * time);
  EXPECT_EQ(evidence.expected, time);
  EXPECT_EQ(evidence.budget.systematic, 0.0001);
  EXPECT_THROW(dense_rate_of("mean-free-time", 0, {}), InputError);
}

TEST(CompressibilityReference, DiffersFromHendersonByItsError) {
  const Evidence evidence = compressibility_of(1, 0);
  EXPECT_GT(evidence.expected, 1);
  Record record = record_of({}, 10);
  for (std::size_t replica = 0; replica < 10; ++replica) {
    Series& series = add_series(record, replica, "pressure", {"kinetic", "collisional", "total"});
    for (int i = 0; i < 5; ++i) add_sample(series, i, {1, 0.79 + 0.001 * static_cast<double>(replica), 1.8});
  }
  const double expected = run_check(find_check("compressibility-reference"), record, {}).expected;
  const double seen = (evidence.expected - 1) / (law::compressibility_factor(GasScene{}.gas()) - 1);
  EXPECT_NEAR(expected, 1 + 0.5 * law::virial_contact_value(2, 0.25) * seen, 2e-4);
  EXPECT_NE(expected, evidence.expected);
}

Evidence conservation_of(const std::string& check, double drift) {
  Record record = record_of({}, 1);
  add_series(record, 0, "energy", {});
  add_series(record, 0, "collisions", {});
  for (int i = 0; i < 5; ++i) {
    add_sample(record.replicas[0].series[0], i, {1000 * (1 + drift * i)});
    add_sample(record.replicas[0].series[1], i, {50000.0 * i});
  }
  return run_check(find_check(check), record, {});
}

TEST(EnergyConservation, RoundingIsAllowedALeakIsNot) {
  const Evidence rounding = conservation_of("energy-conservation", 2e-16);
  EXPECT_LT(rounding.value, rounding.budget.systematic);
  const Evidence leak = conservation_of("energy-conservation", 1e-9);
  EXPECT_GT(leak.value, leak.budget.systematic);
}

TEST(EnergyConservation, NotANumberStaysVisible) {
  EXPECT_TRUE(std::isnan(conservation_of("energy-conservation", std::nan("")).value));
}

}  // namespace
}  // namespace sandglass::equilibrium_test
