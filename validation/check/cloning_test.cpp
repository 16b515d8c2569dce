#include "validation/check/synthetic.hpp"

#include <cmath>

#include <gtest/gtest.h>

// Sums over crossings as draws make them, and with masses that are made or lost.

namespace sandglass::synthetic::cloning_test {
namespace {

const std::vector<std::string> kNames = {"cloned-mass",  "cloned-momentum-x",  "cloned-energy",
                                         "removed-mass", "removed-momentum-x", "removed-energy"};

const std::string kScene = R"([run]
duration = { steps = 100 }
[domain]
dimension = 2
size = [4.0, 4.0]
[[species]]
count = 100
diameter = 0.01
[[region]]
low = [0.0, 0.0]
high = [2.0, 4.0]
weight = 0.5
[method]
preset = "dsmc"
cells = [4, 4]
time-step = 0.1
)";

/// Eight replicas of 1000 particles of weight one each way, between weights that differ by `ratio`; copies have `factor` as
/// much as they should.
Record crossings(double ratio, double factor) {
  Record record = record_of({}, 8);
  record.scene = kScene;
  Generator generator(5);
  std::bernoulli_distribution stays(1 / ratio);
  for (std::size_t replica = 0; replica < 8; ++replica) {
    double more = 0;
    for (int i = 0; i < 1000; ++i) more += (stays(generator) ? factor * ratio : 0) - 1;
    const double spread = 1000 * (ratio - 1);
    add_sample(add_series(record, replica, "cloning-brought", kNames), 1, {1000, 400, 500, 1000, 400, 500});
    add_sample(add_series(record, replica, "cloning-gained", kNames), 1,
               {1000 * (factor - 1), 0, 0, more, 0.3 * more, 0.5 * more});
    add_sample(add_series(record, replica, "cloning-variance", kNames), 1,
               {0, 0, 0, spread, 0.09 * spread, 0.25 * spread});
  }
  return record;
}

Evidence balance(double ratio, double factor) {
  return run_check(find_check("cloning-balance"), crossings(ratio, factor), {});
}

double significance(const Evidence& evidence) {
  return std::abs(evidence.value - evidence.expected) / evidence.standard_error;
}

TEST(CloningBalance, HoldsForFairDraws) {
  for (const double ratio : {1.5, 2.0, 8.0}) {
    const Evidence evidence = balance(ratio, 1);
    EXPECT_LT(significance(evidence), 4) << ratio;
    EXPECT_EQ(evidence.comparisons, 3) << "what is cloned into whole copies leaves nothing to chance";
  }
}

TEST(CloningBalance, SeesMassThatIsMadeOrLost) {
  for (const double factor : {0.8, 1.2}) EXPECT_GT(significance(balance(2, factor)), 4.5) << factor;
}

TEST(CloningBalance, IsForScenesWithRegions) {
  EXPECT_TRUE(find_check("cloning-balance").weighs);
  EXPECT_FALSE(find_check("particle-balance").weighs);
  EXPECT_THROW(run_check(find_check("collision-rate"), crossings(2, 1), {}), InputError);
}

}  // namespace
}  // namespace sandglass::synthetic::cloning_test
