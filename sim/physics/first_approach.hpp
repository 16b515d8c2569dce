#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace sandglass {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Root of a monotone function with values of opposite sign at the ends of [low, high]: Newton's step, halving where that
/// leaves the bracket or gains too little.
template <class Function, class Derivative>
double monotone_root(Function function, Derivative derivative, double low, double high) {
  const bool rises = function(low) < 0;
  double t = 0.5 * (low + high), last = high - low;
  for (;;) {
    const double value = function(t);
    if (value == 0) return t;
    ((value < 0) == rises ? low : high) = t;
    double next = t - value / derivative(t);
    // The first comparison catches a step that is no number, too.
    if (!(next > low && next < high) || std::fabs(next - t) > 0.5 * last) next = 0.5 * (low + high);
    last = std::fabs(next - t);
    if (next == t || next <= low || next >= high || last <= 1e-16 * t) return next;
    t = next;
  }
}

/// Earliest time at which a gap is closed and shrinks (Bannerman, Strobl, Formella & Poeschel 2014): an overlap that
/// shrinks no further is no event, one that grows is one at once. `nodes` are ascending times between which the slope of
/// the gap is monotone; then every piece between zeros of the slope is monotone, and no root can be missed.
template <class Gap, class Slope, class Curvature>
double first_approach(Gap gap, Slope slope, Curvature curvature, std::span<const double> nodes) {
  const auto falling = [&](double from, double to) {
    if (gap(from) <= 0) return from;
    return gap(to) <= 0 ? monotone_root(gap, slope, from, to) : kNever;
  };
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const double from = nodes[i - 1], to = nodes[i], first = slope(from), last = slope(to);
    const bool turns = (first < 0 && last > 0) || (first > 0 && last < 0);
    const double turn = turns ? monotone_root(slope, curvature, from, to) : to;
    double event = kNever;
    if (turns) {
      event = first < 0 ? falling(from, turn) : falling(turn, to);
    } else if (first < 0 || last < 0) {
      event = falling(from, to);
    }
    if (event < kNever) return event;
  }
  return kNever;
}

/// Times in ascending order without those outside (0, end), closed by 0 and `end`; the answer is their number.
template <std::size_t N>
std::size_t closed_nodes(double (&times)[N], std::size_t count, double end) {
  auto last = std::remove_if(times, times + count, [=](double t) { return !(t > 0 && t < end); });
  *last++ = 0;
  *last++ = end;
  std::sort(times, last);
  return static_cast<std::size_t>(last - times);
}

}  // namespace sandglass
