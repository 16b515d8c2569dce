#include "validation/check/check.hpp"
#include "validation/check/synthetic.hpp"
#include "validation/law/channel.hpp"
#include "validation/law/sedimentation.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

// Checks of streams and channels, on data drawn from the law and from one that is wrong on purpose.

namespace sandglass::synthetic::stream_test {
namespace {

/// Mean free path and most probable speed one; `species`, `sides` and `rest` are lines of TOML.
std::string scene_of(const std::string& size, const std::string& sides, const std::string& species,
                     const std::string& rest = "") {
  return R"([run]
duration = { steps = 100 }
[domain]
dimension = 3
size = )" +
         size + "\n[domain.sides]\nx = \"open\"\n" + sides + R"([[species]]
count = 400
diameter = 0.018977
)" + species +
         R"([[inflow]]
side = "x-low"
number-density = 625.0
velocity = [2.2567, 0.0, 0.0]
temperature = 0.5
spin-temperature = 0.5
[method]
preset = "dsmc"
cells = [8, 1, 1]
time-step = 0.1
)" + rest;
}

const std::string kElastic = "tangential-restitution = 1.0\n",
                  kGranular = "restitution = 0.6\ntangential-restitution = 0.0\n";

/// One bin over the inflow's values: density, velocity, translation, rotation.
using State = std::array<double, 4>;

/// Eight replicas of ten samples; `state` of the place, along x and y over the box, scattered by one part in a thousand.
Record record_with(const std::string& scene, std::array<std::size_t, 2> bins,
                   const std::function<State(double, double)>& state) {
  Record record = record_of({}, 8);
  record.scene = scene;
  Generator generator(11);
  std::normal_distribution<double> scatter(1, 1e-3);
  for (std::size_t replica = 0; replica < 8; ++replica) {
    Series fields, spins;
    fields.quantity = {"fields", "", "", {bins[0], bins[1], 1, 5}, {}, {}, ""};
    spins.quantity = {"spin-temperature", "", "", {bins[0], bins[1], 1}, {}, {}, ""};
    for (int sample = 0; sample < 10; ++sample) {
      std::vector<double> values, turning;
      for (std::size_t x = 0; x < bins[0]; ++x)
        for (std::size_t y = 0; y < bins[1]; ++y) {
          const State s = state((static_cast<double>(x) + 0.5) / static_cast<double>(bins[0]),
                                (static_cast<double>(y) + 0.5) / static_cast<double>(bins[1]));
          values.insert(values.end(), {625 * s[0] * scatter(generator), 2.2567 * s[1] * scatter(generator), 0,
                                       0, 0.5 * s[2] * scatter(generator)});
          turning.push_back(0.5 * s[3] * scatter(generator));
        }
      add_sample(fields, sample, values);
      add_sample(spins, sample, turning);
    }
    record.replicas[replica].series = {fields, spins};
  }
  return record;
}

Evidence run(const std::string& check, const Record& record, law::Arguments numbers = {}) {
  numbers["settle-time"] = 2;
  return run_check(find_check(check), record, {numbers, 0, 0, ""});
}

double deviation(const Evidence& evidence) { return std::abs(evidence.value - evidence.expected); }

const std::string kRow = scene_of("[16.0, 0.2, 0.2]", "", kElastic);

TEST(StreamChecks, SeeAStreamThatIsNotUniform) {
  const auto stream = [](double hot) {
    return record_with(kRow, {20, 1}, [hot](double x, double) {
      return State{1, 1, x > 0.5 && x < 0.6 ? hot : 1, 1};
    });
  };
  const Evidence good = run("uniform-stream", stream(1)), bad = run("uniform-stream", stream(1.02));
  EXPECT_LT(deviation(good), 6e-4);
  EXPECT_EQ(good.comparisons, 80);
  EXPECT_NEAR(deviation(bad), 0.02, 1e-3);
  EXPECT_NEAR(good.budget.systematic, 0.0034, 2e-4) << "what moves upstream at S = 2.2567";
}

/// Disks that leave where some are turned back.
const std::string kOpen = R"([run]
duration = { steps = 100 }
[domain]
dimension = 2
size = [60.0, 20.0]
sides.x = "open"
[[species]]
area-fraction = 0.5
[[inflow]]
side = "x-low"
number-density = 0.6
velocity = [0.1, 0.0]
temperature = 0.02
[[outflow]]
side = "x-high"
velocity = [0.1, 0.0]
temperature = 0.02
[method]
preset = "event-driven"
time-step = 0.1
[initial]
positions = "lattice"
)";

