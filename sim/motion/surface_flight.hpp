#pragma once

#include "sim/motion/bounded_flight.hpp"
#include "sim/motion/free_flight.hpp"
#include "sim/motion/open_locator.hpp"
#include "sim/motion/passages.hpp"
#include "sim/motion/plain_flight.hpp"
#include "sim/motion/stream_index.hpp"

#include <algorithm>
#include <span>
#include <type_traits>

namespace sandglass::motion {

/// The flight of one step between walls and obstacles of every kind: free where nothing can be in the way, else from
/// surface to surface. `Open`: some side lets particles out.
template <int D, bool Open = false>
class SurfaceFlight {
 public:
  static constexpr int kDimension = D;
  using Surroundings = Surfaces<D>;
  template <class InBox>
  using Locator = std::conditional_t<Open, OpenLocator<D, InBox>, InBox>;
  using Lane = Lanes<D>;
  using Real = typename Lane::Real;

  /// `store`: constant where the flight only looks; then spins stay what they are.
  template <class Store>
  SurfaceFlight(const Surfaces<D>& surfaces, Store& store, const MotionStep& step)
      : surfaces_(surfaces),
        dt_(step.dt),
        key_(step.key),
        offsets_(store.offsets()),
        bodies_(surfaces.parameters, store),
        free_(surfaces.parameters.gravity, store.grid().box(), step.dt),
        bounded_(surfaces, store.grid().box(), step),
        box_(Lane::from(store.grid().box(), 0)) {
    Vector<D> low = Vector<D>::Zero(), high = store.grid().box();
    for (const WallSurface<D>& wall : surfaces.walls)
      (wall.place.high ? high : low)[wall.place.axis] = wall.reach(step.time, step.dt);
    low_ = Lane::from(low, -HUGE_VAL);
    high_ = Lane::from(high, HUGE_VAL);
  }

  /// The answer is where the flight ends: outside the box for who has left it; what a moving wall has carried out counts as
  /// at its edge.
  template <bool Counts>
  [[gnu::always_inline]] Real fly(Phase<D>& particle, std::size_t i) const {
    Real end;
    if (is_free(particle, end)) [[likely]]
      return fly_free<Counts>(particle, end);
    return fly_bounded<Counts>(particle, i);
  }

  /// Whether the path meets nothing; then `end` is where it ends.
  [[gnu::always_inline]] bool is_free(const Phase<D>& particle, Real& end) const {
    const double* components = particle.position.data();
    const Real start = Lane::load(components), velocity = Lane::load(components + D);
    end = free_.template end<true>(start, velocity);
    return stays(start, velocity, end);
  }
  /// fly() to the end that is_free() gave.
  template <bool Counts>
  [[gnu::always_inline]] Real fly_free(Phase<D>& particle, const Real& end) const {
    if constexpr (Counts) count_crossings(particle, end);
    double* components = particle.position.data();
    Lane::store(components, end);
    Lane::store(components + D, Lane::load(components + D) + free_.gain());
    return in_box(end);
  }
  /// Where a particle counts that ends its flight here.
  Real in_box(const Real& end) const {
    const Real above = end > 0 ? end : Real{};
    return above < box_ ? above : box_;
  }

  /// Where fly() would end. A path that meets boundaries is flown in `arrived`, and `bounded` set.
  Real look(const Phase<D>& particle, std::size_t i, Phase<D>& arrived, bool& bounded) const {
    Real end;
    if (is_free(particle, end)) return in_box(end);
    arrived = particle;
    bounded = true;
    return fly_bounded<false>(arrived, i);
  }

 private:
  /// The path lies within its start, its end and the end of its tangent.
  [[gnu::always_inline]] bool stays(const Real& start, const Real& velocity, const Real& end) const {
    const Real tangent = free_.template end<false>(start, velocity);
    return inside(start) && inside(end) && inside(tangent) && clear(start, end, tangent);
  }
  bool inside(const Real& position) const {
    return all<D>((position >= low_) & (position < high_));  // false for what is not a number
  }
  /// Whether no obstacle is near; a long path is not looked along.
  bool clear(const Real& start, const Real& end, const Real& tangent) const {
    if (surfaces_.obstacles.empty()) return true;
    Real low = start < end ? start : end, high = start < end ? end : start;
    low = tangent < low ? tangent : low;
    high = tangent < high ? high : tangent;
    Vector<D> from, to;
    Lane::store(from.data(), low);
    Lane::store(to.data(), high);
    return (to - from).maxCoeff() < 4 * surfaces_.obstacles.cell_edge() &&
           !surfaces_.obstacles.touches_any(from, to);
  }

  /// The path stays in the box: without gravity it passes a plane once or not at all.
  void count_crossings(const Phase<D>& particle, const Real& end) const {
    if (surfaces_.parameters.planes == nullptr) return;
    const Vector<D>&start = particle.position, &velocity = particle.velocity;
    for (Plane& plane : *surfaces_.parameters.planes) {
      const int axis = plane.axis();
      if (const double pull = surfaces_.parameters.gravity[axis]; pull != 0)
        count_passages(plane, box_[axis], {start[axis], velocity[axis], pull}, dt_, end[axis]);
      else if ((start[axis] < plane.position()) != (end[axis] < plane.position()))
        plane.count(velocity[axis]);
    }
  }

  template <bool Counts>
  [[gnu::noinline]] Real fly_bounded(Phase<D>& particle, std::size_t i) const {
    require_finite(particle);
    Random random = surfaces_.draws ? stream_of(i) : Random();
    if constexpr (Counts)
      bounded_.fly(particle, bodies_[i], random,
                   {surfaces_.parameters.planes, surfaces_.parameters.impulses});
    else
      bounded_.fly(particle, bodies_[i], random, {});
    require_finite(particle);
    if constexpr (Open)
      if (surfaces_.has_left(particle.position)) return Lane::from(particle.position, 0);
    return in_box(Lane::from(particle.position, 0));
  }

  Random stream_of(std::size_t i) const {
    const auto next = std::upper_bound(offsets_.begin(), offsets_.end(), i);
    const auto cell = static_cast<std::uint32_t>(next - offsets_.begin() - 1);
    return {key_, stream_index(cell, static_cast<std::uint32_t>(i - offsets_[cell]))};
  }

  const Surfaces<D>& surfaces_;
  double dt_;
  StreamKey key_;
  std::span<const std::uint32_t> offsets_;  ///< first particle of each cell before the step
  Bodies<D> bodies_;
  FreeFlight<D> free_;
  BoundedFlight<D> bounded_;
  Real low_, high_, box_;
};

}  // namespace sandglass::motion
