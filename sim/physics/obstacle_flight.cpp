#include "sim/physics/obstacle_flight.hpp"

#include "sim/base/error.hpp"
#include "sim/physics/first_approach.hpp"

namespace sandglass {
namespace {

struct Window {
  double from, to;

  bool empty() const { return !(from <= to); }
};
constexpr Window kNoWindow{kNever, -kNever};

Window common(const Window& a, const Window& b) { return {std::max(a.from, b.from), std::min(a.to, b.to)}; }

/// When place + speed t + acceleration t^2 / 2 is at most zero, for acceleration > 0. Neither root cancels.
Window time_below(double place, double speed, double acceleration) {
  const double discriminant = speed * speed - 2 * acceleration * place;
  if (discriminant < 0) return kNoWindow;
  const double sum = -(speed + std::copysign(std::sqrt(discriminant), speed));
  const double a = sum / acceleration, b = sum == 0 ? a : 2 * place / sum;
  return {std::min(a, b), std::max(a, b)};
}

/// When |x + v t| is at most `reach`. From the point of closest approach: far away, the discriminant would cancel.
template <int D>
Window time_within(const Vector<D>& x, const Vector<D>& v, double reach) {
  const double square = v.squaredNorm();
  if (!(square > 0)) return x.norm() <= reach ? Window{0, kNever} : kNoWindow;
  const double closest = -x.dot(v) / square;
  const double left = reach * reach - (x + closest * v).squaredNorm();
  if (left < 0) return kNoWindow;
  const double half = std::sqrt(left / square);
  return {closest - half, closest + half};
}

template <int D>
double straight(const Vector<D>& x, const Vector<D>& v, double reach) {
  if (!(x.dot(v) < 0)) return kNever;
  const double distance = x.norm();
  if (distance <= reach) return 0;
  const Window inside = time_within<D>(x, v, reach);
  // The product of both roots over the later one, which does not cancel close to the obstacle.
  return inside.empty() ? kNever : (distance - reach) * (distance + reach) / (v.squaredNorm() * inside.to);
}

/// A flight through one window of time. Half the slope of the squared distance is a cubic; its own slope, a quadratic,
/// gives the nodes between which it is monotone.
template <int D>
double meeting_within(const Vector<D>& x, const Vector<D>& v, const Vector<D>& g, double reach, double end) {
  const auto place = [&](double t) { return Vector<D>(x + t * (v + 0.5 * t * g)); };
  const double square = g.squaredNorm();
  const Window turns = time_below(v.squaredNorm() + x.dot(g), 3 * v.dot(g), 3 * square);
  double nodes[4] = {turns.from, turns.to};
  const std::size_t count = closed_nodes(nodes, turns.empty() ? 0 : 2, end);
  return first_approach(
      [&](double t) {
        const double r = place(t).norm();
        return 0.5 * (r - reach) * (r + reach);
      },
      [&](double t) { return place(t).dot(v + t * g); },
      [&](double t) { return (v + t * g).squaredNorm() + place(t).dot(g); }, {nodes, count});
}

/// The times, one or two windows, at which a falling point is no farther than `reach` from the obstacle both along g and
/// across it. In them it is close: the quartic is solved with the numbers of there.
template <int D>
double falling(const Vector<D>& x, const Vector<D>& v, const Vector<D>& g, double reach) {
  const double strength = g.norm();
  const Vector<D> down = g / strength;
  const double height = x.dot(down), speed = v.dot(down);
  const double margin = reach * (1 + 1e-9);
  const Window near =
      common({0, kNever}, common(time_below(height - margin, speed, strength),
                                 time_within<D>(x - height * down, v - speed * down, margin)));
  if (near.empty()) return kNever;
  const Window above = time_below(height + margin, speed, strength);
  const Window rising{near.from, std::min(near.to, above.from)},
      sinking{std::max(near.from, above.to), near.to};
  const bool split = !above.empty();
  for (const Window& window : {split ? rising : near, split ? sinking : kNoWindow}) {
    if (window.empty() || !std::isfinite(window.to)) continue;
    const double t = window.from;
    const double event =
        meeting_within<D>(x + t * (v + 0.5 * t * g), v + t * g, g, reach, window.to - window.from);
    if (event < kNever) return t + event;
  }
  return kNever;
}

}  // namespace

template <int D>
double time_to_obstacle(const Vector<D>& x, const Vector<D>& v, const Vector<D>& g, double reach) {
  SANDGLASS_EXPECT(!x.hasNaN() && !v.hasNaN() && !g.hasNaN() && reach > 0);
  // Below 1e-154 the square of gravity is not a normal number any more.
  return g.squaredNorm() >= std::numeric_limits<double>::min() ? falling<D>(x, v, g, reach)
                                                               : straight<D>(x, v, reach);
}

template double time_to_obstacle<2>(const Vector<2>&, const Vector<2>&, const Vector<2>&, double);
template double time_to_obstacle<3>(const Vector<3>&, const Vector<3>&, const Vector<3>&, double);

}  // namespace sandglass
