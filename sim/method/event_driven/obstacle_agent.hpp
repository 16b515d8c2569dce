#pragma once

#include "sim/method/event_driven/agent.hpp"
#include "sim/physics/wall.hpp"

namespace sandglass::event_driven {

/// A fixed disk or sphere (Baryshev 2003). It does not touch a periodic boundary.
template <int D>
class ObstacleAgent final : public Agent<D> {
 public:
  ObstacleAgent(const Vector<D>& centre, double radius, const WallRule& rule, const Vector<D>& gravity,
                double largest_radius)
      : centre_(centre),
        radius_(radius),
        rule_(rule),
        gravity_(gravity),
        reach_((radius + largest_radius) * (1 + 1e-9)) {}

  Box<D> reach() const override;
  bool reaches(const Box<D>& cell) const override;
  double delay(const ParticleState<D>& particle, double now) const override;
  bool draws() const override { return sandglass::draws(rule_); }
  Outcome act(ParticleState<D>& particle, double now, Random& random) override;

 private:
  Vector<D> centre_;
  double radius_;
  WallRule rule_;
  Vector<D> gravity_;
  double reach_;  ///< of the largest particle's centre, and a little more
};

extern template class ObstacleAgent<2>;
extern template class ObstacleAgent<3>;

}  // namespace sandglass::event_driven
