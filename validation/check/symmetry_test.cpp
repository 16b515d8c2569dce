#include "sim/base/error.hpp"
#include "validation/check/synthetic.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

// A gas at rest, counted by hand: as many either way, or not.

namespace sandglass::symmetry_test {
namespace {

using namespace synthetic;

constexpr std::size_t kReplicas = 12;

/// In 4 by 6 cells.
Record gas_with(const std::string& observe, const std::string& initial = "") {
  GasScene scene;
  scene.initial = initial;
  scene.observe = observe;
  Record record = record_of(scene, kReplicas);
  const std::size_t at = record.scene.find("cells = [");
  record.scene.replace(at, record.scene.find(']', at) + 1 - at, "cells = [4, 6]");
  return record;
}

constexpr double kHalf = 28.02495608198964;  // of the edge of the box, sqrt(1000 pi/4/0.25)

std::string plane_at(double position) {
  return fmt::format(
      "[[observe]]\nwhat = \"crossings\"\naxis = \"x\"\nposition = {:.17g}\nrange = [-5.0, 5.0]\n"
      "bins = 40\nevery = {{ steps = 1 }}",
      position);
}

/// 10000 passages a replica, of which a share goes up.
Record passages(double up) {
  Record record = gas_with(plane_at(kHalf));
  Generator generator(5);
  for (std::size_t replica = 0; replica < kReplicas; ++replica) {
    Series& series = add_series(record, replica, "crossing-count", {"up", "down"});
    add_sample(series, 0, {7, 0});
    const double passed = std::binomial_distribution<int>(10000, up)(generator);
    add_sample(series, 100, {7 + passed, 10000 - passed});
  }
  return record;
}

double significance(const std::string& check, const Record& record) {
  const Evidence evidence = run_check(find_check(check), record, {});
  return std::abs(evidence.value) / evidence.standard_error;
}

TEST(PassageBalance, SeesAPreferredWay) {
  EXPECT_LT(significance("passage-balance", passages(0.5)), 4);
  EXPECT_GT(significance("passage-balance", passages(0.51)), 5);
  EXPECT_NEAR(run_check(find_check("passage-balance"), passages(0.6), {}).value, 0.2, 0.01);
}

TEST(PassageBalance, NeedsAGasAtRestAndSomebodyWhoPasses) {
  const auto applies = [](const Record& record) {
    return find_check("passage-balance").applies(Subject(record).scene());
  };
  EXPECT_TRUE(applies(gas_with(plane_at(kHalf))));
  EXPECT_FALSE(applies(gas_with(plane_at(kHalf), "velocity = [0.5, 0.0]")));
  EXPECT_TRUE(applies(gas_with(plane_at(kHalf / 4))));
  EXPECT_FALSE(applies(gas_with(plane_at(kHalf / 3))));
  EXPECT_FALSE(applies(gas_with("")));
  Record none = gas_with(plane_at(kHalf));
  for (std::size_t replica = 0; replica < kReplicas; ++replica)
    add_sample(add_series(none, replica, "crossing-count", {"up", "down"}), 0, {0, 0});
  EXPECT_THROW(run_check(find_check("passage-balance"), none, {}), InputError);
}

std::string fields_of(const std::string& grid) {
  return "[[observe]]\nwhat = \"fields\"\ngrid = " + grid + "\nevery = { steps = 1 }";
}

/// Counts by chance about 10 in the cells of one colour, about `other` in those of the other.
Record cells(double other) {
  Record record = gas_with(fields_of("[4, 6]"));
  Generator generator(6);
  for (std::size_t replica = 0; replica < kReplicas; ++replica) {
    Series& series = add_series(record, replica, "fields", {});
    series.quantity.shape = {4, 6, 4};
    for (int sample = 0; sample < 50; ++sample) {
      std::vector<double> values;
      for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 6; ++y) {
          const double mean = (x + y) % 2 == 0 ? 10 : other;
          const double count = std::poisson_distribution<int>(mean)(generator);
          values.insert(values.end(), {count, 0, 0, 1});
        }
      add_sample(series, sample, values);
    }
  }
  return record;
}

TEST(ColourBalance, SeesAPreferredColour) {
  EXPECT_LT(significance("colour-balance", cells(10)), 4);
  EXPECT_GT(significance("colour-balance", cells(9.5)), 5);
  EXPECT_NEAR(run_check(find_check("colour-balance"), cells(5), {}).value, 1 / 3.0, 0.02);
}

TEST(ColourBalance, NeedsTheCellsAsBins) {
  const auto applies = [](const std::string& grid) {
    return find_check("colour-balance").applies(Subject(gas_with(fields_of(grid))).scene());
  };
  EXPECT_TRUE(applies("[4, 6]"));
  EXPECT_FALSE(applies("[4, 3]"));
}

}  // namespace
}  // namespace sandglass::symmetry_test
