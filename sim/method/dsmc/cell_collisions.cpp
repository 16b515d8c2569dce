#include "sim/method/dsmc/cell_collisions.hpp"

#include "sim/physics/collision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sandglass::dsmc {

namespace {

/// Of the heat. Seen from the centre of mass each cell loses in proportion to the mass of the other; a cell without relative
/// motion gives its share to its partner.
double share_of_first(double share, double thermal_1, double thermal_2) {
  if (thermal_1 == 0) return 0;
  return thermal_2 == 0 ? 1 : share;
}

/// Above it the rounding of a mean shows in the momentum.
constexpr double kLargeFactor = 4;
/// Relative velocities count as none below the rounding of a mean of as many numbers, and where their growth would
/// overflow.
constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon(), kOverflow = 1e-200;

template <int D>
std::span<Phase<D>> particles_of(const CellStep<D>& step, std::uint32_t cell) {
  const auto offsets = step.store.offsets();
  return step.store.phases().subspan(offsets[cell], offsets[cell + 1] - offsets[cell]);
}

/// Pairs that are known beforehand: the particles of one this far ahead are on their way while others collide.
constexpr std::size_t kPairsAhead = 4;

template <int D>
void fetch(std::span<Phase<D>> particles) {
  constexpr std::size_t together = 8;  // a loop whose end can be guessed
  const auto* bytes = reinterpret_cast<const std::byte*>(particles.data());
  for (std::size_t i = 0; i < particles.size(); i += together)
    for (std::size_t line = 0; line < together * sizeof(Phase<D>); line += 64)
      __builtin_prefetch(bytes + i * sizeof(Phase<D>) + line, 1);
}

template <int D>
Vector<D> mean_velocity(std::span<const Phase<D>> particles) {
  Vector<D> sum = Vector<D>::Zero();
  for (const Phase<D>& particle : particles) sum += particle.velocity;
  return sum / static_cast<double>(particles.size());
}

/// Sum of |v - mean|^2 over the particles; 0 where it is nothing but rounding, or could not grow by `square`.
template <int D>
double thermal_square(std::span<const Phase<D>> particles, const Vector<D>& mean, double square) {
  double thermal = 0;
  for (const Phase<D>& particle : particles) thermal += (particle.velocity - mean).squaredNorm();
  const auto count = static_cast<double>(particles.size());
  const double rounding = kRounding * count * mean.norm();
  return thermal > std::max(count * rounding * rounding, kOverflow * square) ? thermal : 0;
}

template <int D>
void shift(std::span<Phase<D>> particles, const Vector<D>& change) {
  for (Phase<D>& particle : particles) particle.velocity += change;
}

/// v' = mean + k (v - mean), Eq. 2.26, with k such that the sum of |v - mean|^2 grows by `square`. However large k, the
/// mean keeps: what rounding has left of it in the relative velocities is taken out before it is multiplied.
template <int D>
void stretch_cold(std::span<Phase<D>> particles, double square) {
  const Vector<D> mean = mean_velocity<D>(particles);
  shift<D>(particles, -mean);
  shift<D>(particles, -mean_velocity<D>(particles));
  double thermal = 0;
  for (const Phase<D>& particle : particles) thermal += particle.velocity.squaredNorm();
  const double factor = std::sqrt(1 + square / thermal);
  for (Phase<D>& particle : particles) particle.velocity = mean + factor * particle.velocity;
}

/// Moves the mean on by `change` and lets the sum of |v - mean|^2 grow by `square`, from `thermal`.
template <int D>
void move_on(std::span<Phase<D>> particles, const Vector<D>& mean, const Vector<D>& change, double thermal,
             double square) {
  const double factor = square > 0 ? std::sqrt(1 + square / thermal) : 1;
  if (factor > kLargeFactor) {
    shift<D>(particles, change);
    return stretch_cold<D>(particles, square);
  }
  const Vector<D> moved = mean + change;
  for (Phase<D>& particle : particles) particle.velocity = moved + factor * (particle.velocity - mean);
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

/// Mean velocities are those of the cells that may collide in this step.
template <int D>
CellNeeds CellCollisions<D>::needs(const CellStep<D>& step) {
  find_active(step);
  if (active_.empty()) return {};
  if (!step.store.velocity_sums().empty()) return {.velocity = true};
  near_.assign(choice_.size(), 0);
  for (const std::uint32_t cell : active_) {
    near_[cell] = 1;
    step.neighbours.for_each_neighbour(cell,
                                       [this](std::uint32_t neighbour, int, bool) { near_[neighbour] = 1; });
  }
  return {.velocity = true, .where = near_};
}

template <int D>
void CellCollisions<D>::find_active(const CellStep<D>& step) {
  active_.resize(full_.any() ? choice_.size() + 1 : 0);
  std::size_t count = 0;
  if (full_.any())
    step.neighbours.for_each_of_colour(0, turn(step), [&](std::uint32_t cell) {
      active_[count] = cell;  // whether it counts nobody can guess: no branch
      count += full_.full(cell);
    });
  active_.resize(count);
}

template <int D>
void CellCollisions<D>::apply(const CellStep<D>& step) {
  choose(step);
  for (std::size_t i = 0; i < chosen_.size(); ++i) {
    if (i + kPairsAhead < chosen_.size()) {
      const std::uint32_t coming = chosen_[i + kPairsAhead];
      fetch(particles_of(step, coming));
      fetch(particles_of(step, choice_[coming].cell));
    }
    collide(step, choice_[chosen_[i]].cell, chosen_[i]);
    choice_[chosen_[i]] = {};
  }
}

/// Whether a choice counts, or is better than one before, nobody can guess: no branch.
template <int D>
void CellCollisions<D>::choose(const CellStep<D>& step) {
  chosen_.resize(active_.size() + 1);
  std::size_t count = 0;
  for (const std::uint32_t cell : active_) {
    const auto [approach, to] = fastest(step, cell);
    Choice& current = choice_[to];
    chosen_[count] = to;
    const bool first = bool(approach > 0) & bool(current.approach == 0);
    count += first;
    current = approach > current.approach ? Choice{approach, cell} : current;
  }
  chosen_.resize(count);
}

/// The neighbour of the other colour that is approached fastest, of equals the first in the order of the cells; the cell
/// itself, at 0, where it approaches none.
template <int D>
typename CellCollisions<D>::Choice CellCollisions<D>::fastest(const CellStep<D>& step,
                                                              std::uint32_t cell) const {
  const auto offsets = step.store.offsets();
  const Vector<D> velocity = step.fields.velocity[cell];
  const bool ask = !step.neighbours.alternate();
  Choice best{0, cell};
  step.neighbours.for_each_neighbour(cell, [&](std::uint32_t neighbour, int axis, bool up) {
    if (ask && step.neighbours.colour(neighbour, turn(step)) == 0) return;
    const double approach = step.neighbours.towards(velocity - step.fields.velocity[neighbour], axis, up);
    const bool nearer = bool(approach > best.approach) & bool(offsets[neighbour] != offsets[neighbour + 1]);
    best.approach = nearer ? approach : best.approach;
    best.cell = nearer ? neighbour : best.cell;
  });
  return best;
}

template <int D>
void CellCollisions<D>::collide(const CellStep<D>& step, std::uint32_t first, std::uint32_t second) {
  const auto one = particles_of(step, first), two = particles_of(step, second);
  const double mass_1 = mass_ * static_cast<double>(one.size()),
               mass_2 = mass_ * static_cast<double>(two.size());
  const Vector<D>&mean_1 = step.fields.velocity[first], &mean_2 = step.fields.velocity[second];
  const Vector<D> relative = mean_1 - mean_2;
  Random random(step.key, (std::uint64_t{1} << 32) + first);  // cells alone draw from indices below 2^32
  const Vector<D> normal = contact_normal(relative, 1 / relative.norm(), uniform_impact<D>(random));
  const double speed = relative.dot(normal), reduced = mass_1 * mass_2 / (mass_1 + mass_2);
  const Vector<D> impulse = -(1 + restitution_) * reduced * speed * normal;
  const double heat = 0.5 * heat_share_ * reduced * (1 - restitution_ * restitution_) * speed * speed;
  const double square = 2 * heat / mass_;
  const double thermal_1 = heat > 0 ? thermal_square<D>(one, mean_1, square) : 0,
               thermal_2 = heat > 0 ? thermal_square<D>(two, mean_2, square) : 0;
  const double share = heat > 0 ? share_of_first(mass_2 / (mass_1 + mass_2), thermal_1, thermal_2) : 0;
  const bool lost = thermal_1 == 0 && thermal_2 == 0;
  move_on<D>(one, mean_1, impulse / mass_1, thermal_1, lost ? 0 : share * square);
  move_on<D>(two, mean_2, -impulse / mass_2, thermal_2, lost ? 0 : (1 - share) * square);
  ++count_.collisions;
  (lost ? count_.heat_lost : count_.heat) += heat;
}

template class CellCollisions<2>;
template class CellCollisions<3>;

}  // namespace sandglass::dsmc
