#pragma once

#include "sim/method/event_driven/agent.hpp"
#include "sim/observe/wall_impulses.hpp"

namespace sandglass::event_driven {

/// One side of the box.
struct SidePlace {
  int axis = 0;
  bool high = false;
  double edge = 0;

  /// Of the side in the books.
  std::size_t number() const { return 2 * static_cast<std::size_t>(axis) + high; }
};

/// A side by which particles leave for good, each when its centre passes.
template <int D>
class OpenSideAgent final : public Agent<D> {
 public:
  /// `impulses` takes what leaves and must outlive it; null: it is not counted.
  OpenSideAgent(const SidePlace& place, const Vector<D>& gravity, WallImpulses<D>* impulses = nullptr)
      : place_(place), gravity_(gravity[place.axis]), impulses_(impulses) {}

  Box<D> reach() const override;
  double delay(const ParticleState<D>& particle, double now) const override;
  Outcome act(ParticleState<D>& particle, double now, Random& random) override;
  void count(std::map<std::string, double>& counters) const override;
  std::vector<double> save() const override { return {static_cast<double>(left_)}; }
  void load(const std::vector<double>& state) override { left_ = static_cast<std::uint64_t>(state.at(0)); }

 private:
  SidePlace place_;
  double gravity_;
  WallImpulses<D>* impulses_;
  std::uint64_t left_ = 0;
};

extern template class OpenSideAgent<2>;
extern template class OpenSideAgent<3>;

}  // namespace sandglass::event_driven
