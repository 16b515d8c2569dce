#include "sim/method/dsmc/contact_partners.hpp"

#include "sim/base/error.hpp"
#include "sim/base/stop_request.hpp"
#include "sim/physics/collision.hpp"
#include "sim/space/cell_colours.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass::dsmc {

namespace {
/// Directions over cross-section, of the unit of CollisionStep::coefficient: 2 pi d / (2 d), 4 pi d^2 / (pi d^2).
constexpr double directions_per_cross_section(int dimension) { return dimension == 2 ? M_PI : 4; }

std::uint32_t whole_below(std::uint32_t count, std::uint64_t bits) {
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(static_cast<std::uint32_t>(bits)) * count) >>
                                    32);
}

std::uint64_t whole(double expected, Random& random) {
  return static_cast<std::uint64_t>(expected + random.uniform());
}
}  // namespace

template <int D>
ContactPartners<D>::ContactPartners(const Parameters& parameters, const Grid<D>& grid,
                                    const std::array<bool, D>& periodic)
    : grid_(grid),
      periodic_(periodic),
      neighbours_(grid, periodic),
      reach_(parameters.faults.reach * parameters.diameter),
      contact_place_(parameters.faults.contact_place),
      restitution_(parameters.restitution),
      mass_(parameters.mass),
      measure_transfer_(parameters.measure_transfer),
      colours_(cell_colours<D>(grid, periodic)),
      boxes_(grid.size()) {
  if (parameters.kinds.mixed()) {
    table_.emplace(parameters);
    for (const SpeciesTraits& one : parameters.kinds.species)
      for (const SpeciesTraits& two : parameters.kinds.species)
        reaches_.push_back(parameters.faults.reach * (one.diameter + two.diameter) / 2);
  }
  const double widest =
      table_ ? std::ranges::max(parameters.kinds.species, {}, &SpeciesTraits::diameter).diameter
             : parameters.diameter;
  for (int axis = 0; axis < D; ++axis)
    if (grid.box()[axis] < widest * grid.cells(axis))
      throw InputError(fmt::format(
          "cells of {} along axis {} are narrower than a diameter ({}), where partners are looked for",
          grid.box()[axis] / grid.cells(axis), axis, widest));
}

template <int D>
std::size_t ContactPartners<D>::bytes() const {
  std::size_t cells = 0;
  for (const auto& colour : colours_) cells += colour.capacity();
  return cells * sizeof(std::uint32_t) + boxes_.capacity() * sizeof(VelocityBox<D>) + by_species_.bytes();
}

template <int D>
void ContactPartners<D>::collide(const CollisionStep<D>& step) {
  begin(step);
  for (const auto& cells : colours_) collide(step, cells);
}

template <int D>
void ContactPartners<D>::begin(const CollisionStep<D>& step) {
  for (std::uint32_t cell = 0; cell < boxes_.size(); ++cell)
    if (const std::uint32_t first = step.offsets[cell], count = step.offsets[cell + 1] - first; count > 0)
      boxes_[cell] = VelocityBox<D>(step.particles + first, count);
  if (table_) by_species_.update({step.offsets, boxes_.size() + 1}, step.species, table_->species());
}

template <int D>
void ContactPartners<D>::collide(const CollisionStep<D>& step, std::span<const std::uint32_t> cells) {
  for (const std::uint32_t cell : cells) {
    stop_request.heed();
    if (step.offsets[cell] == step.offsets[cell + 1]) continue;
    Random random(step.key, cell);
    if (!table_) {
      collide_cell<false>(step, cell, 0, random);
      continue;
    }
    for (std::size_t kind = 0; kind < table_->species(); ++kind)
      collide_cell<true>(step, cell, static_cast<std::uint8_t>(kind), random);
  }
}

