#include "sim/observe/observer.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/cloning_sums.hpp"
#include "sim/observe/fields.hpp"
#include "sim/observe/test_view.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::observer_test {
namespace {

ObserverSpec spec_of(const std::string& what) {
  ObserverSpec spec;
  spec.what = what;
  spec.grid = {2, 4};
  spec.bounded = {0, 1};
  return spec;
}

/// Box 4 x 4 in 2 x 4 bins of area 2; mass 2, weight 3; the last axis runs fastest.
TEST(Fields, OfThreeParticles) {
  TestSystem<2> system;
  system.add_cell({{{0.5, 1.5}, {1, 0}}, {{1.9, 1.1}, {3, 4}}});
  system.add_cell({{{4, 4}, {7, 8}}});
  const auto values = Fields<2>(spec_of("fields")).measure(system.view());
  ASSERT_EQ(values.size(), 8u * 4);
  const auto bin = [&](std::size_t i) {
    return std::vector<double>(values.begin() + 4 * static_cast<long>(i),
                               values.begin() + 4 * static_cast<long>(i) + 4);
  };
  EXPECT_EQ(bin(0), (std::vector<double>{0, 0, 0, 0}));
  // Relative velocities +-(1, 2), one degree of freedom per axis: T = 2 (2 + 8) / 2.
  EXPECT_EQ(bin(1), (std::vector<double>{3, 2, 2, 10}));
  EXPECT_EQ(bin(7), (std::vector<double>{1.5, 7, 8, 0}));
}

TEST(Fields, BinsRunFastestAlongTheLastAxis) {
  ObserverSpec spec = spec_of("fields");
  spec.grid = {2, 3, 4};
  for (std::size_t bin = 0; bin < 24; ++bin) {
    TestSystem<3> system;
    system.box = {2, 3, 4};
    const Vector<3> corner(static_cast<double>(bin / 12), static_cast<double>(bin / 4 % 3),
                           static_cast<double>(bin % 4));
    system.add_cell({{corner + Vector<3>::Constant(0.5), Vector<3>::Zero()}});
    const auto values = Fields<3>(spec).measure(system.view());
    for (std::size_t other = 0; other < 24; ++other)
      EXPECT_EQ(values[5 * other], other == bin ? 3 : 0) << bin;
  }
}

/// A stream a million times faster than the thermal motion must not drown it.
TEST(Fields, KeepTheTemperatureOfAFastStream) {
  TestSystem<3> system;
  const double stream = 1e6;
  system.add_cell({{{1, 1, 1}, {stream + 1, 0, 0}}, {{1, 1, 1}, {stream - 1, 0, 0}}});
  ObserverSpec spec = spec_of("fields");
  spec.grid = {1, 1, 1};
  const auto values = Fields<3>(spec).measure(system.view());
  EXPECT_NEAR(values[0], 3 * 2 / 64.0, 1e-15);
  EXPECT_NEAR(values[1], stream, 1e-9);
  EXPECT_NEAR(values[4], 2 * 2 / 3.0, 1e-9);
}

TEST(BinEdges, AreEquallyFarApart) {
  ObserverSpec spec;
  spec.range = {-1, 2};
  spec.bins = 3;
  EXPECT_EQ(bin_edges(spec), (std::vector<double>{-1, 0, 1, 2}));
}

const char* const kWords[] = {
    "energy",           "temperature",     "momentum",          "moments",          "velocity-histogram",
    "collisions",       "pressure",        "crossings",         "fields",           "shear-mode",
    "impact-parameter", "overlap",         "rotational-energy", "pair-correlation", "structure-factor",
    "pair-velocity",    "centre-of-mass",  "free-surface",      "kinetic-stress",   "wall-force",
    "two-fluids",       "species-density", "energy-flux",       "species",          "spin-temperature",
    "cloning"};

template <int D>
void expect_shape_as_declared() {
  TestSystem<D> system;
  system.add_cell(
      {{Vector<D>::Constant(1), Vector<D>::Ones()}, {Vector<D>::Constant(2), -Vector<D>::Unit(1)}});
  system.spins = {Spin<D>::Ones(), Spin<D>::Ones()};
  system.traits.resize(2);
  system.species = {0, 1};
  system.tally.by_species.resize(4);
  system.tally.cloning.resize(CloningSums<D>::kSize);
  for (const char* word : kWords) {
    ObserverSpec spec = spec_of(word);
    spec.grid.assign(D, 8);
    if (std::string(word) == "free-surface") spec.grid[0] = 1;
    spec.range = {0, 2};
    spec.bins = 4;
    spec.species = {"a", "b"};
    system.tally.impact.resize(needs_of(spec).impact_bins);
    system.planes.assign(1, Plane(0, 1, bin_edges(spec)));
    for (const auto& observer : make_observers<D>(spec, 0)) {
      observer->start(system.view());
      system.time += 1;
      const Quantity quantity = observer->quantity();
      const auto values = observer->measure(system.view());
      EXPECT_EQ(values.size(), quantity.size()) << word;
      for (double value : values) EXPECT_TRUE(std::isfinite(value)) << word;
      EXPECT_FALSE(quantity.name.empty() || quantity.units.empty() || quantity.summary.empty()) << word;
      if (!quantity.components.empty()) {
        EXPECT_EQ(quantity.components.size(), quantity.size()) << word;
      }
      if (!quantity.axis.empty()) {
        EXPECT_EQ(quantity.axis.size(), quantity.shape.back() + 1) << word;
      }
    }
  }
}

TEST(Observers, MeasureAsManyNumbersAsTheyDeclare) {
  expect_shape_as_declared<2>();
  expect_shape_as_declared<3>();
}

TEST(Observers, DeclareWhatTheyNeed) {
  for (const char* word : kWords) {
    EXPECT_EQ(needs_of(spec_of(word)).transfer, std::string(word) == "pressure");
    EXPECT_EQ(needs_of(spec_of(word)).plane, std::string(word) == "crossings");
    EXPECT_EQ(needs_of(spec_of(word)).walls, std::string(word) == "wall-force");
    EXPECT_EQ(needs_of(spec_of(word)).impact_bins, std::string(word) == "impact-parameter" ? 64u : 0u);
  }
}

TEST(Observers, UnknownWordNamesTheNearest) {
  try {
    make_observers<2>(spec_of("presure"), 0);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'pressure'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace sandglass::observer_test