/// Twelve bins of which one, between 0.5 and 0.6, is off by these factors.
Record open_stream(double density, double velocity, double temperature) {
  Record record = record_of({}, 8);
  record.scene = kOpen;
  Generator generator(11);
  std::normal_distribution<double> scatter(1, 1e-3);
  for (std::size_t replica = 0; replica < 8; ++replica) {
    Series fields;
    fields.quantity = {"fields", "", "", {12, 1, 4}, {}, {}, ""};
    for (int sample = 0; sample < 10; ++sample) {
      std::vector<double> values;
      for (int bin = 0; bin < 12; ++bin) {
        const bool off = bin == 6;
        values.insert(values.end(), {0.6 * (off ? density : 1) * scatter(generator),
                                     0.1 * (off ? velocity : 1) * scatter(generator), 0,
                                     0.02 * (off ? temperature : 1) * scatter(generator)});
      }
      add_sample(fields, sample, values);
    }
    record.replicas[replica].series = {fields};
  }
  return record;
}

TEST(StreamChecks, SeeWhereAnOpenStreamIsNotHeld) {
  const std::vector<std::pair<std::string, Record>> cases = {{"stream-density", open_stream(0.9, 1, 1)},
                                                             {"stream-velocity", open_stream(1, 0.9, 1)},
                                                             {"stream-temperature", open_stream(1, 1, 0.9)}};
  for (const auto& [check, bad] : cases) {
    EXPECT_LT(deviation(run(check, open_stream(1, 1, 1))), 1e-3) << check;
    EXPECT_NEAR(deviation(run(check, bad)), 0.1, 2e-3) << check;
    EXPECT_LT(deviation(run(check, bad, {{"from", 0.0}, {"to", 0.5}})), 1e-3) << "it is elsewhere";
  }
}

// What a source brings and an obstacle takes is in no series.
TEST(StreamChecks, BalancesOfTheSidesAreForStreamsThatLiveByThem) {
  Scene scene = read_scene_text(kOpen, "scene.toml");
  scene.species.front().restitution = 1;
  for (const char* check : {"side-momentum", "side-energy"}) {
    EXPECT_TRUE(find_check(check).applies(scene));
    Scene poured = scene, blocked = scene;
    poured.sources.emplace_back();
    blocked.obstacles.emplace_back();
    EXPECT_FALSE(find_check(check).applies(poured));
    EXPECT_FALSE(find_check(check).applies(blocked));
  }
}

Record cooling(double restitution) {
  const law::CoolingStream start{{3, restitution, 0, 0.4}, 1, 2.2567, {0.5, 0.5}, 1};
  return record_with(scene_of("[16.0, 0.2, 0.2]", "", kGranular), {40, 1}, [&](double x, double) {
    const law::StreamState at = law::cooling_stream(start, 16 * x);
    return State{2.2567 / at.velocity, at.velocity / 2.2567, at.temperature.translation / 0.5,
                 at.temperature.rotation / 0.5};
  });
}

TEST(StreamChecks, SeeAnotherRestitution) {
  const Evidence good = run("cooling-stream-temperature", cooling(0.6)),
                 bad = run("cooling-stream-temperature", cooling(0.9));
  EXPECT_LT(deviation(good), 0.01 * good.expected);
  EXPECT_GT(deviation(bad), 1.1 * bad.budget.systematic);
  const Evidence fast = run("cooling-stream-velocity", cooling(0.6));
  EXPECT_LT(deviation(fast), 1e-3);
  EXPECT_GT(fast.expected, 1.07);
  EXPECT_LT(fast.budget.systematic, 0.02);
}

TEST(StreamChecks, SeeThatNobodyIsLost) {
  Record record = record_with(kRow, {20, 1}, [](double, double) { return State{1, 1, 1, 1}; });
  for (Replica& replica : record.replicas) {
    double found = 0;
    const std::vector<double>& values = replica.series[0].value;
    for (std::size_t bin = 0; bin < 20; ++bin) found += 0.032 * values[values.size() - 100 + 5 * bin];
    replica.counters = {{"particles-entered", 1000}, {"particles-left", 1400 - found}};
  }
  const Evidence good = run_check(find_check("particle-balance"), record, {});
  EXPECT_LT(good.value, good.budget.systematic);
  record.replicas[3].counters["particles-left"] += 1;
  EXPECT_NEAR(run_check(find_check("particle-balance"), record, {}).value, 1, 1e-6);
}

