#include "sim/motion/bounded_flight.hpp"

#include "sim/base/error.hpp"
#include "sim/base/stop_request.hpp"
#include "sim/motion/passages.hpp"
#include "sim/physics/obstacle_flight.hpp"
#include "sim/physics/plane_flight.hpp"
#include "sim/space/flight.hpp"

#include <cmath>
#include <limits>

namespace sandglass::motion {

namespace {

/// Pieces of a path in one step, without a hit; a step so long, or a particle so fast, is an error.
constexpr int kMostPieces = 1'000'000;
constexpr int kBetweenLooks = 4096;
/// Between obstacles that overlap each other, one pushes into the next.
constexpr int kMostPushes = 100;
/// Length of a piece in cells of obstacles: they limit what is searched for a hit.
constexpr double kPiece = 4;

template <int D>
Vector<D> end_of(const Phase<D>& particle, const Vector<D>& gravity, double t) {
  return particle.position + t * (particle.velocity + 0.5 * t * gravity);
}

/// Onto the ball where it is nearest; never inside it by rounding.
template <int D>
void push_out(const Vector<D>& centre, double radius, Vector<D>& x) {
  Vector<D> from = x - centre;
  if (from.isZero(0)) from = Vector<D>::Unit(0);
  const Vector<D> normal = from.normalized();
  double reach = radius;
  for (x = centre + reach * normal; (x - centre).norm() < radius; x = centre + reach * normal)
    reach += std::numeric_limits<double>::epsilon() * (reach + centre.norm());
}

template <int D>
std::size_t side_of(const WallSurface<D>& wall) {
  return WallImpulses<D>::side(wall.place.axis, wall.place.high);
}

}  // namespace

template <int D>
void BoundedFlight<D>::fly(Phase<D>& particle, const Body<D>& body, Random& random,
                           const FlightCounters<D>& counters) const {
  const double end = step_.time + step_.dt;
  double time = step_.time, left = step_.dt;
  wrap_around(particle.position);
  put_inside(time, particle.position);
  if (leaves(particle, body, counters.impulses)) return;
  int hits = 0, pieces = 0;
  while (left > 0 && hits < kMostHits) {
    if (pieces % kBetweenLooks == 0) stop_request.heed();
    const Event event = first_event(particle, time, left);
    left -= event.delay;
    time = end - left;
    move(particle, event, time, counters.planes);
    if (event.kind == Event::Kind::exit) {
      leaves(particle, body, counters.impulses);
      return;
    }
    if (event.kind == Event::Kind::wall || event.kind == Event::Kind::obstacle) {
      turn_at(event, time, particle, body, random, counters.impulses);
      if (++hits == kMostHits && counters.impulses != nullptr && event.kind == Event::Kind::wall)
        rest_on(event.index, time, left, body.mass, *counters.impulses);
    } else if (++pieces > kMostPieces) {
      throw RunError(
          "a particle crosses the box or its obstacles a million times in one step: time step too long?");
    }
  }
  wrap_around(particle.position);
  put_inside(end, particle.position);
}

template <int D>
typename BoundedFlight<D>::Event BoundedFlight<D>::first_event(const Phase<D>& particle, double time,
                                                               double left) const {
  Event first{Event::Kind::end, left};
  if (!surfaces_.obstacles.empty()) {
    first.delay = piece(particle.velocity, left);
    look_for_seams(particle, first);
  }
  look_for_exits(particle, first);
  look_for_walls(particle, time, first);
  if (!surfaces_.obstacles.empty()) look_for_obstacles(particle, first);
  return first;
}

/// So short that the obstacles near it are few.
template <int D>
double BoundedFlight<D>::piece(const Vector<D>& velocity, double left) const {
  const double fastest = velocity.norm() + left * gravity_.norm(),
               longest = kPiece * surfaces_.obstacles.cell_edge();
  return fastest * left > longest ? longest / fastest : left;
}

template <int D>
void BoundedFlight<D>::look_for_seams(const Phase<D>& particle, Event& first) const {
  for (int axis = 0; axis < D; ++axis) {
    if (surfaces_.parameters.walled[static_cast<std::size_t>(axis)]) continue;
    const double x = particle.position[axis], v = particle.velocity[axis], g = gravity_[axis];
    const double low = time_to_wall(x, v, g, 0, -1), high = time_to_wall(x, v, g, box_[axis], 1);
    if (const double delay = std::min(low, high); delay < first.delay)
      first = {Event::Kind::seam, delay, static_cast<std::size_t>(axis)};
  }
}

template <int D>
void BoundedFlight<D>::look_for_exits(const Phase<D>& particle, Event& first) const {
  for (std::size_t i = 0; i < surfaces_.open.size(); ++i) {
    const OpenSide& side = surfaces_.open[i];
    const Arc arc{side.height(particle.position[side.axis]), side.inward * particle.velocity[side.axis],
                  side.inward * gravity_[side.axis]};
    if (const double delay = time_to_fall(arc); delay < first.delay) first = {Event::Kind::exit, delay, i};
  }
}

template <int D>
void BoundedFlight<D>::look_for_walls(const Phase<D>& particle, double time, Event& first) const {
  for (std::size_t i = 0; i < surfaces_.walls.size(); ++i) {
    const WallSurface<D>& wall = surfaces_.walls[i];
    const int axis = wall.place.axis;
    const Arc arc{wall.height(particle.position, time), wall.inward * particle.velocity[axis],
                  wall.inward * gravity_[axis]};
    const double delay = wall.place.moves() ? time_to_plane(arc, wall.from_now(time)) : time_to_fall(arc);
    if (delay < first.delay) first = {Event::Kind::wall, delay, i};
  }
}

template <int D>
void BoundedFlight<D>::look_for_obstacles(const Phase<D>& particle, Event& first) const {
  // The path lies within its start, its end and the end of its tangent.
  const Vector<D>& start = particle.position;
  const Vector<D> end = end_of<D>(particle, gravity_, first.delay);
  const Vector<D> tangent = start + first.delay * particle.velocity;
  const Vector<D> low = start.cwiseMin(end).cwiseMin(tangent), high = start.cwiseMax(end).cwiseMax(tangent);
  surfaces_.obstacles.for_each_touching(low, high, [&](std::uint32_t i) {
    const ObstaclePlace<D>& obstacle = surfaces_.parameters.obstacles[i];
    const double delay =
        time_to_obstacle<D>(start - obstacle.centre, particle.velocity, gravity_, obstacle.radius);
    const bool tie = delay == first.delay && first.kind == Event::Kind::obstacle && i < first.index;
    if (delay < first.delay || tie) first = {Event::Kind::obstacle, delay, i};
    return true;
  });
}

template <int D>
void BoundedFlight<D>::move(Phase<D>& particle, const Event& event, double time,
                            std::vector<Plane>* planes) const {
  const Vector<D> from = particle.position;
  particle.position = end_of<D>(particle, gravity_, event.delay);
  place_on(event, time, particle.position);
  if (planes != nullptr)
    for (Plane& plane : *planes) {
      const int axis = plane.axis();
      count_passages(plane, box_[axis], {from[axis], particle.velocity[axis], gravity_[axis]}, event.delay,
                     particle.position[axis]);
    }
  particle.velocity += event.delay * gravity_;
  if (event.kind == Event::Kind::seam) {
    double& x = particle.position[static_cast<int>(event.index)];
    x = x == 0 ? box_[static_cast<int>(event.index)] : 0;
  }
  if (event.kind == Event::Kind::exit) {
    const OpenSide& side = surfaces_.open[event.index];
    particle.position[side.axis] = side.edge - side.inward * box_[side.axis];
  }
}

/// Exactly where the event is, whatever rounding says.
template <int D>
void BoundedFlight<D>::place_on(const Event& event, double time, Vector<D>& x) const {
  switch (event.kind) {
    case Event::Kind::end:
    case Event::Kind::exit:
      break;
    case Event::Kind::seam: {
      const int axis = static_cast<int>(event.index);
      x[axis] = x[axis] < 0.5 * box_[axis] ? 0 : box_[axis];
      break;
    }
    case Event::Kind::wall:
      x[surfaces_.walls[event.index].place.axis] = surfaces_.walls[event.index].at(time);
      break;
    case Event::Kind::obstacle: {
      const ObstaclePlace<D>& obstacle = surfaces_.parameters.obstacles[event.index];
      push_out<D>(obstacle.centre, obstacle.radius, x);
      break;
    }
  }
}

template <int D>
void BoundedFlight<D>::turn_at(const Event& event, double time, Phase<D>& particle, const Body<D>& body,
                               Random& random, WallImpulses<D>* impulses) const {
  const Vector<D> before = particle.velocity;
  const ParticleAtWall<D> touching{particle.velocity, body.spin, body.mass, body.radius, body.inertia};
  if (event.kind == Event::Kind::wall) {
    const WallSurface<D>& wall = surfaces_.walls[event.index];
    const Vector<D> moving = wall.velocity_at(time);
    const double energy = impulses != nullptr ? energy_beside(moving, touching) : 0;  // only where it counts
    reflect<D>(wall.place.rule, wall.normal(), moving, touching, random);
    if (impulses != nullptr)
      impulses->add(side_of(wall), body.mass * (before - particle.velocity), moving,
                    energy - energy_beside(moving, touching));
  } else {
    const ObstaclePlace<D>& obstacle = surfaces_.parameters.obstacles[event.index];
    reflect<D>(obstacle.rule, (particle.position - obstacle.centre).normalized(), Vector<D>::Zero(), touching,
               random);
  }
}

template <int D>
bool BoundedFlight<D>::leaves(const Phase<D>& particle, const Body<D>& body,
                              WallImpulses<D>* impulses) const {
  const OpenSide* side = surfaces_.left_by(particle.position);
  if (side != nullptr && impulses != nullptr)
    impulses->add(WallImpulses<D>::side(side->axis, side->inward < 0), body.mass * particle.velocity,
                  Vector<D>::Zero(), energy_of(particle.velocity, body));
  return side != nullptr;
}

template <int D>
void BoundedFlight<D>::rest_on(std::size_t wall, double time, double left, double mass,
                               WallImpulses<D>& impulses) const {
  const WallSurface<D>& floor = surfaces_.walls[wall];
  impulses.add(side_of(floor), mass * left * gravity_, floor.velocity_at(time), 0);
}

template <int D>
bool BoundedFlight<D>::push_out_of_one(Vector<D>& x) const {
  const Vector<D> from = x;
  bool pushed = false;
  surfaces_.obstacles.for_each_touching(from, from, [&](std::uint32_t i) {
    const ObstaclePlace<D>& obstacle = surfaces_.parameters.obstacles[i];
    pushed = (from - obstacle.centre).norm() < obstacle.radius;
    if (pushed) push_out<D>(obstacle.centre, obstacle.radius, x);
    return !pushed;
  });
  return pushed;
}

/// Obstacles first: a wall that has moved over one holds all the same.
template <int D>
void BoundedFlight<D>::put_inside(double time, Vector<D>& x) const {
  for (int pushes = 0; pushes < kMostPushes && push_out_of_one(x); ++pushes) continue;
  for (const WallSurface<D>& wall : surfaces_.walls)
    if (wall.height(x, time) < 0) x[wall.place.axis] = wall.at(time);
}

template <int D>
void BoundedFlight<D>::wrap_around(Vector<D>& x) const {
  for (int axis = 0; axis < D; ++axis)
    if (!surfaces_.parameters.walled[static_cast<std::size_t>(axis)])
      x[axis] = wrap(x[axis], box_[axis], 1 / box_[axis]);
}

template class BoundedFlight<2>;
template class BoundedFlight<3>;

}  // namespace sandglass::motion
