#pragma once

#include "sim/method/event_driven/backflow.hpp"
#include "sim/method/event_driven/open_side_agent.hpp"

namespace sandglass::event_driven {

/// An open side beyond which the stream goes on: who is not turned back leaves. Right where most leave without a collision
/// beyond the side, that is in a dilute gas; a dense one leaks (Baryshev 2003, 3.3).
template <int D>
class OutflowAgent final : public Agent<D> {
 public:
  OutflowAgent(const SidePlace& place, const Backflow<D>& backflow, const Vector<D>& gravity,
               WallImpulses<D>* impulses = nullptr)
      : place_(place), side_(place, gravity, impulses), backflow_(backflow), impulses_(impulses) {}

  Box<D> reach() const override { return side_.reach(); }
  double delay(const ParticleState<D>& particle, double now) const override {
    return side_.delay(particle, now);
  }
  bool draws() const override { return true; }
  Outcome act(ParticleState<D>& particle, double now, Random& random) override;
  void count(std::map<std::string, double>& counters) const override;
  std::vector<double> save() const override;
  void load(const std::vector<double>& state) override;

 private:
  SidePlace place_;
  OpenSideAgent<D> side_;
  Backflow<D> backflow_;
  WallImpulses<D>* impulses_;
  std::uint64_t turned_ = 0;
};

extern template class OutflowAgent<2>;
extern template class OutflowAgent<3>;

}  // namespace sandglass::event_driven
