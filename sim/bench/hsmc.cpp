#include "sim/bench/scattered.hpp"
#include "sim/method/dsmc/dsmc.hpp"
#include "sim/method/dsmc/local_factor.hpp"
#include "sim/physics/collision.hpp"

#include <cmath>
#include <string>

#include <benchmark/benchmark.h>

// Particle-moves per second of hybrid simulation Monte Carlo beside the consistent Boltzmann algorithm, whose kernel it
// shares: a uniform gas of 10 particles per cell, slightly inelastic, each colliding a tenth of a time per step.

namespace sandglass::dsmc {
namespace {

constexpr double kPerCell = 10, kCollisionsPerStep = 0.1;

template <int D>
Parameters parameters_at(double fraction, bool hybrid) {
  Parameters parameters;
  parameters.diameter = std::pow(fraction / kPerCell / particle_volume(D, 1), 1.0 / D);
  parameters.restitution = 0.99;
  parameters.cross_section = cross_section(D, parameters.diameter);
  parameters.factor.formula = contact_formula(D);
  parameters.offset.consistent = parameters.diameter;
  if (hybrid) parameters.excluded_volume.densest = D == 2 ? 0.82 : 0.64;
  return parameters;
}

enum class Cells { fixed, shifted, diagonal };

template <int D>
LatticeOfCells<D> lattice(const Grid<D>& grid, Cells cells) {
  std::array<bool, D> periodic;
  periodic.fill(true);
  if (cells == Cells::shifted) return LatticeOfCells<D>::shifted(grid, periodic);
  if constexpr (D == 2)
    if (cells == Cells::diagonal) {
      const auto corners = static_cast<std::uint32_t>(std::lround(grid.cells(0) / M_SQRT2));
      return LatticeOfCells<D>::diagonal(Grid<D>(grid.box(), {corners, corners}), periodic);
    }
  return grid;
}

template <int D>
void moves(benchmark::State& state, double fraction, bool hybrid, Cells kind = Cells::fixed) {
  const auto edge = static_cast<std::uint32_t>(2 * std::lround(0.5 * std::pow(1e5 / kPerCell, 1.0 / D)));
  std::array<std::uint32_t, D> cells;
  cells.fill(edge);
  const Parameters parameters = parameters_at<D>(fraction, hybrid);
  const auto count = static_cast<std::size_t>(kPerCell * std::pow(edge, D));
  const double mean_speed = D == 2 ? std::sqrt(M_PI / 2) : std::sqrt(8 / M_PI);
  const double rate =
      M_SQRT2 * kPerCell * parameters.cross_section * parameters.factor.formula(fraction).value * mean_speed;
  motion::MotionParameters<D> motion;
  motion.offsets = true;
  Dsmc<D> dsmc(lattice(Grid<D>(Vector<D>::Constant(edge), cells), kind), parameters, motion, Streams{});
  dsmc.assign({scattered<D>(count, edge), {}});
  std::uint64_t step = 0;
  while (step < 100) dsmc.step(kCollisionsPerStep / rate, step++);
  dsmc.tally() = Tally{};
  for (auto _ : state) dsmc.step(kCollisionsPerStep / rate, step++);
  const auto steps = static_cast<double>(state.iterations());
  state.counters["moves_per_second"] =
      benchmark::Counter(steps * static_cast<double>(count), benchmark::Counter::kIsRate);
  state.counters["collisions_per_second"] =
      benchmark::Counter(static_cast<double>(dsmc.tally().collisions), benchmark::Counter::kIsRate);
  state.counters["bytes_per_particle"] = static_cast<double>(dsmc.bytes()) / static_cast<double>(count);
}

template <int D>
void add(const std::string& name, double fraction) {
  for (const bool hybrid : {false, true})
    benchmark::RegisterBenchmark((name + (hybrid ? "full_cells" : "points")).c_str(),
                                 [=](benchmark::State& state) { moves<D>(state, fraction, hybrid); })
        ->Unit(benchmark::kMillisecond);
}

/// Full cells that are displaced every step, or stand on a corner.
template <int D>
void add_lattice(const std::string& name, double fraction, Cells cells) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    moves<D>(state, fraction, true, cells);
  })->Unit(benchmark::kMillisecond);
}

const bool registered = [] {
  add<2>("2d_dilute_", 0.05);
  add<2>("2d_dense_", 0.4);
  add<2>("2d_crowded_", 0.7);
  add<3>("3d_dilute_", 0.05);
  add<3>("3d_dense_", 0.3);
  add<3>("3d_crowded_", 0.55);
  add_lattice<2>("2d_dilute_shifted", 0.05, Cells::shifted);
  add_lattice<2>("2d_crowded_shifted", 0.7, Cells::shifted);
  add_lattice<2>("2d_dilute_diagonal", 0.05, Cells::diagonal);
  add_lattice<2>("2d_crowded_diagonal", 0.7, Cells::diagonal);
  return true;
}();

}  // namespace
}  // namespace sandglass::dsmc
