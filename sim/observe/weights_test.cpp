#include "sim/base/error.hpp"
#include "sim/observe/collisions.hpp"
#include "sim/observe/distribution.hpp"
#include "sim/observe/energy.hpp"
#include "sim/observe/fields.hpp"
#include "sim/observe/pair_correlation.hpp"
#include "sim/observe/rotation.hpp"
#include "sim/observe/structure_factor.hpp"
#include "sim/observe/sums.hpp"
#include "sim/observe/test_view.hpp"

#include <cmath>

#include <gtest/gtest.h>

// A particle of weight n is n particles in one: every observer must see that.

namespace sandglass::weights_test {
namespace {

struct Twins {
  TestSystem<3> weighted, copied;
};

/// Weights from 1 to 4, in a mixture or not; the copies have the weight 1 each.
Twins twins(bool mixture) {
  Twins both{random_system<3>(Vector<3>(4, 5, 6), 200, 1), {}};
  TestSystem<3>&one = both.weighted, &many = both.copied;
  Random random(StreamKey(1, Purpose::species, 0, 0), 0);
  many.box = one.box;
  many.weight = 1;
  one.traits = many.traits = {{1, 2, 0.4}};
  if (mixture) one.traits.push_back({2, 0.3, 5}), many.traits.push_back({2, 0.3, 5});
  for (const Phase<3>& particle : one.particles) {
    const auto weight = static_cast<std::size_t>(1 + 4 * random.uniform());
    const auto species = static_cast<std::uint8_t>(random.uniform() < 0.3);
    const Spin<3> spin(random.uniform(), -random.uniform(), 2);
    one.weights.push_back(static_cast<double>(weight));
    one.spins.push_back(spin);
    many.spins.insert(many.spins.end(), weight, spin);
    if (mixture) one.species.push_back(species), many.species.insert(many.species.end(), weight, species);
    many.add_cell(std::vector<Phase<3>>(weight, particle));
  }
  return both;
}

void expect_alike(const std::vector<double>& a, const std::vector<double>& b, double factor = 1) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], factor * b[i], 1e-12 * (1 + std::abs(b[i]))) << i;
}

template <class Kind, class... Arguments>
void expect_same(Twins& both, Arguments... arguments) {
  expect_alike(Kind(arguments...).measure(both.weighted.view()),
               Kind(arguments...).measure(both.copied.view()));
}

double freedom(TestSystem<3>& system) {
  return with_population(system.view(), [](const auto& all) { return all.freedom; });
}

ObserverSpec bins() {
  ObserverSpec spec;
  spec.bins = 6;
  spec.range = {-1, 3};
  spec.grid = {8, 8, 8};
  return spec;
}

void expect_twins(bool mixture) {
  Twins both = twins(mixture);
  expect_same<Energy<3>>(both);
  expect_same<Momentum<3>>(both);
  expect_same<MomentumScale<3>>(both);
  expect_same<Moments<3>>(both);
  expect_same<VelocityHistogram<3>>(both, bins());
  expect_same<ShearMode<3>>(both, 1, true);
  expect_same<RotationalEnergy<3>>(both);
  expect_same<RotationalTemperature<3>>(both);
  const double more = freedom(both.copied) / freedom(both.weighted);
  EXPECT_GT(more, 1);  // copies that move alike are no new degrees of freedom
  expect_alike(Temperature<3>().measure(both.weighted.view()), Temperature<3>().measure(both.copied.view()),
               more);
}

TEST(Weights, AParticleCountsAsOftenAsItsWeight) {
  expect_twins(false);
  expect_twins(true);
}

TEST(Weights, FieldsAndStructureCountRealParticles) {
  Twins both = twins(true);
  ObserverSpec spec = bins();
  spec.grid = {1, 2, 1};
  const auto one = Fields<3>(spec).measure(both.weighted.view());
  const auto many = Fields<3>(spec).measure(both.copied.view());
  for (std::size_t bin = 0; bin < 2; ++bin) {
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(one[5 * bin + k], many[5 * bin + k], 1e-12);
    EXPECT_NEAR(one[5 * bin + 4] / many[5 * bin + 4], 1.015, 0.015);
  }
  const auto structure = StructureFactor<3>(bins()).measure(both.weighted.view());
  const auto copies = StructureFactor<3>(bins()).measure(both.copied.view());
  double squares = 0, count = 0;
  for (const double weight : both.weighted.weights) squares += weight * weight, count += weight;
  expect_alike(structure, copies, count / squares);
}

/// Without bias for any weights: the mean over many draws of five particles is the temperature.
TEST(Weights, TemperatureOfFewParticlesHasNoBias) {
  auto system = random_system<3>(Vector<3>(4, 4, 4), 5, 3);
  system.weights = {1, 10, 0.1, 3, 3};
  system.species = {0, 1, 0, 1, 0};
  system.traits = {{1, 2, 0}, {1, 0.3, 0}};
  Random random(StreamKey(3, Purpose::crossings, 0, 0), 0);
  const int draws = 40'000;
  double sum = 0, squares = 0;
  for (int draw = 0; draw < draws; ++draw) {
    for (std::size_t i = 0; i < 5; ++i)
      for (double& component : system.particles[i].velocity)
        component = std::sqrt(1.5 / system.traits[system.species[i]].mass) *
                    std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * M_PI * random.uniform());
    const double temperature = temperatures(system.view()).mean();
    sum += temperature / draws;
    squares += temperature * temperature / draws;
  }
  EXPECT_NEAR(sum, 1.5, 4 * std::sqrt((squares - sum * sum) / draws));
}

TEST(Weights, PressureIsThatOfTheRealParticles) {
  Twins both = twins(false);
  const auto kinetic = [](TestSystem<3>& system) {
    Pressure<3> pressure;
    system.tally.transfer = {};
    pressure.start(system.view());
    system.tally.transfer.add(12);
    system.time = 1;
    return pressure.measure(system.view());
  };
  const auto one = kinetic(both.weighted), many = kinetic(both.copied);
  EXPECT_NEAR(one[0] / many[0], freedom(both.copied) / freedom(both.weighted), 1e-12);
  EXPECT_EQ(one[1], many[1]);
  EXPECT_GT(one[1], 0);
}

TEST(Weights, PairCorrelationRefusesThem) {
  auto system = random_system<3>(Vector<3>(4, 4, 4), 5, 3);
  ObserverSpec spec = bins();
  spec.range = {0, 1};
  EXPECT_NO_THROW(PairCorrelation<3>(spec).start(system.view()));
  system.weights.assign(5, 2);
  EXPECT_THROW(PairCorrelation<3>(spec).start(system.view()), InputError);
}

}  // namespace
}  // namespace sandglass::weights_test
