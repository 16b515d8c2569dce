#pragma once

#include "sim/method/event_driven/agent.hpp"
#include "sim/observe/plane.hpp"

namespace sandglass::event_driven {

/// Counts the centres that pass a plane inside the box and changes nothing.
template <int D>
class PlaneAgent final : public Agent<D> {
 public:
  PlaneAgent(Plane* plane, const Vector<D>& gravity) : plane_(plane), gravity_(gravity[plane->axis()]) {}

  Box<D> reach() const override {
    Box<D> box = Box<D>::everywhere();
    box.low[plane_->axis()] = box.high[plane_->axis()] = plane_->position();
    return box;
  }
  double delay(const ParticleState<D>& particle, double now) const override;
  Outcome act(ParticleState<D>& particle, double now, Random& random) override;

 private:
  Plane* plane_;
  double gravity_;
};

/// Calls somebody at regular times.
template <int D, class Action>
class TimerAgent final : public Agent<D> {
 public:
  TimerAgent(double first, double interval, Action action)
      : first_(first), interval_(interval), action_(std::move(action)) {}

  double next() const override { return first_ + static_cast<double>(count_) * interval_; }
  void act(ParticleAccess<D>& particles, double now) override {
    ++count_;
    action_(particles, now);
  }
  std::vector<double> save() const override { return {static_cast<double>(count_)}; }
  void load(const std::vector<double>& state) override { count_ = static_cast<std::uint64_t>(state.at(0)); }

 private:
  double first_, interval_;
  std::uint64_t count_ = 0;
  Action action_;
};

extern template class PlaneAgent<2>;
extern template class PlaneAgent<3>;

}  // namespace sandglass::event_driven
