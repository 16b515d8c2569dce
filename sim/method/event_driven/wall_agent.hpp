#pragma once

#include "sim/method/event_driven/agent.hpp"
#include "sim/observe/wall_impulses.hpp"
#include "sim/physics/plane_flight.hpp"
#include "sim/physics/wall.hpp"

namespace sandglass::event_driven {

/// One side of the box. It may move; particles touch it with their surface, not their centre.
template <int D>
struct WallPlace {
  int axis = 0;
  bool high = false;
  double edge = 0;                         ///< coordinate at time zero
  Vector<D> velocity = Vector<D>::Zero();  ///< constant; its normal part moves the plane
  double amplitude = 0, frequency = 0;     ///< of the sinusoidal part of the motion along the axis
  double largest_radius = 0.5;             ///< of the particles
};

template <int D>
class WallAgent final : public Agent<D> {
 public:
  /// `impulses` takes what the wall takes and must outlive it; null: it is not counted.
  WallAgent(const WallPlace<D>& place, const WallRule& rule, const Vector<D>& gravity,
            WallImpulses<D>* impulses = nullptr);

  Box<D> reach() const override;
  double delay(const ParticleState<D>& particle, double now) const override;
  bool draws() const override { return sandglass::draws(rule_); }
  Outcome act(ParticleState<D>& particle, double now, Random& random) override;

 private:
  WallPlace<D> place_;
  WallRule rule_;
  double inward_;       ///< +1 at a low side, -1 at a high one
  double gravity_;      ///< along the inward normal
  PlaneMotion motion_;  ///< along the inward normal, from the edge
  WallImpulses<D>* impulses_;
};

extern template class WallAgent<2>;
extern template class WallAgent<3>;

}  // namespace sandglass::event_driven
