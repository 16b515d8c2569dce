#pragma once

#include "sim/method/dsmc/smooth_pairs.hpp"

namespace sandglass::dsmc {

/// An honest rule with the planted faults of the suite, which that rule must not pay for.
template <int D, class Rule>
class FaultyPairs : public Rule {
 public:
  using Columns = typename Rule::Columns;

  explicit FaultyPairs(const Parameters& parameters) : Rule(parameters), faults_(parameters.faults) {}

  double bound(const Columns& columns, std::uint32_t count, double speed) const {
    return faults_.bound * Rule::bound(columns, count, speed);
  }
  std::uint64_t whole(double expected, Random& random) const {
    return faults_.fraction_truncated ? static_cast<std::uint64_t>(expected) : Rule::whole(expected, random);
  }
  bool accepts(const Columns& columns, const Pair& pair, double square_speed, double square_bound,
               double uniform) const {
    return square_speed > 0 &&
           Rule::accepts(columns, pair, square_speed, square_bound, uniform) != faults_.acceptance_inverted;
  }
  double rate(const Columns& columns, const Pair& pair, double speed) const {
    if (!faults_.time_of_other_pair) return Rule::rate(columns, pair, speed);
    return Rule::rate(columns, {0, 1}, (columns.phases[0].velocity - columns.phases[1].velocity).norm());
  }
  Vector<D> collide(const Columns& columns, const Pair& pair, const Vector<D>& relative, double square_speed,
                    Random& random) const {
    Vector<D>& velocity_2 = columns.phases[pair.second].velocity;
    const Vector<D> before_2 = velocity_2;
    const Vector<D> normal = contact_normal(relative, 1 / std::sqrt(square_speed),
                                            Vector<D - 1>(faults_.impact * this->impact(columns, random)));
    const Vector<D> change = strike(columns, pair, normal);
    velocity_2 += faults_.momentum_leak * (before_2 - velocity_2);
    return change;
  }

 private:
  Vector<D> strike(const Columns& columns, const Pair& pair, const Vector<D>& normal) const {
    if constexpr (requires { columns.spins; }) {
      Spin<D>&one = columns.spins[pair.first], &two = columns.spins[pair.second];
      const Spin<D> before_1 = one, before_2 = two;
      const Vector<D> change = Rule::strike(columns, pair, normal);
      if (faults_.spins_reversed) one = 2 * before_1 - one, two = 2 * before_2 - two;
      return change;
    } else {
      return Rule::strike(columns, pair, normal);
    }
  }

  Faults faults_;
};

}  // namespace sandglass::dsmc
