#include "sim/method/mixing/mixing.hpp"

#include "sim/base/error.hpp"
#include "sim/base/saved.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass::mixing {

namespace {
/// A particle that reaches more walls than this in one step has been thrown: the step is beyond stability.
constexpr std::uint32_t kMostWalls = 100;

/// The walls are those of this method; the motion stage of the cells is not used.
motion::MotionParameters<2> walled() {
  motion::MotionParameters<2> motion;
  motion.walled = {true, true};
  return motion;
}

std::vector<ColumnInfo> columns_of(const Parameters& parameters) {
  std::vector<ColumnInfo> columns;
  if (parameters.species.size() > 1) columns.push_back(column::species);
  if (parameters.keep_ids) columns.push_back(column::id);
  return columns;
}
}  // namespace

Grid<2> cells_of(const Parameters& parameters) {
  std::array<std::uint32_t, 2> cells{1, 1};
  const Vector<2>& box = parameters.walls.box;
  constexpr double kMost = 30000;  // along an axis; wider cells hold the same pairs
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double number = std::floor(box[static_cast<int>(axis)] / parameters.repulsion.cutoff);
    while (number > 1 && number * parameters.repulsion.cutoff > box[static_cast<int>(axis)]) --number;
    cells[axis] = static_cast<std::uint32_t>(std::clamp(number, 1.0, kMost));
  }
  return Grid<2>(box, cells);
}

Mixing::Mixing(const Parameters& parameters, const Streams& streams)
    : CellSimulator<2>(cells_of(parameters), parameters.species, 1, walled(), streams,
                       columns_of(parameters)),
      parameters_(parameters),
      pairs_(parameters.repulsion, cells_of(parameters)) {
  if (parameters_.support) support_.emplace(*parameters_.support);
}

void Mixing::step(double dt, std::uint64_t step) {
  accelerate();
  move(step == 0 ? parameters_.faults.first_kick * dt : dt, dt, step);
  store_.find_cells();
  end_step(dt, step);
}

double Mixing::mass(std::size_t particle, std::span<const std::uint8_t> species) const {
  return parameters_.species[species.empty() ? 0 : species[particle]].mass;
}

void Mixing::accelerate() {
  const auto particles = store_.phases();
  const auto species = store_.columns().get(column::species);
  masses_.resize(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i)
    masses_[i] = parameters_.faults.repulsion_sign * mass(i, species);
  accelerations_.assign(particles.size(), Vector<2>(0, parameters_.gravity));
  if (support_) {
    support_->prepare(particles);
    for (std::size_t i = 0; i < particles.size(); ++i) accelerations_[i][1] *= support_->share(i);
  }
  pairs_in_range_ += pairs_.add({particles, store_.offsets(), masses_}, accelerations_);
}

void Mixing::move(double kick, double dt, std::uint64_t step) {
  const auto particles = store_.phases();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    Phase<2>& particle = particles[i];
    const Vector<2> start = particle.position;
    particle.velocity += kick * accelerations_[i];
    particle.position += dt * particle.velocity;
    const std::uint32_t walls = parameters_.walls.turn_back(start, particle, kMostWalls);
    if (walls > kMostWalls || !particle.position.allFinite()) refuse(step, dt, particle);
    reflections_ += walls;
  }
}

void Mixing::refuse(std::uint64_t step, double dt, const Phase<2>& particle) const {
  throw RunError(fmt::format(
      "step {}: the repulsion has thrown a particle across the box more than once in a step (speed {:.3g}): "
      "'method.time-step' = {} is beyond the stability of the core, lower it, lower 'method.core-exponent' "
      "or raise 'method.softening-length'",
      step + 1, particle.velocity.norm(), dt));
}

std::map<std::string, double> Mixing::counters() const {
  return {{"pairs-in-range", static_cast<double>(pairs_in_range_)},
          {"wall-reflections", static_cast<double>(reflections_)}};
}

Memory Mixing::save() const {
  Memory memory = CellSimulator<2>::save();
  memory["mixing/counts"] = {static_cast<double>(pairs_in_range_), static_cast<double>(reflections_)};
  return memory;
}

void Mixing::load(const Memory& memory) {
  CellSimulator<2>::load(memory);
  const std::vector<double>& counts = memory.at("mixing/counts");
  pairs_in_range_ = saved_count(counts.at(0));
  reflections_ = saved_count(counts.at(1));
}

std::size_t Mixing::bytes() const {
  return CellSimulator<2>::bytes() + (support_ ? support_->bytes() : 0) +
         masses_.capacity() * sizeof(double) + accelerations_.capacity() * sizeof(Vector<2>);
}

}  // namespace sandglass::mixing