template <int D>
template <bool Mixed>
typename ContactPartners<D>::Surroundings ContactPartners<D>::survey(const CollisionStep<D>& step,
                                                                     std::uint32_t cell,
                                                                     std::uint8_t kind) const {
  Surroundings around{boxes_[cell]};
  std::uint32_t most = 0;
  double factor = step.factor == nullptr ? 1 : 0;
  neighbours_.for_each_around(cell, [&](std::uint32_t other) {
    const std::uint32_t count = step.offsets[other + 1] - step.offsets[other];
    if (count > 0) around.box.include(boxes_[other]);
    most = std::max(most, Mixed ? by_species_.count(other, kind) : count);
    if (step.factor != nullptr) factor = std::max(factor, step.factor[other]);
  });
  around.pairs = most * factor;
  if constexpr (Mixed) around.pairs *= table_->largest(kind);
  return around;
}

/// Majorant collisions, as of the kernel within cells: a candidate is a particle of this cell with a direction.
template <int D>
template <bool Mixed>
void ContactPartners<D>::collide_cell(const CollisionStep<D>& step, std::uint32_t cell, std::uint8_t kind,
                                      Random& random) {
  Surroundings around = survey<Mixed>(step, cell, kind);
  double square_diagonal = around.box.square_diagonal();
  double bound = around.pairs * std::sqrt(square_diagonal);
  const std::uint32_t count = step.offsets[cell + 1] - step.offsets[cell];
  const double expected = directions_per_cross_section(D) * step.coefficient * count * bound;
  require_few(expected, count);
  std::uint64_t left = whole(expected, random);
  double transfer = 0;
  for (; left > 0; --left) {
    ++step.tally->candidates;
    Candidate candidate;
    if (!draw<Mixed>(step, cell, kind, random, candidate)) continue;
    if (random.uniform() * bound >= candidate.others * weight_of<Mixed>(step, candidate) * candidate.approach)
      continue;
    transfer += collide_pair<Mixed>(step, candidate, around.box);
    ++step.tally->collisions;
    const double ratio = std::sqrt(around.box.square_diagonal() / square_diagonal);
    if (left == 1 || ratio <= 1) continue;
    // The rest of the step goes on with the higher bound and proportionally more candidates.
    left = 1 + whole((static_cast<double>(left) - 1) * ratio, random);
    square_diagonal = around.box.square_diagonal();
    bound *= ratio;
    ++*step.bound_raised;
  }
  if (measure_transfer_) step.tally->transfer.add(transfer);
}

/// False where there is no partner, or none that comes closer. A point beyond a wall has none.
template <int D>
template <bool Mixed>
bool ContactPartners<D>::draw(const CollisionStep<D>& step, std::uint32_t cell, std::uint8_t kind,
                              Random& random, Candidate& candidate) const {
  const std::uint64_t bits = random.bits();
  const std::uint32_t begin = step.offsets[cell];
  candidate.cell = cell;
  candidate.one = begin + whole_below(step.offsets[cell + 1] - begin, bits);
  candidate.direction = uniform_direction<D>(random);
  candidate.reach = reach_;
  if constexpr (Mixed) {
    candidate.kinds = table_->index(step.species[candidate.one], kind);
    candidate.reach = reaches_[candidate.kinds];
  }
  Vector<D> point = step.particles[candidate.one].position + candidate.reach * candidate.direction;
  if (!wrap(point)) return false;
  candidate.partner_cell = grid_.cell_of(point);
  const auto more = static_cast<std::uint32_t>(bits >> 32);
  if (!(Mixed ? draw_partner_of(kind, more, candidate) : draw_partner(step, more, candidate))) return false;
  candidate.approach = (step.particles[candidate.one].velocity - step.particles[candidate.two].velocity)
                           .dot(candidate.direction);
  return candidate.approach > 0;
}

