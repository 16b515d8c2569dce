#include "validation/check/pipe.hpp"

#include "sim/base/error.hpp"
#include "validation/check/check.hpp"
#include "validation/check/synthetic.hpp"
#include "validation/law/fluctuation.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

// Each check of a pipe sees data drawn from its law, and data that is off.

namespace sandglass::pipe_test {
namespace {

using namespace synthetic;
using std::numbers::pi;

constexpr double kFraction = 0.2;
constexpr std::size_t kSlices = 20;
constexpr int kParticles = 1000;

std::string pipe_scene(double restitution, const std::string& forces) {
  return "[run]\nduration = { time = 100.0 }\n"
         "[domain]\ndimension = 2\nsize = [19.634954084936208, 200.0]\nsides = { x = \"specular\" }\n"
         "[[species]]\ncount = 1000\nrestitution = " +
         std::to_string(restitution) +
         "\n[[wall]]\nside = \"x-low\"\nrule = \"bounce-back\"\nprobability = 0.5\n"
         "[method]\npreset = \"cba\"\ncell-size = 4.0\ntime-step = 0.1\n" +
         forces;
}

const std::string falling = "[forces]\ngravity = [0.0, -1.0]\n";

Record record_with(const std::string& scene, std::size_t replicas) {
  Record record;
  record.scene = scene;
  record.replicas.resize(replicas);
  for (Replica& replica : record.replicas)
    replica.counters = {{"steps", 1000}, {"particle-moves", 1e6}, {"collisions", 1e5}};
  return record;
}

/// Counts by `count(t, slice)` at unit intervals, and the energy of particles of speed one.
template <class Count>
void add_slices(Record& record, std::size_t replica, std::size_t samples, const Count& count) {
  Series& fields = add_series(record, replica, "fields", {});
  fields.quantity.shape = {1, kSlices, 4};
  const double bin = 19.634954084936208 * 200 / kSlices;
  for (std::size_t t = 0; t < samples; ++t) {
    std::vector<double> values;
    for (std::size_t slice = 0; slice < kSlices; ++slice)
      values.insert(values.end(), {count(t, slice) / bin, 0, 0, 1});
    add_sample(fields, static_cast<double>(t), values);
  }
  add_sample(add_series(record, replica, "energy", {}), 0, {0.5 * kParticles});
  add_sample(add_series(record, replica, "momentum", {"x", "y"}), 0, {0, -2.0 * kParticles});
}

Record with_scatter(double restitution, const std::string& forces, double variance) {
  Record record = record_with(pipe_scene(restitution, forces), 16);
  Generator generator(3);
  const double mean = kParticles / static_cast<double>(kSlices);
  const law::Gas gas{2, 1, 1, 1, kFraction, restitution};
  std::normal_distribution<double> noise(
      0, std::sqrt(variance * law::count_variance(gas, mean, 1.0 / kSlices) * kSlices / (kSlices - 1.0)));
  for (std::size_t replica = 0; replica < 16; ++replica) {
    std::vector<double> counts(kSlices);
    add_slices(record, replica, 50, [&](std::size_t, std::size_t slice) {
      if (slice == 0) {  // what one slice has more, all have less: the number is fixed
        double sum = 0;
        for (double& count : counts) sum += count = noise(generator);
        for (double& count : counts) count += mean - sum / kSlices;
      }
      return counts[slice];
    });
  }
  return record;
}

double significance(const Evidence& evidence) {
  return (evidence.value - evidence.expected) / evidence.standard_error;
}

// Cells of 4 along 200, three of them in the window: the law of such a fluid, and 1.2 times as much.
TEST(PipeCountVariance, SeesTooMuchScatter) {
  const CheckInfo& check = find_check("pipe-count-variance");
  const Settings settings{{{"settle-time", 0.0}, {"window", 3.0}}, 0, 0, ""};
  const law::Gas gas{2, 1, 1, 1, kFraction, 1};
  const double share = 1.0 / kSlices;
  const double cells =
      law::cell_count_variance(gas, 1, share, 200, {4, 3}) / law::count_variance(gas, 1, share);
  EXPECT_GT(cells, 1.1);
  EXPECT_LT(std::abs(significance(run_check(check, with_scatter(1, "", cells), settings))), 4);
  EXPECT_GT(significance(run_check(check, with_scatter(1, "", 1.2 * cells), settings)), 5);
}

TEST(PipeWaves, IsTheRatioToAnElasticFluid) {
  const Settings settings{{{"settle-time", 0.0}, {"least", 10.0}, {"most", 1e6}}, 0, 0, ""};
  const Evidence evidence = run_check(find_check("pipe-waves"), with_scatter(0.5, falling, 30), settings);
  EXPECT_NEAR(evidence.value, 30, 4 * evidence.standard_error);
  EXPECT_EQ(evidence.kind, Expectation::between);
}

TEST(PipeSlices, RefuseSamplesThatAreNotEquallySpaced) {
  Record record = with_scatter(0.5, falling, 1);
  for (Series& series : record.replicas[0].series)
    if (series.quantity.name == "fields") series.time[7] += 0.5;
  const Settings settings{{{"settle-time", 0.0}, {"least", 0.0}, {"most", 1.0}}, 0, 0, ""};
  EXPECT_THROW(run_check(find_check("pipe-waves"), record, settings), InputError);
}

/// Waves of random phase and of amplitudes k^(exponent/2) that pass at one slice per time.
Record with_spectrum(double exponent, double speed) {
  Record record = record_with(pipe_scene(0.5, falling), 8);
  Generator generator(5);
  std::normal_distribution<double> normal;
  constexpr std::size_t samples = 512;
  for (std::size_t replica = 0; replica < 8; ++replica) {
    std::vector<double> series(samples, 0.0);
    for (std::size_t k = 1; k < samples / 2; ++k) {
      const double size = std::pow(static_cast<double>(k), exponent / 2);
      const double cosine = size * normal(generator), sine = size * normal(generator);
      for (std::size_t t = 0; t < samples; ++t) {
        const double phase = 2 * pi * static_cast<double>(k * t % samples) / samples;
        series[t] += cosine * std::cos(phase) + sine * std::sin(phase);
      }
    }
    add_slices(record, replica, samples, [&](std::size_t t, std::size_t slice) {
      const auto delay = static_cast<std::size_t>(speed) * t;
      return 50 + (speed > 0 ? series[(slice + delay) % kSlices] : series[(t + 37 * slice) % samples]);
    });
  }
  return record;
}

TEST(PipeSpectrum, FindsTheExponent) {
  const Settings settings{
      {{"settle-time", 0.0}, {"low-cut", 0.0}, {"high-cut", 1e3}, {"least", -2.0}, {"most", 0.0}}, 0, 0, ""};
  for (double exponent : {-1.3, 0.0}) {
    const Evidence evidence = run_check(find_check("pipe-spectrum"), with_spectrum(exponent, 0), settings);
    EXPECT_NEAR(evidence.value, exponent, 4 * evidence.standard_error) << exponent;
    EXPECT_LT(evidence.standard_error, 0.1);
  }
}

// One slice of 10 per unit of time downwards, the stream makes 2.
TEST(PipeWaveSpeed, IsThatOfThePatternOverTheStream) {
  const Settings settings{{{"settle-time", 0.0}, {"lags", 3.0}, {"least", 0.0}, {"most", 6.0}}, 0, 0, ""};
  const Evidence evidence = run_check(find_check("pipe-wave-speed"), with_spectrum(-1, 1), settings);
  EXPECT_NEAR(evidence.value, 5, 0.1);
}

// The same in given units of speed, positive along gravity: 10 down over 20.
TEST(PipeWaveSpeed, IsPositiveAlongGravity) {
  const Settings settings{
      {{"settle-time", 0.0}, {"lags", 3.0}, {"over", 20.0}, {"least", 0.0}, {"most", 6.0}}, 0, 0, ""};
  const Record down = with_spectrum(-1, 1);
  EXPECT_NEAR(run_check(find_check("pipe-wave-speed"), down, settings).value, 0.5, 0.01);
  Record up = down;
  up.scene.replace(up.scene.find("-1.0]"), 5, "1.0]");
  EXPECT_NEAR(run_check(find_check("pipe-wave-speed"), up, settings).value, -0.5, 0.01);
}

/// `rate` passages down per time, and a few up, with chance.
Record with_passages(double rate) {
  Record record = record_with(
      pipe_scene(0.5, falling) + "[[observe]]\nwhat = \"crossings\"\naxis = \"y\"\nposition = 100.0\n", 16);
  Generator generator(11);
  std::poisson_distribution<int> down(rate + 2), up(2);
  for (std::size_t replica = 0; replica < 16; ++replica) {
    Series& passages = add_series(record, replica, "crossing-count", {"up", "down"});
    double upwards = 0, downwards = 0;
    for (int t = 0; t <= 100; ++t) {
      add_sample(passages, t, {upwards, downwards});
      upwards += up(generator), downwards += (t < 20 ? 5 : 1) * down(generator);
    }
  }
  return record;
}

// A stream of speed v and area fraction 0.2 carries 0.2 v, the reference 0.2 at half of the fraction.
TEST(PipeFlowGrowth, ComparesWithTheReference) {
  const double density = kFraction / (pi / 4), width = 19.634954084936208;
  for (const double speed : {2.0, 3.0}) {
    const Settings settings{{{"settle-time", 20.0},
                             {"fraction", 0.1},
                             {"rate", 0.2},
                             {"rate-error", 0.01},
                             {"least", 0.0},
                             {"most", 2.0}},
                            0,
                            0,
                            ""};
    const Evidence evidence =
        run_check(find_check("pipe-flow-growth"), with_passages(density * width * speed), settings);
    EXPECT_NEAR(evidence.value, std::log(kFraction * speed / 0.2) / std::log(2), 5 * evidence.standard_error);
    EXPECT_LT(evidence.standard_error, 0.03);  // chance gives 0.015
    EXPECT_NEAR(evidence.budget.reference, 0.05 / std::log(2), 1e-12);
  }
}

/// Walls that take `friction` of the weight, and a stream that takes up the rest.
Record with_forces(double friction, double gained, double refused) {
  Record record = record_with(pipe_scene(0.5, falling), 8);
  Generator generator(7);
  std::normal_distribution<double> noise(0, 0.02 * kParticles);
  for (std::size_t replica = 0; replica < 8; ++replica) {
    if (refused > 0) record.replicas[replica].counters["moves-refused"] = refused * 1e6;
    record.replicas[replica].series.reserve(3);  // references stay
    Series& force = add_series(record, replica, "wall-force", {});
    force.quantity.shape = {2, 2};
    Series& momentum = add_series(record, replica, "momentum", {"x", "y"});
    Series& scale = add_series(record, replica, "momentum-scale", {});
    double moving = 0;
    add_sample(momentum, 0, {0, 0});
    add_sample(scale, 0, {kParticles});
    for (int t = 1; t <= 100; ++t) {
      const double half = (friction * kParticles + noise(generator)) / 2;
      add_sample(force, t, {3, -half, -3, -half});
      moving -= gained * kParticles - 2 * half;
      add_sample(momentum, t, {0, moving});
      add_sample(scale, t, {kParticles});
    }
  }
  return record;
}

TEST(PipeMomentum, ClosesToRounding) {
  const CheckInfo& check = find_check("pipe-momentum");
  for (double refused : {0.0, 0.25}) {
    const Evidence closed = run_check(check, with_forces(0.9, 1 - refused, refused), {});
    EXPECT_LT(closed.value, closed.budget.systematic);
    const Evidence open = run_check(check, with_forces(0.9, 1.0001 * (1 - refused), refused), {});
    EXPECT_GT(open.value, 10 * open.budget.systematic);
  }
}

TEST(PipeFriction, CarriesTheWeightOfWhatMoves) {
  const CheckInfo& check = find_check("pipe-friction");
  const Settings settings{{{"settle-time", 10.0}}, 0, 0, ""};
  const Evidence steady = run_check(check, with_forces(0.75, 0.75, 0.25), settings);
  EXPECT_NEAR(steady.value, 1, 5 * 0.02 / 0.75 / std::sqrt(8 * 90.0));  // the error that was drawn
  EXPECT_GT(significance(run_check(check, with_forces(0.8, 0.75, 0.25), settings)), 5);
}

TEST(PipeChecks, ApplyToPipesAlone) {
  const Record pipe = record_with(pipe_scene(0.5, falling), 1), still = record_with(pipe_scene(1, ""), 1);
  EXPECT_TRUE(is_falling_pipe(Subject(pipe).scene()));
  EXPECT_FALSE(is_pipe_at_rest(Subject(pipe).scene()));
  EXPECT_TRUE(is_pipe_at_rest(Subject(still).scene()));
  const Record gas = record_of({}, 1);
  EXPECT_EQ(pipe_axis(Subject(gas).scene()), -1);
}

}  // namespace
}  // namespace sandglass::pipe_test
