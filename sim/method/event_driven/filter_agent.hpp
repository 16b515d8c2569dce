#pragma once

#include "sim/method/event_driven/backflow.hpp"
#include "sim/method/event_driven/open_side_agent.hpp"

namespace sandglass::event_driven {

/// A plane before an open side: who comes to it and is not turned back becomes heavy and moves with the stream until it
/// leaves, so that those behind find neither a gap nor a gas at another temperature (Baryshev 2003, 3.3). Heavy ones are of
/// the species after the scene's.
template <int D>
class FilterAgent final : public Agent<D> {
 public:
  /// `place.edge` is where the plane stands.
  FilterAgent(const SidePlace& place, const Backflow<D>& backflow, const Vector<D>& velocity,
              WallImpulses<D>* impulses = nullptr)
      : place_(place), backflow_(backflow), velocity_(velocity), impulses_(impulses) {}

  Box<D> reach() const override;
  double delay(const ParticleState<D>& particle, double now) const override;
  bool draws() const override { return true; }
  Outcome act(ParticleState<D>& particle, double now, Random& random) override;
  /// At the beginning, for those who stand behind the plane.
  double next() const override { return begun_ ? HUGE_VAL : 0; }
  void act(ParticleAccess<D>& particles, double now) override;
  void count(std::map<std::string, double>& counters) const override;
  std::vector<double> save() const override;
  void load(const std::vector<double>& state) override;

 private:
  SidePlace place_;
  Backflow<D> backflow_;
  Vector<D> velocity_;
  WallImpulses<D>* impulses_;
  bool begun_ = false;
  std::uint64_t turned_ = 0;
};

extern template class FilterAgent<2>;

}  // namespace sandglass::event_driven