/// Any but the particle itself.
template <int D>
bool ContactPartners<D>::draw_partner(const CollisionStep<D>& step, std::uint32_t bits,
                                      Candidate& candidate) const {
  const std::uint32_t first = step.offsets[candidate.partner_cell];
  const bool own = candidate.partner_cell == candidate.cell;
  const std::uint32_t others = step.offsets[candidate.partner_cell + 1] - first - own;
  if (others == 0) return false;
  candidate.two = first + whole_below(others, bits);
  candidate.two += own && candidate.two >= candidate.one;
  candidate.others = others;
  return true;
}

/// Where it draws itself there is no partner, so that it may count among the others.
template <int D>
bool ContactPartners<D>::draw_partner_of(std::uint8_t kind, std::uint32_t bits, Candidate& candidate) const {
  const std::span<const std::uint32_t> others = by_species_.places(candidate.partner_cell, kind);
  if (others.empty()) return false;
  candidate.two = others[whole_below(static_cast<std::uint32_t>(others.size()), bits)];
  candidate.others = static_cast<double>(others.size());
  return candidate.two != candidate.one;
}

/// Contact factor, and of several species the cross-section.
template <int D>
template <bool Mixed>
double ContactPartners<D>::weight_of(const CollisionStep<D>& step, const Candidate& candidate) const {
  double weight = 1;
  if constexpr (Mixed) weight = table_->pair(candidate.kinds).cross_section;
  if (step.factor == nullptr) return weight;
  Vector<D> place =
      step.particles[candidate.one].position + contact_place_ * candidate.reach * candidate.direction;
  wrap(place);
  const std::uint32_t cell = grid_.cell_of(place);
  if constexpr (Mixed) weight *= step.contact[cell * table_->pairs() + candidate.kinds];
  return weight * step.factor[cell];
}

/// Returns the momentum that the first gains times the distance from the second.
template <int D>
template <bool Mixed>
double ContactPartners<D>::collide_pair(const CollisionStep<D>& step, const Candidate& candidate,
                                        VelocityBox<D>& around) {
  const double momentum = Mixed ? kick_of_species(step, candidate) : kick(step, candidate);
  const auto velocity_1 = Lanes<D>::from(step.particles[candidate.one].velocity, 0),
             velocity_2 = Lanes<D>::from(step.particles[candidate.two].velocity, 0);
  boxes_[candidate.cell].include(velocity_1);
  boxes_[candidate.partner_cell].include(velocity_2);
  around.include(velocity_1);
  around.include(velocity_2);
  return momentum * candidate.reach;
}

/// The momentum that passes from the first to the second.
template <int D>
double ContactPartners<D>::kick(const CollisionStep<D>& step, const Candidate& candidate) const {
  Vector<D>&one = step.particles[candidate.one].velocity, &two = step.particles[candidate.two].velocity;
  SmoothInelastic{restitution_}(one, two, candidate.direction);
  return 0.5 * (1 + restitution_) * mass_ * candidate.approach;
}

template <int D>
double ContactPartners<D>::kick_of_species(const CollisionStep<D>& step, const Candidate& candidate) const {
  const PairOfSpecies& both = table_->pair(candidate.kinds);
  const double change = 0.5 * (1 + both.restitution) * candidate.approach;
  step.particles[candidate.one].velocity -= both.share_1 * change * candidate.direction;
  step.particles[candidate.two].velocity += both.share_2 * change * candidate.direction;
  if (std::uint64_t* counts = counts_by_species(*step.tally); counts != nullptr) ++counts[candidate.kinds];
  return both.twice_reduced_mass * change;
}

/// Into the box across periodic edges; false for a place beyond a wall.
template <int D>
bool ContactPartners<D>::wrap(Vector<D>& position) const {
  for (int axis = 0; axis < D; ++axis) {
    const double length = grid_.box()[axis];
    double& x = position[axis];
    if (x >= 0 && x <= length) continue;
    if (!periodic_[static_cast<std::size_t>(axis)]) return false;
    x += x < 0 ? length : -length;
  }
  return true;
}

template class ContactPartners<2>;
template class ContactPartners<3>;

}  // namespace sandglass::dsmc
