#include "sim/observe/species.hpp"

#include "sim/observe/test_view.hpp"

#include <gtest/gtest.h>

namespace sandglass::species_test {
namespace {

ObserverSpec two_species() {
  ObserverSpec spec;
  spec.species = {"a", "b"};
  return spec;
}

/// Against a plain loop, with the degrees of freedom that the common mean velocity takes.
TEST(SpeciesObserver, TakesTheTemperatureOfEachSpecies) {
  auto system = random_system<3>(Vector<3>::Constant(4), 300, 7);
  system.traits = {{1, 2, 0.1}, {2, 0.3, 0.2}};
  for (std::size_t i = 0; i < 300; ++i) system.species.push_back(static_cast<std::uint8_t>(i % 3 == 0));
  double mass = 0;
  Vector<3> momentum = Vector<3>::Zero();
  for (std::size_t i = 0; i < 300; ++i) {
    const double m = system.traits[system.species[i]].mass;
    mass += m;
    momentum += m * system.particles[i].velocity;
  }
  std::array<double, 2> sum{}, freedom{};
  for (std::size_t i = 0; i < 300; ++i) {
    const double m = system.traits[system.species[i]].mass;
    sum[system.species[i]] += m * (system.particles[i].velocity - momentum / mass).squaredNorm() / 3;
    freedom[system.species[i]] += 1 - m / mass;
  }
  SpeciesTemperature<3> observer(two_species());
  EXPECT_EQ(observer.quantity().components, (std::vector<std::string>{"a", "b"}));
  const auto values = observer.measure(system.view());
  for (std::size_t kind : {0u, 1u}) EXPECT_NEAR(values[kind], sum[kind] / freedom[kind], 1e-12);
}

TEST(SpeciesObserver, CountsEachPairOnce) {
  Tally tally;
  tally.by_species = {3, 4, 5, 7};
  View<2> view;
  view.tally = &tally;
  SpeciesCollisions<2> observer(two_species());
  EXPECT_EQ(observer.quantity().components, (std::vector<std::string>{"a:a", "a:b", "b:b"}));
  EXPECT_EQ(observer.measure(view), (std::vector<double>{3, 9, 7}));
}

/// A checkpoint keeps the counts.
TEST(SpeciesObserver, CountsSurviveARestart) {
  Tally tally, again;
  tally.by_species = {3, 4, 5, 7};
  again.by_species.resize(4);
  Memory memory;
  tally.save(memory);
  again.load(memory);
  EXPECT_EQ(again.by_species, tally.by_species);
}

}  // namespace
}  // namespace sandglass::species_test
