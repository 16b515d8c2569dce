#include "validation/check/check.hpp"
#include "validation/check/collapse_reference.hpp"
#include "validation/check/synthetic.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

// Records of falling disks made by hand: right ones pass, wrong ones do not.

namespace sandglass::falling_test {
namespace {

using namespace synthetic;

constexpr double kGravity = 9.81;

Record disks(double restitution, std::size_t replicas, const std::string& preset = "dsmc") {
  Record record;
  record.scene =
      "[run]\nduration = { time = 0.6 }\n[domain]\ndimension = 2\nsize = [0.02, 0.04]\n"
      "sides = { x = \"specular\", y = \"specular\" }\n"
      "[forces]\ngravity = [0.0, -9.81]\n[[species]]\ncount = 100\ndiameter = 0.001\nrestitution = " +
      std::to_string(restitution) + "\n[method]\npreset = \"" + preset +
      "\"\ncells = [10, 20]\ntime-step = 0.001\n";
  record.replicas.resize(replicas);
  for (Replica& replica : record.replicas) replica.counters = {{"collisions", 1000}, {"steps", 600}};
  return record;
}

/// Heights at the times of all samples; walls give what momentum asks for, times `factor`.
template <class Height>
void add_fall(Record& record, std::size_t replica, Height height, double factor, double gravity = kGravity) {
  record.replicas[replica].series.reserve(4);  // references stay
  Series& centre = add_series(record, replica, "centre-of-mass", {"x", "y"});
  Series& momentum = add_series(record, replica, "momentum", {"x", "y"});
  Series& scale = add_series(record, replica, "momentum-scale", {});
  Series& force = add_series(record, replica, "wall-force", {"y-low-x", "y-low-y", "y-high-x", "y-high-y"});
  const auto speed = [&](double t) { return (height(t + 1e-6) - height(t - 1e-6)) / 2e-6; };
  for (int i = 0; i <= 60; ++i) {
    const double t = 0.01 * i;
    add_sample(centre, t, {0.01, height(t)});
    add_sample(momentum, t, {0, 100 * speed(t)});
    add_sample(scale, t, {100 * std::abs(speed(t)) + 1});
    const double given = 100 * (speed(t) - speed(t - 0.01)) + 100 * gravity * 0.01;
    if (i > 0) add_sample(force, t, {0, std::abs(given) < 1e-8 ? 0 : -factor * given / 0.01, 0, 0});
  }
}

/// Free fall until it has come down to a height, then rest.
double drop(double t) { return std::max(0.0024, 0.02 - kGravity * t * t / 2); }

double beyond(const std::string& check, const Record& record, const Settings& settings = {}) {
  const Evidence evidence = run_check(find_check(check), record, settings);
  return std::abs(evidence.value - evidence.expected) / evidence.budget.systematic;
}

TEST(Falling, FreeFallUntilAWallActs) {
  Record right = disks(0.9, 1), wrong = disks(0.9, 1);
  add_fall(right, 0, drop, 1);
  add_fall(
      wrong, 0, [](double t) { return std::max(0.0024, 0.02 - 1.01 * kGravity * t * t / 2); }, 1,
      1.01 * kGravity);
  EXPECT_LT(beyond("free-fall", right), 1);
  EXPECT_GT(beyond("free-fall", wrong), 1e3);
  Record early = disks(0.9, 1);
  add_fall(
      early, 0, [](double) { return 0.02; }, 1);
  EXPECT_TRUE(std::isnan(run_check(find_check("free-fall"), early, {}).value));
}

TEST(Falling, WeightOnTheFloor) {
  Record right = disks(0.9, 4), light = disks(0.9, 4);
  for (std::size_t replica = 0; replica < 4; ++replica) {
    add_fall(right, replica, drop, 1);
    add_fall(light, replica, drop, 0.99);
  }
  EXPECT_NEAR(run_check(find_check("weight-on-floor"), right, {{{"settle-time", 0.3}}, 0, 0, ""}).value, 1,
              1e-9);
  EXPECT_NEAR(run_check(find_check("weight-on-floor"), light, {{{"settle-time", 0.3}}, 0, 0, ""}).value, 0.99,
              1e-9);
}

/// Momentum of the drop is taken by differences of the height: good to 1e-8.
TEST(Falling, MomentumCountsRefusedMoves) {
  const auto off = [](double factor, double refused) {
    Record record = disks(0.9, 1, "hsmc");
    add_fall(
        record, 0, [](double) { return 0.01; }, factor);
    record.replicas[0].counters["moves-refused"] = refused;
    return run_check(find_check("momentum-under-gravity"), record, {}).value;
  };
  EXPECT_LT(off(1, 0), 1e-12);
  EXPECT_GT(off(0.99, 0), 0.009);
  EXPECT_LT(off(0.99, 0.01 * 100 * 600), 1e-12);  // a hundredth of all moves
}

TEST(Packing, HeightAtRest) {
  const auto at = [](double height) {
    Record record = disks(0.9, 8);
    for (std::size_t replica = 0; replica < 8; ++replica)
      add_fall(
          record, replica, [=](double) { return height; }, 1);
    return beyond("packed-height", record, {{{"settle-time", 0.3}}, 0, 0, ""});
  };
  EXPECT_LT(at(0.0024), 0.1);
  EXPECT_LT(at(0.0016), 1);
  EXPECT_GT(at(0.0001), 1);
}

/// Cells of 0.002 hold four disks at a fraction of 0.82.
TEST(Packing, CrowdedCells) {
  const auto share = [](double in_first) {
    Record record = disks(0.9, 8);
    for (std::size_t replica = 0; replica < 8; ++replica) {
      Series& fields = add_series(record, replica, "fields", {});
      fields.quantity.shape = {10, 20, 4};
      std::vector<double> values(800, 0.0);
      values[0] = in_first / 4e-6;
      for (std::size_t bin = 1; bin < 25; ++bin) values[4 * bin] = 4 / 4e-6;
      add_sample(fields, 0.5, values);
    }
    return run_check(find_check("crowded-cells"), record, {{{"settle-time", 0.3}, {"most", 0.05}}, 0, 0, ""})
        .value;
  };
  EXPECT_DOUBLE_EQ(share(4), 0);
  EXPECT_NEAR(share(14), 10.0 / 110, 1e-12);
}

double at(const std::vector<CollapsePoint>& points, double time) {
  for (const CollapsePoint& point : points)
    if (std::abs(point.time - time) < 1e-6) return point.height;
  return 0;
}

/// Furthest distance from the reference, for heights that lie `off` above it from `from` on.
double distance(const std::string& check, double restitution, double off, double from) {
  Record record = disks(restitution, 8);
  for (std::size_t replica = 0; replica < 8; ++replica) {
    add_fall(
        record, replica, [](double) { return 0.02; }, 1);
    Series& centre = record.replicas[replica].series.front();
    for (std::size_t i = 0; i < centre.samples(); ++i) {
      const double t = centre.time[i];
      const double falling = 0.02 - kGravity * t * t / 2;
      centre.value[2 * i + 1] =
          (t > 0.055 ? at(collapse_height(restitution), t) : falling + at(collapse_lift(restitution), t)) +
          (t >= from ? off : 0);
    }
  }
  return run_check(find_check(check), record, {}).value;
}

TEST(Collapse, CurveAgainstReference) {
  for (const double restitution : {0.9, 0.5}) {
    EXPECT_NEAR(distance("collapse-start", restitution, -0.002, 0.045), -0.002, 1e-9);
    EXPECT_NEAR(distance("collapse-start", restitution, -0.002, 0.055), 0, 1e-9);
    EXPECT_NEAR(distance("collapse-end", restitution, -0.002, 0.055), -0.002, 1e-9);
    EXPECT_NEAR(distance("collapse-end", restitution, 0, 0), 0, 1e-9);
  }
}

TEST(Collapse, ReferenceStartsInFreeFallAndEndsAtRest) {
  for (const double restitution : {0.9, 0.5}) {
    EXPECT_LT(collapse_lift(restitution).front().height, 0.001);
    EXPECT_NEAR(collapse_height(restitution).back().height, 0.0024, 0.0002);
  }
}

}  // namespace
}  // namespace sandglass::falling_test
