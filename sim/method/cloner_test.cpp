#include "sim/method/cloner.hpp"

#include "sim/base/error.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace sandglass::cloner_test {
namespace {

using Sums = CloningSums<2>;
constexpr SpeciesTraits kKind{1, 3};

/// Two cells along x, of these weights; the particles stand in the first and arrive in the second.
struct Border {
  ParticleStore<2> store{Grid<2>({2, 1}, {2, 1}), {column::id, column::weight}};
  Tally tally;
  Cloner<2> cloner;

  Border(double from, double to, std::size_t particles, CloningFaults faults = {})
      : cloner({from, to}, faults, tally) {
    Particles<2> all;
    for (std::size_t i = 0; i < particles; ++i)
      all.phases.push_back({{0.5, 0.5}, {1 + static_cast<double>(i % 5), -2}});
    all.columns.set(column::weight, std::vector<double>(particles, from));
    store.assign(all);
    for (Phase<2>& particle : store.phases()) particle.position[0] += 1;
    store.find_cells();
  }
  void cross(std::uint64_t step = 0) {
    cloner.apply(store, std::span(&kKind, 1), {7, Purpose::cloning, 0, step});
    store.sort();
  }
  double sum(Sums::Kind kind, bool removed, std::size_t amount) const {
    return tally.cloning[Sums::place(kind, removed, amount)].value();
  }
};

TEST(Cloner, MakesWholeNumbersOfCopiesWithoutChance) {
  Border border(1, 0.25, 10);
  border.cross();
  ASSERT_EQ(border.store.size(), 40u);
  for (const double weight : border.store.column(column::weight)) EXPECT_EQ(weight, 0.25);
  EXPECT_EQ(border.sum(Sums::gained, false, 0), 0);
  EXPECT_EQ(border.sum(Sums::variance, false, 0), 0);
  EXPECT_EQ(border.sum(Sums::brought, false, 0), 10 * 3);
  EXPECT_EQ(border.cloner.counters().at("particles-cloned"), 30);
}

/// Copies stand where their particle does and move as it does, with ids of their own.
TEST(Cloner, CopiesAreTheParticle) {
  Border border(1, 0.5, 3);
  border.cross();
  std::map<double, int> speeds;
  std::set<std::uint64_t> ids;
  for (const Phase<2>& particle : border.store.phases()) {
    EXPECT_EQ(particle.position, Vector<2>(1.5, 0.5));
    ++speeds[particle.velocity[0]];
  }
  for (const std::uint64_t id : border.store.ids()) ids.insert(id);
  EXPECT_EQ(speeds, (std::map<double, int>{{1, 2}, {2, 2}, {3, 2}}));
  EXPECT_EQ(ids.size(), 6u);
}

/// Over many particles the mean number of copies is the ratio of weights, within 4.5 of its own standard errors, and the sums
/// of the tally know the variance.
void expect_mean(double from, double to) {
  constexpr std::size_t particles = 20000;
  Border border(from, to, particles);
  border.cross();
  const double ratio = from / to, rest = ratio - std::floor(ratio);
  const double error = std::sqrt(rest * (1 - rest) / particles);
  EXPECT_NEAR(static_cast<double>(border.store.size()) / particles, ratio, 4.5 * error);
  const bool removed = from < to;
  EXPECT_NEAR(border.sum(Sums::variance, removed, 0), particles * 9 * to * to * rest * (1 - rest),
              1e-9 * particles * to * to);
  for (const std::size_t amount : {0, 1, 2, 3})
    EXPECT_LE(std::abs(border.sum(Sums::gained, removed, amount)),
              4.5 * std::sqrt(border.sum(Sums::variance, removed, amount)));
  const double gained = 3 * (to * static_cast<double>(border.store.size()) - from * particles);
  EXPECT_NEAR(border.sum(Sums::gained, removed, 0), gained, 1e-9 * particles * from);
}

TEST(Cloner, KeepsMassMomentumAndEnergyInTheMean) {
  expect_mean(1, 0.4);
  expect_mean(1, 0.7);
  expect_mean(0.5, 1);
  expect_mean(1, 3.7);
  expect_mean(1, 1000);
}

/// A removal of q = w1/w2 has the variance w2^2 q (1 - q) = w1 (w2 - w1).
TEST(Cloner, RemovalAddsTheProductOfWeightAndStep) {
  Border border(0.5, 2, 8);
  border.cross();
  EXPECT_NEAR(border.sum(Sums::variance, true, 0), 8 * 9 * 0.5 * 1.5, 1e-12);
}

TEST(Cloner, EqualWeightsDrawNothing) {
  Border border(2, 2, 10);
  border.cross();
  EXPECT_EQ(border.store.size(), 10u);
  for (const ExactSum& sum : border.tally.cloning) EXPECT_EQ(sum.value(), 0);
}

/// The draw of a particle is named by its place: more particles behind it change nothing for it.
TEST(Cloner, FateOfAParticleDoesNotDependOnOthers) {
  Border few(0.5, 1, 50), many(0.5, 1, 100);
  few.cross(3);
  many.cross(3);
  const auto ids = few.store.ids();
  ASSERT_GT(ids.size(), 10u);
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(ids[i], many.store.ids()[i]);
}

TEST(Cloner, EntrantsGetTheWeightOfTheirCell) {
  Border border(1, 0.5, 1);
  Particles<2> entrants;
  for (const double x : {0.1, 1.1, 1.2}) entrants.phases.push_back({{x, 0.5}, {1, 0}});
  entrants.columns.set(column::weight, std::vector<double>(3, 1.0));
  border.cloner.apply(entrants, border.store, std::span(&kKind, 1), {7, Purpose::cloning, 0, 0});
  ASSERT_EQ(entrants.phases.size(), 5u);
  const auto weights = entrants.columns.get(column::weight);
  EXPECT_TRUE(std::ranges::equal(weights, std::vector<double>{1, 0.5, 0.5, 0.5, 0.5}));
}

/// A millionth of the weight is a million copies; more in one step are refused, with the remedy.
TEST(Cloner, BoundsTheCopiesOfAStep) {
  Border border(1, 1e-6, 1);
  border.cross();
  EXPECT_NEAR(static_cast<double>(border.store.size()), 1e6, 1);
  Border two(1, 1e-6, 2);
  try {
    two.cross();
    FAIL();
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("put regions of weights between"), std::string::npos);
  }
}

TEST(Cloner, AMillionTimesTheWeightRemovesNearlyAll) {
  Border border(1, 1e6, 1000);
  border.cross();
  EXPECT_LE(border.store.size(), 1u);
  EXPECT_EQ(border.cloner.counters().at("particles-removed") + static_cast<double>(border.store.size()),
            1000);
}

/// With a planted fault mass is made or lost.
TEST(Cloner, FaultsShowInTheSums) {
  Border full(1, 0.5, 100, {.clones_keep_weight = true}), lost(0.5, 1, 100, {.survivors_keep_weight = true});
  full.cross();
  lost.cross();
  EXPECT_EQ(full.sum(Sums::gained, false, 0), 100 * 3);
  EXPECT_LT(lost.sum(Sums::gained, true, 0), -4.5 * std::sqrt(lost.sum(Sums::variance, true, 0)));
}

}  // namespace
}  // namespace sandglass::cloner_test
