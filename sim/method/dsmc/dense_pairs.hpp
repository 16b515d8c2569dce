#pragma once

#include "sim/method/dsmc/species_pairs.hpp"

namespace sandglass::dsmc {

/// A rule for several species of a dense gas: each pair of them has its own contact factor, in units of the largest of the
/// cell, for which candidates are drawn.
template <int D, class Rule>
class DensePairs : public Rule {
 public:
  struct Columns : Rule::Columns {
    const double* contact;  ///< by pair of species
  };

  using Rule::Rule;

  Columns columns(const CollisionStep<D>& step, std::uint32_t cell) const {
    return {Rule::columns(step, cell), step.contact + cell * this->table_.pairs()};
  }
  bool accepts(const Columns& columns, const Pair& pair, double square_speed, double square_bound,
               double uniform) const {
    const double contact = columns.contact[this->index(columns, pair)];
    return Rule::accepts(columns, pair, square_speed * contact * contact, square_bound, uniform);
  }
  double rate(const Columns& columns, const Pair& pair, double speed) const {
    return Rule::rate(columns, pair, speed) * columns.contact[this->index(columns, pair)];
  }
};

}  // namespace sandglass::dsmc
