#include "sim/method/dsmc/dsmc.hpp"

#include "sim/bench/scattered.hpp"

#include <cmath>
#include <string>

#include <benchmark/benchmark.h>

// Particle-moves per second of the DSMC kernel: 10 particles per cell of two thirds of a mean free path, 0.06 collisions
// per particle-move, elastic, periodic; then the same with one feature at a time.

namespace sandglass::dsmc {
namespace {

constexpr double kPerCell = 10;
constexpr double kCollisionsPerMove = 0.06;

struct Feature {
  bool factor = false, expected = false, gravity = false, walls = false, ids = false, transfer = false;
  bool plane = false, thermal = false, obstacles = false, time_counter = false;
  std::size_t species = 1;
  Offset offset{};
};

/// Number density and time step that make cells two thirds of a mean free path at the wanted collision rate.
template <int D>
void moves(benchmark::State& state, Feature feature) {
  const auto wanted = static_cast<double>(state.range(0));
  const auto edge_cells = static_cast<std::uint32_t>(std::lround(std::pow(wanted / kPerCell, 1.0 / D)));
  std::array<std::uint32_t, D> cells;
  cells.fill(edge_cells);
  const auto count = static_cast<std::size_t>(kPerCell * std::pow(edge_cells, D));
  const Grid<D> grid(Vector<D>::Constant(edge_cells), cells);
  // n sigma lambda sqrt(2) = 1 with lambda = 1.5 cells.
  Parameters parameters;
  parameters.cross_section = 1 / (std::sqrt(2.0) * 1.5 * kPerCell);
  parameters.diameter = D == 2 ? parameters.cross_section / 2 : std::sqrt(parameters.cross_section / M_PI);
  const double mean_speed = D == 2 ? std::sqrt(M_PI / 2) : std::sqrt(8 / M_PI);
  const double rate = std::sqrt(2.0) * kPerCell * parameters.cross_section * mean_speed;
  const double dt = 2 * kCollisionsPerMove / rate;

  motion::MotionParameters<D> motion;
  std::vector<Plane> planes;
  if (feature.plane)
    planes.emplace_back(0, 0.5 * edge_cells, std::vector<double>{-5, 0, 5}), motion.planes = &planes;
  if (feature.gravity) motion.gravity[D - 1] = -1e-4;
  if (feature.walls) motion.walled[D - 1] = true;
  if (feature.thermal) motion.walls = {{D - 1, false, 0, Vector<D>::Zero(), 0, 0, {WallKind::thermal}}};
  // One obstacle for ten cells.
  if (feature.obstacles)
    for (const Phase<D>& place : scattered<D>(count / 100, edge_cells - 1.0))
      motion.obstacles.push_back({place.position + Vector<D>::Constant(0.5), 0.2, {}});
  if (feature.factor) parameters.factor.formula = contact_formula(D);
  if (feature.expected) parameters.pair_count = PairCount::expected;
  if (feature.time_counter) parameters.pair_count = PairCount::time_counter;
  if (feature.species > 1) {
    parameters.kinds.species.assign(feature.species, {parameters.diameter, 1});
    parameters.kinds.surfaces.resize(feature.species * feature.species);
    parameters.factor.dimension = D;
  }
  parameters.offset = {feature.offset.consistent * parameters.diameter,
                       feature.offset.random * parameters.diameter};
  motion.offsets = parameters.offset.any();
  parameters.measure_transfer = feature.transfer;
  std::vector<ColumnInfo> columns;
  if (feature.ids) columns.push_back(column::id);
  if (feature.species > 1) columns.push_back(column::species);
  Dsmc<D> dsmc(grid, parameters, motion, Streams{}, Purpose::collisions, columns);
  Particles<D> particles{scattered<D>(count, edge_cells), {}};
  for (std::size_t i = 0; feature.species > 1 && i < count; ++i)
    particles.columns.append(column::species, static_cast<std::uint8_t>(i % feature.species));
  dsmc.assign(particles);
  std::uint64_t step = 0;
  for (; step < 3; ++step) dsmc.step(dt, step);
  dsmc.tally() = Tally{};
  for (auto _ : state) dsmc.step(dt, step++);
  const auto steps = static_cast<double>(state.iterations());
  state.counters["moves_per_second"] =
      benchmark::Counter(steps * static_cast<double>(count), benchmark::Counter::kIsRate);
  state.counters["collisions_per_second"] =
      benchmark::Counter(static_cast<double>(dsmc.tally().collisions), benchmark::Counter::kIsRate);
  state.counters["collisions_per_move"] =
      static_cast<double>(dsmc.tally().collisions) / static_cast<double>(dsmc.tally().moves);
  state.counters["bytes_per_particle"] = static_cast<double>(dsmc.bytes()) / static_cast<double>(count);
}

template <int D>
void register_features(const std::string& prefix) {
  const auto add = [&](const char* name, Feature feature, std::initializer_list<std::int64_t> sizes) {
    auto* bench = benchmark::RegisterBenchmark(
        (prefix + name).c_str(), [feature](benchmark::State& state) { moves<D>(state, feature); });
    for (std::int64_t size : sizes) bench->Arg(size);
    bench->Unit(benchmark::kMillisecond);
  };
  add("plain", {}, {100'000, 1'000'000, 10'000'000});
  const std::initializer_list<std::int64_t> one = {100'000};
  add("time_counter", {.time_counter = true}, one);
  add("two_species", {.species = 2}, one);
  add("two_species_time_counter", {.time_counter = true, .species = 2}, one);
  add("two_species_contact_factor", {.factor = true, .species = 2}, one);
  add("contact_factor", {.factor = true}, one);
  add("offset", {.offset = {1, 0}}, one);
  add("offset_measured", {.transfer = true, .offset = {1, 0}}, one);
  add("offset_expected_pairs", {.expected = true, .offset = {1, 0}}, one);
  add("offset_random", {.offset = {1, 0.5}}, one);
  add("gravity_between_walls", {.gravity = true, .walls = true}, one);
  add("walls", {.walls = true}, one);
  add("thermal_walls", {.walls = true, .thermal = true}, one);
  add("obstacles", {.obstacles = true}, one);
  add("ids", {.ids = true}, one);
  add("plane", {.plane = true}, one);
}

const bool registered = [] {
  register_features<3>("3d_");
  register_features<2>("2d_");
  return true;
}();

}  // namespace
}  // namespace sandglass::dsmc
