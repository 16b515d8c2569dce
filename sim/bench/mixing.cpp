#include "sim/method/mixing/mixing.hpp"

#include "sim/bench/scattered.hpp"

#include <cmath>

#include <benchmark/benchmark.h>

// Particle-moves per second of two mixing fluids: the density, repulsion and walls of example 2 in Greenspan 1972, in a box
// that grows with the number of particles, and so do the strips that carry a particle: the support costs as the root of
// that number.

namespace sandglass::mixing {
namespace {

constexpr double kDensity = 256.0 / 1e4, kBlock = 6.25;

Parameters parameters_in(double edge, bool supported) {
  Parameters parameters;
  parameters.repulsion = {1, 0.1, 2, 2, 5, 10};
  parameters.walls = {{edge, edge}, 0.9, 1e-3};
  parameters.gravity = -980;
  const auto blocks = static_cast<std::uint32_t>(edge / kBlock);
  if (supported) parameters.support = SupportParameters{{edge, edge}, blocks, blocks, 5, 1e-3};
  parameters.species = {{5, 1, 0}, {5, 0.25, 0}};
  return parameters;
}

/// `filled`: the part of the height that they are spread over at the start.
void moves(benchmark::State& state, bool supported, double filled) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const double edge = std::sqrt(static_cast<double>(count) / kDensity);
  Mixing fluids(parameters_in(edge, supported), Streams{});
  Particles<2> particles{scattered<2>(count, edge), {}};
  for (Phase<2>& particle : particles.phases) particle.position[1] *= filled;
  std::vector<std::uint8_t> species(count, 1);
  std::fill(species.begin(), species.begin() + static_cast<std::ptrdiff_t>(count / 4), std::uint8_t{0});
  particles.columns.set(column::species, species);
  fluids.assign(particles);
  std::uint64_t step = 0;
  for (auto _ : state) fluids.step(1e-3, step++);
  state.SetItemsProcessed(static_cast<std::int64_t>(count) * static_cast<std::int64_t>(step));
  state.counters["bytes"] = static_cast<double>(fluids.bytes()) / static_cast<double>(count);
}

BENCHMARK_CAPTURE(moves, with_support, true, 1.0)
    ->Arg(256)
    ->Arg(10000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(moves, heap_with_support, true, 0.3)
    ->Arg(256)
    ->Arg(10000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(moves, repulsion_alone, false, 1.0)
    ->Arg(256)
    ->Arg(10000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sandglass::mixing
