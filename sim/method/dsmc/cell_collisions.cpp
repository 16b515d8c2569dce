#include "sim/method/dsmc/cell_collisions.hpp"

#include "sim/physics/collision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sandglass::dsmc {

namespace {

/// Relative velocities count as none below the rounding of a mean of as many numbers, and where their growth would
/// overflow.
constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon(), kOverflow = 1e-200;

template <int D>
std::span<Phase<D>> particles_of(const CellStep<D>& step, std::uint32_t cell) {
  const auto offsets = step.store.offsets();
  return step.store.phases().subspan(offsets[cell], offsets[cell + 1] - offsets[cell]);
}

template <int D>
Vector<D> mean_velocity(std::span<const Phase<D>> particles) {
  Vector<D> sum = Vector<D>::Zero();
  for (const Phase<D>& particle : particles) sum += particle.velocity;
  return sum / static_cast<double>(particles.size());
}

/// Whether the particles have no relative motion that can grow by this sum of squares.
template <int D>
bool cold(std::span<const Phase<D>> particles, double square) {
  const Vector<D> mean = mean_velocity<D>(particles);
  double thermal = 0;
  for (const Phase<D>& particle : particles) thermal += (particle.velocity - mean).squaredNorm();
  const auto count = static_cast<double>(particles.size());
  const double rounding = kRounding * count * mean.norm();
  return thermal <= std::max(count * rounding * rounding, kOverflow * square);
}

template <int D>
void shift(std::span<Phase<D>> particles, const Vector<D>& change) {
  for (Phase<D>& particle : particles) particle.velocity += change;
}

/// v' = mean + k (v - mean), Eq. 2.26, with k such that the sum of |v - mean|^2 grows by `square`. However large k, the
/// mean keeps: what rounding has left of it in the relative velocities is taken out before it is multiplied.
template <int D>
void stretch(std::span<Phase<D>> particles, double square) {
  const Vector<D> mean = mean_velocity<D>(particles);
  shift<D>(particles, -mean);
  shift<D>(particles, -mean_velocity<D>(particles));
  double thermal = 0;
  for (const Phase<D>& particle : particles) thermal += particle.velocity.squaredNorm();
  const double factor = std::sqrt(1 + square / thermal);
  for (Phase<D>& particle : particles) particle.velocity = mean + factor * particle.velocity;
}

}  // namespace

template <int D>
CellCollisions<D>::CellCollisions(const Parameters& parameters, const LatticeOfCells<D>& cells,
                                  const FullCells<D>& full)
    : full_(full),
      mass_(parameters.mass),
      restitution_(parameters.restitution),
      heat_share_(parameters.faults.heat_share),
      swap_(parameters.faults.colours_fixed ? 0 : 1),
      choice_(cells.size()) {}

template <int D>
void CellCollisions<D>::apply(const CellStep<D>& step) {
  if (!full_.any()) return;
  chosen_.clear();
  const std::uint32_t active = static_cast<std::uint32_t>(step.number * swap_ % 2);
  for (std::uint32_t cell = 0; cell < choice_.size(); ++cell)
    if (full_.full(cell) && step.neighbours.parity(cell) == active) choose(step, cell);
  for (const std::uint32_t cell : chosen_) {
    collide(step, choice_[cell].from, cell);
    choice_[cell] = {};
  }
}

/// Neighbours have the other colour. The first of equals is taken, in the order of the cells.
template <int D>
void CellCollisions<D>::choose(const CellStep<D>& step, std::uint32_t cell) {
  const auto offsets = step.store.offsets();
  const Vector<D>& velocity = step.fields.velocity[cell];
  Choice best{0, cell};
  std::uint32_t to = cell;
  step.neighbours.for_each_neighbour(cell, [&](std::uint32_t neighbour, const Vector<D>& direction) {
    if (offsets[neighbour] == offsets[neighbour + 1]) return;
    const double approach = (velocity - step.fields.velocity[neighbour]).dot(direction);
    if (approach > best.approach) best.approach = approach, to = neighbour;
  });
  if (to == cell) return;
  Choice& current = choice_[to];
  if (current.approach == 0) chosen_.push_back(to);
  if (best.approach > current.approach) current = best;
}

template <int D>
void CellCollisions<D>::collide(const CellStep<D>& step, std::uint32_t first, std::uint32_t second) {
  const auto one = particles_of(step, first), two = particles_of(step, second);
  const double mass_1 = mass_ * static_cast<double>(one.size()),
               mass_2 = mass_ * static_cast<double>(two.size());
  const Vector<D> relative = step.fields.velocity[first] - step.fields.velocity[second];
  Random random(step.key, (std::uint64_t{1} << 32) + first);  // cells alone draw from indices below 2^32
  const Vector<D> normal = contact_normal(relative, 1 / relative.norm(), uniform_impact<D>(random));
  const double speed = relative.dot(normal), reduced = mass_1 * mass_2 / (mass_1 + mass_2);
  const Vector<D> impulse = -(1 + restitution_) * reduced * speed * normal;
  shift<D>(one, impulse / mass_1);
  shift<D>(two, -impulse / mass_2);
  ++count_.collisions;
  const double lost = 0.5 * reduced * (1 - restitution_ * restitution_) * speed * speed;
  // Seen from the centre of mass each cell loses in proportion to the mass of the other.
  if (lost > 0) give_back(one, two, mass_2 / (mass_1 + mass_2), heat_share_ * lost);
}

/// `share` of the energy goes to the first cell; all of it to one of the two where the other has no relative motion.
template <int D>
void CellCollisions<D>::give_back(std::span<Phase<D>> first, std::span<Phase<D>> second, double share,
                                  double energy) {
  const double square = 2 * energy / mass_;
  const bool cold_1 = cold<D>(first, square), cold_2 = cold<D>(second, square);
  if (cold_1 && cold_2) {
    count_.heat_lost += energy;
    return;
  }
  if (cold_1) share = 0;
  if (cold_2) share = 1;
  count_.heat += energy;
  if (share > 0) stretch<D>(first, share * square);
  if (share < 1) stretch<D>(second, (1 - share) * square);
}

template class CellCollisions<2>;
template class CellCollisions<3>;

}  // namespace sandglass::dsmc
