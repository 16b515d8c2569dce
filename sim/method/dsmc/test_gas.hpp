#pragma once

#include "sim/base/statistics.hpp"
#include "sim/method/dsmc/dsmc.hpp"
#include "sim/physics/collision.hpp"

#include <cmath>
#include <vector>

namespace sandglass::dsmc {

/// Edge of the cells of the test gas, in diameters, which are one long.
constexpr double kCellEdge = 1.923;

template <int D>
Grid<D> cubic_grid(std::uint32_t cells, double cell_edge) {
  std::array<std::uint32_t, D> all;
  all.fill(cells);
  return {Vector<D>::Constant(cells * cell_edge), all};
}

/// Elastic particles of diameter and mass one with the contact factor and an offset of one diameter.
template <int D>
Parameters gas_with_offset(double fraction, double per_cell) {
  Parameters parameters;
  parameters.cross_section = cross_section(D, 1);
  parameters.weight = fraction / particle_volume(D, 1) * std::pow(kCellEdge, D) / per_cell;
  parameters.factor.formula = contact_formula(D);
  parameters.offset.consistent = 1;
  parameters.measure_transfer = true;
  return parameters;
}

/// Velocities of temperature one and zero momentum.
template <int D>
std::vector<Phase<D>> maxwellian(std::size_t count, double box) {
  Random random(StreamKey(4, Purpose::positions, 0, 0), 0);
  std::vector<Phase<D>> particles(count);
  Vector<D> momentum = Vector<D>::Zero();
  for (Phase<D>& particle : particles) {
    for (int axis = 0; axis < D; ++axis) {
      particle.position[axis] = box * random.uniform();
      particle.velocity[axis] =
          std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * M_PI * random.uniform());
    }
    momentum += particle.velocity;
  }
  double square = 0;
  for (Phase<D>& particle : particles) {
    particle.velocity -= momentum / static_cast<double>(count);
    square += particle.velocity.squaredNorm();
  }
  for (Phase<D>& particle : particles)
    particle.velocity *= std::sqrt(D * static_cast<double>(count) / square);
  return particles;
}

struct Deviations {
  Mean rate;                       ///< over the Enskog rate, less one
  double pressure;                 ///< collisional part over that of hard cores, less one
  double momentum;                 ///< per particle
  double energy, sonine;           ///< relative change, second Sonine coefficient
  double pairs_early, pairs_late;  ///< pairs in a cell over chance, less one, in each half of the run
};

template <int D>
double pairs_over_chance(std::span<const std::uint32_t> offsets, double per_cell) {
  double pairs = 0;
  for (std::size_t cell = 0; cell + 1 < offsets.size(); ++cell) {
    const double count = offsets[cell + 1] - offsets[cell];
    pairs += count * (count - 1);
  }
  return pairs / (per_cell * per_cell * static_cast<double>(offsets.size() - 1)) - 1;
}

/// About 15 000 particles over 45 collisions each, the first five left out.
template <int D>
Deviations deviations(const Parameters& parameters, double fraction, double per_cell) {
  constexpr double kCollisions = 0.1;  // of a particle in a step
  constexpr std::uint64_t kWarm = 50, kSteps = 400;
  const auto edge = static_cast<std::uint32_t>(std::lround(std::pow(15'000 / per_cell, 1.0 / D)));
  const Grid<D> grid = cubic_grid<D>(edge, kCellEdge);
  const auto count = static_cast<std::size_t>(per_cell * grid.size());
  motion::MotionParameters<D> motion;
  motion.offsets = true;
  Dsmc<D> dsmc(grid, parameters, motion, {});
  dsmc.assign({maxwellian<D>(count, edge * kCellEdge), {}});
  const double density = fraction / particle_volume(D, 1), contact = contact_formula(D)(fraction).value;
  const double rate = (D == 2 ? 2 : 4) * std::sqrt(M_PI) * density * contact, dt = kCollisions / rate;
  std::uint64_t step = 0;
  while (step < kWarm) dsmc.step(dt, step++);
  dsmc.tally() = Tally{};
  const auto particles = static_cast<double>(count);
  std::vector<double> rates;
  std::array<double, 2> pairs{};
  for (std::uint64_t i = 0; i < kSteps; ++i) {
    const std::uint64_t before = dsmc.tally().collisions;
    pairs[i * 2 / kSteps] += pairs_over_chance<D>(dsmc.view().offsets, per_cell) * 2 / kSteps;
    dsmc.step(dt, step++);
    rates.push_back(2 * static_cast<double>(dsmc.tally().collisions - before) / particles / kCollisions - 1);
  }
  Vector<D> momentum = Vector<D>::Zero();
  double square = 0, fourth = 0;
  for (const Phase<D>& particle : dsmc.view().particles) {
    momentum += particle.velocity;
    square += particle.velocity.squaredNorm() / (D * particles);
    fourth += std::pow(particle.velocity.squaredNorm(), 2) / (D * (D + 2) * particles);
  }
  const double collisional = dsmc.tally().transfer.value() / (D * particles * dt * kSteps);
  return {mean_of_correlated(rates),
          collisional / (std::exp2(D - 1) * fraction * contact) - 1,
          momentum.norm() / particles,
          square - 1,
          fourth - 1,
          pairs[0],
          pairs[1]};
}

}  // namespace sandglass::dsmc
