#include "sim/base/error.hpp"
#include "sim/run/run.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

// Hybrid simulation Monte Carlo at its limits, in a pipe under gravity: whatever the cells and the step, the run ends in
// a finite state and its momentum closes, with gravity on those that moved alone.

namespace sandglass::full_pipe_test {
namespace {

struct FullPipe {
  const char* name;
  const char* preset;
  double fraction, time_step;
  const char* cells;
};

constexpr double kGravity = 1.0, kDuration = 30.0;

Scene scene_of(const FullPipe& pipe) {
  const std::string text = R"(
run.duration = {{ time = {} }}
[domain]
dimension = 2
size = [20.0, 40.0]
sides.x = "specular"
[[wall]]
side = "x-low"
rule = "bounce-back"
probability = 0.5
[[wall]]
side = "x-high"
rule = "bounce-back"
probability = 0.5
[[species]]
area-fraction = {}
restitution = 0.0
[method]
preset = "{}"
cells = {}
time-step = {}
[forces]
gravity = [0.0, -{}]
[[observe]]
what = "momentum"
every = {{ time = 10.0 }}
[[observe]]
what = "energy"
every = {{ time = 10.0 }}
[[observe]]
what = "wall-force"
every = {{ time = 10.0 }}
)";
  return read_scene_text(fmt::format(fmt::runtime(text), kDuration, pipe.fraction, pipe.preset, pipe.cells,
                                     pipe.time_step, kGravity),
                         "pipe.toml");
}

const Series& series(const Record& record, const std::string& name) {
  for (const Series& series : record.replicas[0].series)
    if (series.quantity.name == name) return series;
  throw InputError("no series " + name);
}

class FullPipes : public testing::TestWithParam<FullPipe> {};

TEST_P(FullPipes, RunToAFiniteStateWithTheirMomentumClosed) {
  const Scene scene = scene_of(GetParam());
  const Record record = run_scene(scene);
  const auto& counters = record.replicas[0].counters;
  const double particles = counters.at("particle-moves") / counters.at("steps");
  const double moved = 1 - counters.at("moves-refused") / counters.at("particle-moves");
  const Series &momentum = series(record, "momentum"), &force = series(record, "wall-force");
  const double time = momentum.time.back(), weight = particles * kGravity * time;
  double taken = 0;
  for (std::size_t sample = 0; sample < force.samples(); ++sample)
    taken += (force.value[4 * sample + 1] + force.value[4 * sample + 3]) *
             (momentum.time[sample + 1] - momentum.time[sample]);
  const double gained = momentum.value[momentum.value.size() - 1] - momentum.value[1];
  EXPECT_NEAR((taken + gained) / weight, -moved, 1e-11);
  // Nobody is faster than by falling all the time without a wall, beside what the start gave: energy per particle 1.
  const double energy = series(record, "energy").value.back() / particles;
  EXPECT_TRUE(std::isfinite(energy));
  EXPECT_LE(std::sqrt(2 * energy), std::sqrt(2.0) + kGravity * time);
}

INSTANTIATE_TEST_SUITE_P(
    Hybrid, FullPipes,
    testing::Values(FullPipe{"below_the_densest", "hsmc", 0.38, 0.05, "[4, 8]"},
                    FullPipe{"all_cells_full", "hsmc", 0.88, 0.05, "[4, 8]"},
                    FullPipe{"nearly_close_packed", "hsmc", 0.9, 0.05, "[4, 8]"},
                    FullPipe{"nearly_close_packed_ramp", "hsmc-ramp", 0.9, 0.05, "[4, 8]"},
                    FullPipe{"gravity_crosses_many_cells", "hsmc", 0.38, 10.0, "[10, 20]"},
                    FullPipe{"gravity_crosses_many_full_cells", "hsmc", 0.88, 10.0, "[10, 20]"},
                    FullPipe{"one_cell_wide", "hsmc", 0.7, 0.05, "[1, 8]"},
                    FullPipe{"one_cell_wide_and_full", "hsmc", 0.88, 0.05, "[1, 8]"},
                    FullPipe{"one_cell_long_and_full", "hsmc", 0.88, 0.05, "[4, 1]"},
                    FullPipe{"one_cell", "hsmc", 0.88, 0.05, "[1, 1]"},
                    FullPipe{"odd_around", "hsmc", 0.88, 0.05, "[4, 7]"}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace sandglass::full_pipe_test
