#include "validation/law/few_body.hpp"

#include "sim/base/error.hpp"

#include <cmath>

#include <Eigen/Dense>
#include <fmt/format.h>

namespace sandglass::law {

namespace {
using System = Eigen::Matrix<double, 12, 12>;  // columns: both velocities, both spins
using State = Eigen::Matrix<double, 12, 1>;

Eigen::Matrix3d cross(const Vector<3>& a) {
  Eigen::Matrix3d matrix;
  matrix << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return matrix;
}

/// Velocity of the first surface relative to the second, as a matrix on the state.
Eigen::Matrix<double, 3, 12> slip(const Ball& first, const Ball& second, const Vector<3>& normal) {
  Eigen::Matrix<double, 3, 12> matrix;
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity(), turn = cross(normal);
  matrix << identity, -identity, first.radius * turn, second.radius * turn;  // w x (-n) = n x w
  return matrix;
}

/// What every collision keeps: momentum, and each ball's angular momentum about the contact.
void add_conserved(const Ball& first, const Ball& second, const Vector<3>& normal, System& system) {
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity(), turn = cross(normal);
  system.setZero();
  system.block<3, 3>(0, 0) = first.mass * identity;
  system.block<3, 3>(0, 3) = second.mass * identity;
  system.block<3, 3>(3, 0) = first.mass * first.radius * turn;
  system.block<3, 3>(3, 6) = first.inertia * identity;
  system.block<3, 3>(6, 3) = -second.mass * second.radius * turn;
  system.block<3, 3>(6, 9) = second.inertia * identity;
}

struct Frame3 {
  Vector<3> normal, along, across;  ///< along: the slip
};

Frame3 frame_of(const Vector<3>& normal, const Vector<3>& surface_velocity) {
  const Vector<3> tangential = surface_velocity - surface_velocity.dot(normal) * normal;
  const double speed = tangential.norm();
  const Vector<3> along = speed > 0 ? Vector<3>(tangential / speed) : normal.unitOrthogonal();
  return {normal, along, normal.cross(along)};
}

State solve(const System& system, const State& right) {
  // Rows of different units: scaled by their own size before pivoting.
  const State scale = system.rowwise().norm().cwiseInverse();
  return (scale.asDiagonal() * system).fullPivLu().solve(State(scale.asDiagonal() * right));
}

State state_of(const Ball& first, const Ball& second) {
  State state;
  state << first.velocity, second.velocity, first.spin, second.spin;
  return state;
}

/// Earliest time from now at which the two touch while they approach; infinite when they do not.
double time_to_touch(const Ball& first, const Ball& second) {
  const Vector<3> apart = first.position - second.position, relative = first.velocity - second.velocity;
  const double reach = first.radius + second.radius;
  const double closing = -apart.dot(relative), gap = apart.squaredNorm() - reach * reach;
  if (!(closing > 0)) return HUGE_VAL;
  if (gap <= 0) return 0;
  const double discriminant = closing * closing - relative.squaredNorm() * gap;
  return discriminant < 0 ? HUGE_VAL : gap / (closing + std::sqrt(discriminant));
}

struct Contact {
  double delay = HUGE_VAL;
  std::size_t first = 0, second = 0;
};

Contact next_contact(const std::vector<Ball>& balls) {
  Contact next;
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = i + 1; j < balls.size(); ++j)
      if (const double delay = time_to_touch(balls[i], balls[j]); delay < next.delay) next = {delay, i, j};
  return next;
}

double defocusing(const Ball& first, const Ball& second, double flight) {
  const Vector<3> relative = first.velocity - second.velocity;
  const double approach = (second.position - first.position).normalized().dot(relative);
  return 1 + 2 * relative.squaredNorm() * flight / (approach * (first.radius + second.radius));
}
}  // namespace

void collide(Ball& first, Ball& second, const Touch& touch) {
  const Vector<3> normal = (first.position - second.position).normalized();
  const State before = state_of(first, second);
  const Eigen::Matrix<double, 3, 12> surface = slip(first, second, normal);
  const Frame3 frame = frame_of(normal, surface * before);
  System system;
  add_conserved(first, second, normal, system);
  State right = system * before;
  system.row(9) = normal.transpose() * surface;
  system.row(10) = frame.along.transpose() * surface;
  system.row(11) = frame.across.transpose() * surface;
  right[9] = -touch.restitution * system.row(9).dot(before);
  right[10] = -touch.tangential * system.row(10).dot(before);
  right[11] = -touch.tangential * system.row(11).dot(before);
  const bool smooth = touch.tangential == -1;
  State after = solve(system, right);
  const Vector<3> change = (after - before).head<3>();  // impulse over the first mass
  const double friction = smooth ? 0 : touch.friction;
  if (smooth || -change.dot(frame.along) > friction * change.dot(normal)) {
    system.row(10).setZero();
    system.row(11).setZero();
    system.row(10).head<3>() = (frame.along + friction * normal).transpose();
    system.row(11).head<3>() = frame.across.transpose();
    right[10] = system.row(10).dot(before);
    right[11] = system.row(11).dot(before);
    after = solve(system, right);
  }
  first.velocity = after.segment<3>(0);
  second.velocity = after.segment<3>(3);
  first.spin = after.segment<3>(6);
  second.spin = after.segment<3>(9);
}

FewBodyResult few_body(std::vector<Ball> balls, const TouchOf& touch, double until, std::size_t most) {
  FewBodyResult result;
  double now = 0;
  for (;;) {
    const Contact next = next_contact(balls);
    const double flight = std::min(next.delay, until - now);
    for (Ball& ball : balls) ball.position += flight * ball.velocity;
    if (now + next.delay > until) break;
    now += flight;
    if (result.collisions == most)
      throw InputError(fmt::format("{} collisions until time {}: a collapse; end earlier", most, now));
    Ball &first = balls[next.first], &second = balls[next.second];
    result.amplification *= defocusing(first, second, now - result.last_collision);
    collide(first, second, touch(next.first, next.second));
    ++result.collisions;
    result.last_collision = now;
  }
  result.balls = std::move(balls);
  return result;
}

}  // namespace sandglass::law
