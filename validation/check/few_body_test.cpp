#include "validation/law/few_body.hpp"

#include "sim/base/error.hpp"
#include "validation/check/check.hpp"
#include "validation/law/few_body_bounce.hpp"

#include <cmath>

#include <gtest/gtest.h>

// Each check sees a record written by its law, and one that is a little off.

namespace sandglass::few_body_test {
namespace {

Record record_of(const std::string& scene) {
  Record record;
  record.scene = scene;
  record.replicas.push_back({1, {}, {}});
  return record;
}

constexpr const char* kRow = R"(
run = { duration = { time = 6.0 } }
domain = { dimension = 2, size = [20.0, 20.0] }
method = { preset = "event-driven", time-step = 1.0 }
initial = { positions = "given" }
species = [{ restitution = 0.3 }]
particle = [
  { position = [9.0, 10.0], velocity = [1.0, 0.0] },
  { position = [10.2, 10.0], velocity = [0.0, 0.0] },
  { position = [11.7, 10.0], velocity = [-1.0, 0.0] },
]
output = { ids = true, trajectory = { steps = 1 } }
observe = [{ what = "collisions" }]
)";

/// Frames of three balls in a row, in the order 2, 3, 1, with the first ball moved by `shift` in the last one.
Record row_record(double restitution, double shift) {
  Record record = record_of(kRow);
  std::vector<law::Ball> balls(3);
  const double place[] = {9, 10.2, 11.7}, speed[] = {1, 0, -1};
  for (std::size_t i = 0; i < 3; ++i) {
    balls[i].position = {place[i], 10, 0};
    balls[i].velocity[0] = speed[i];
  }
  for (int step = 0; step <= 6; ++step) {
    const law::FewBodyResult now = law::few_body(
        balls, [=](auto, auto) { return law::Touch{restitution}; }, step);
    Frame frame{static_cast<std::uint64_t>(step), static_cast<double>(step), {}, {}};
    for (const std::uint64_t id : {1, 2, 0}) {
      frame.columns.append(column::id, id);
      const law::Ball& ball = now.balls[id];
      frame.position.insert(frame.position.end(), {ball.position[0], ball.position[1]});
      frame.velocity.insert(frame.velocity.end(), {ball.velocity[0], ball.velocity[1]});
    }
    record.trajectory.push_back(frame);
    record.replicas[0].counters["collisions"] = static_cast<double>(now.collisions);
  }
  record.trajectory.back().position[4] += shift;
  return record;
}

double excess(const Evidence& evidence) {
  return std::abs(evidence.value - evidence.expected) - evidence.budget.systematic;
}

double excess_of(const std::string& check, const Record& record) {
  return excess(run_check(find_check(check), record, {}));
}

TEST(FewBodyState, SeesOneWrongPlaceAndAnotherRestitution) {
  EXPECT_LE(excess_of("few-body-state", row_record(0.3, 0)), 0);
  EXPECT_LE(excess_of("few-body-state", row_record(0.3, 20)), 0);  // an image
  EXPECT_GT(excess_of("few-body-state", row_record(0.3, 1e-8)), 0);
  EXPECT_GT(excess_of("few-body-state", row_record(0.3001, 0)), 0);
}

TEST(FewBodyState, NotANumberStaysVisible) {
  const Evidence evidence = run_check(find_check("few-body-state"), row_record(0.3, std::nan("")), {});
  EXPECT_TRUE(std::isnan(evidence.value));
}

TEST(FewBodyState, NeedsIdentities) {
  Record record = row_record(0.3, 0);
  for (Frame& frame : record.trajectory) frame.columns.remove("id");
  EXPECT_THROW(run_check(find_check("few-body-state"), record, {}), InputError);
}

TEST(ThreeBodyCollisions, AreCounted) {
  EXPECT_LE(excess_of("three-body-collisions", row_record(0.3, 0)), 0);
  EXPECT_GT(excess_of("three-body-collisions", row_record(0.306, 0)), 0);  // 3 instead of 4
}

TEST(FewBodyChecks, ApplyToTheirScenes) {
  const Scene row = read_scene_text(kRow, "row");
  EXPECT_TRUE(find_check("few-body-state").applies(row));
  EXPECT_TRUE(find_check("three-body-collisions").applies(row));
  EXPECT_FALSE(find_check("cradle-speed").applies(row));  // the last ball moves
  EXPECT_FALSE(find_check("bouncing-ball").applies(row));
  Scene collapsing = row;
  collapsing.species[0].restitution = 0.05;
  EXPECT_FALSE(find_check("three-body-collisions").applies(collapsing));
}

constexpr const char* kFall = R"(
run = { duration = { time = 3.0 } }
domain = { dimension = 2, size = [8.0, 4.0], sides = { y = "specular" } }
method = { preset = "event-driven", time-step = 0.3 }
initial = { positions = "given" }
forces = { gravity = [0.0, -1.0] }
species = [{ diameter = 1.0 }]
particle = [{ position = [4.0, 1.0], velocity = [0.0, 0.0] }]
output = { ids = true, trajectory = { steps = 1 } }
)";

template <class State>
Record fall_record(const std::string& wall, const State& state) {
  Record record = record_of(kFall + wall);
  for (int step = 0; step <= 10; ++step) {
    const double time = 0.3 * step;
    const law::BounceState now = state(time);
    record.trajectory.push_back(
        {static_cast<std::uint64_t>(step), time, {4, now.height + 0.5}, {0, now.velocity}});
    record.trajectory.back().columns.append(column::id, 0);
    record.replicas[0].counters["particle-moves"] = now.bounces;
  }
  return record;
}

Record bouncing_record(double restitution) {
  return fall_record("wall = [{ side = \"y-low\", restitution = 0.6 }]\n", [=](double time) {
    return law::bouncing_ball({1, 0.5, 0, restitution, 0}, time);
  });
}

TEST(BouncingBallCheck, SeesAnotherFloor) {
  EXPECT_LE(excess_of("bouncing-ball", bouncing_record(0.6)), 0);
  EXPECT_LE(excess_of("bounces", bouncing_record(0.6)), 0);
  EXPECT_GT(excess_of("bouncing-ball", bouncing_record(0.6001)), 0);
  EXPECT_GT(excess_of("bounces", bouncing_record(0.7)), 0);
}

Record vibrated_record(double restitution) {
  return fall_record(
      "wall = [{ side = \"y-low\", restitution = 0.5, amplitude = 0.0334, frequency = 1.0 }]\n",
      [=](double time) {
        return law::period_one_orbit({1, 0.0334, 1, restitution}, time);
      });
}

double orbit_excess(double restitution) {
  return excess(run_check(find_check("period-one-orbit"), vibrated_record(restitution),
                          {{{"settle-periods", 0}}, 0, 0, ""}));
}

TEST(PeriodOneOrbitCheck, SeesAnotherFloor) {
  EXPECT_LE(orbit_excess(0.5), 0);
  EXPECT_GT(orbit_excess(0.501), 0);
}

}  // namespace
}  // namespace sandglass::few_body_test