/// A number that still grows by a particle of a hundred that come in.
TEST(StreamChecks, SeeAFlowThatIsNotSteady) {
  Record record = record_with(kRow, {1, 1}, [](double, double) { return State{1, 1, 1, 1}; });
  const auto grow = [&](double rate) {
    for (Replica& replica : record.replicas) {
      Series& fields = replica.series[0];
      for (std::size_t i = 0; i < fields.samples(); ++i)
        fields.value[5 * i] = 625 + rate * fields.time[i] / (16 * 0.04);
    }
    return run("stream-steady", record);
  };
  const double enter = 625 * 0.04 * 2.2567;
  EXPECT_NEAR(grow(0).value, 0, 1e-12);
  EXPECT_NEAR(grow(0.01 * enter).value, 0.01, 1e-5);
}

/// Core and walls of a channel 8 high, by their distance from the middle over half the height.
Record channel(const std::function<State(double, double)>& state) {
  return record_with(scene_of("[16.0, 8.0, 0.2]", "y = \"specular\"\n", kGranular), {40, 20},
                     [&](double x, double y) { return state(x, std::abs(2 * y - 1)); });
}

TEST(ChannelChecks, MeasureCoreAndWalls) {
  const Record record = channel([](double x, double off) {
    const bool wall = off > 0.9, exit = x > 0.9;
    return State{wall ? 1.2 : 1.0, wall ? 0.5 : exit ? 1.1 : 1.0, wall ? 0.3 : 0.2, wall ? 0.6 : 0.4};
  });
  const auto value = [&](const char* name) { return run(name, record, {{"low", 0}, {"high", 9}}).value; };
  EXPECT_NEAR(value("channel-core-speed"), 1.1, 2e-3);
  EXPECT_NEAR(value("channel-core-temperature"), 0.3, 1e-3);
  EXPECT_NEAR(value("channel-wall-density"), 1.2, 2e-3);
}

/// A layer of half the height in which u rises from zero in a straight line: its thickness is a quarter of that.
TEST(ChannelChecks, MeasureTheLayer) {
  const Record record = channel([](double, double off) {
    return State{1, off < 0.5 ? 1 : 2 * (1 - off), 1, 1};
  });
  const Evidence evidence =
      run("channel-layer-thickness", record, {{"from", 2}, {"to", 4}, {"low", 0}, {"high", 9}});
  EXPECT_NEAR(evidence.value, 4 * 0.5 * 0.5, 0.01);
  EXPECT_EQ(evidence.kind, Expectation::between);
}

/// At rest from the start, but for a swing that is lowest at 10 and back at 15.
Record falling(double temperature) {
  const law::FallingStream stream{1, 0.5, 2.2567, 0.5, 4, 6};
  const law::StreamState end = law::falling_stream_end(stream);
  const double hot = temperature * end.temperature.translation;
  return record_with(
      scene_of("[32.0, 4.0, 0.2]", "y = \"specular\"\n", kElastic, "[forces]\ngravity = [0.0, -0.5, 0.0]\n"),
      {64, 40}, [=](double x, double y) {
        const double place = 32 * x;
        const double swing =
            place < 15 ? -0.4 * std::sin(std::numbers::pi * place / 20) * (15 - place) / 5 : 0;
        const double density = law::column_density({1, hot * (1 + swing), 0.5, 4}, 4 * y);
        return State{2.2567 / end.velocity * density, end.velocity / 2.2567, hot / 0.5, hot / 0.5};
      });
}

TEST(FallingStreamChecks, SeeAnotherEnd) {
  const law::Arguments far{{"from", 0.65}, {"to", 0.9}};
  for (const char* name : {"falling-stream-temperature", "falling-stream-profile"}) {
    const Evidence good = run(name, falling(1), far), bad = run(name, falling(1.05), far);
    EXPECT_LT(deviation(good), 3e-3) << name;
    EXPECT_GT(deviation(bad), 3 * bad.budget.systematic) << name;
  }
  EXPECT_LT(deviation(run("falling-stream-velocity", falling(1), far)), 1e-3);
}

TEST(FallingStreamChecks, FindTheSwing) {
  const Record record = falling(1);
  const law::Arguments words{{"low", 7.5}, {"high", 12.5}};
  const double lowest = run("falling-stream-overshoot", record, words).value;
  EXPECT_NEAR(lowest, 6.06, 0.5) << "sin(pi x/20) (15 - x) is largest there";
  EXPECT_NEAR(run("falling-stream-recovery", record, words).value, 15, 1);
}

}  // namespace
}  // namespace sandglass::synthetic::stream_test
