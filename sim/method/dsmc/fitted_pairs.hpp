#pragma once

#include "sim/method/dsmc/smooth_pairs.hpp"
#include "sim/physics/fitted_impact.hpp"

namespace sandglass::dsmc {

/// Smooth particles whose impact parameters follow the fitted distribution of the step.
template <int D>
class FittedPairs : public SmoothPairs<D> {
 public:
  struct Columns : SmoothPairs<D>::Columns {
    FittedImpact impact;
  };

  explicit FittedPairs(const Parameters& parameters)
      : SmoothPairs<D>(parameters), restitution_(parameters.restitution) {}

  Columns columns(const CollisionStep<D>& step, std::uint32_t cell) const {
    return {SmoothPairs<D>::columns(step, cell), {step.impact_coefficient}};
  }
  Vector<D - 1> impact(const Columns& columns, Random& random) const {
    return columns.impact.draw(uniform_impact<D>(random));
  }
  Vector<D> collide(const Columns& columns, const Pair& pair, const Vector<D>& relative, double square_speed,
                    Random& random) const {
    const Vector<D> normal = contact_normal(relative, 1 / std::sqrt(square_speed), impact(columns, random));
    const Vector<D> change = -0.5 * (1 + restitution_) * relative.dot(normal) * normal;
    columns.phases[pair.first].velocity += change;
    columns.phases[pair.second].velocity -= change;
    return change;
  }

 private:
  double restitution_;
};

}  // namespace sandglass::dsmc
