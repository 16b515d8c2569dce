#pragma once

#include "sim/motion/bodies.hpp"
#include "sim/motion/surfaces.hpp"
#include "sim/space/particle_store.hpp"

namespace sandglass::motion {

/// Hits on walls and obstacles that a particle makes in one step; after the last it stays where it is for the rest of the
/// step. A ball that comes to rest on a floor bounces infinitely often in a finite time.
constexpr int kMostHits = 200;

/// What counts the passages and hits of a flight; null for none.
template <int D>
struct FlightCounters {
  std::vector<Plane>* planes = nullptr;
  WallImpulses<D>* impulses = nullptr;
};

/// The exact flight of one particle through one step, from surface to surface.
template <int D>
class BoundedFlight {
 public:
  /// Both must outlive it.
  BoundedFlight(const Surfaces<D>& surfaces, const Vector<D>& box, const MotionStep& step)
      : surfaces_(surfaces), gravity_(surfaces.parameters.gravity), box_(box), step_(step) {}

  /// What starts behind a wall or in an obstacle is first put on the nearest point of the surface. Who leaves by an open
  /// side is left outside the box; the side takes its momentum and energy.
  void fly(Phase<D>& particle, const Body<D>& body, Random& random, const FlightCounters<D>& counters) const;

 private:
  /// What ends a straight or falling piece of the path.
  struct Event {
    enum class Kind { end, seam, wall, obstacle, exit } kind;
    double delay;
    std::size_t index = 0;  ///< of the wall, obstacle or open side; of a seam, the axis
  };

  Event first_event(const Phase<D>& particle, double time, double left) const;
  double piece(const Vector<D>& velocity, double left) const;
  void look_for_seams(const Phase<D>& particle, Event& first) const;
  void look_for_exits(const Phase<D>& particle, Event& first) const;
  void look_for_walls(const Phase<D>& particle, double time, Event& first) const;
  void look_for_obstacles(const Phase<D>& particle, Event& first) const;

  void move(Phase<D>& particle, const Event& event, double time, std::vector<Plane>* planes) const;
  void place_on(const Event& event, double time, Vector<D>& x) const;
  void turn_at(const Event& event, double time, Phase<D>& particle, const Body<D>& body, Random& random,
               WallImpulses<D>* impulses) const;
  /// False unless it has left the box.
  bool leaves(const Phase<D>& particle, const Body<D>& body, WallImpulses<D>* impulses) const;
  /// The wall carries what stays on it.
  void rest_on(std::size_t wall, double time, double left, double mass, WallImpulses<D>& impulses) const;
  /// Out of obstacles and in front of walls.
  void put_inside(double time, Vector<D>& x) const;
  bool push_out_of_one(Vector<D>& x) const;
  void wrap_around(Vector<D>& x) const;

  const Surfaces<D>& surfaces_;
  const Vector<D>& gravity_;
  const Vector<D>& box_;
  MotionStep step_;
};

extern template class BoundedFlight<2>;
extern template class BoundedFlight<3>;

}  // namespace sandglass::motion
