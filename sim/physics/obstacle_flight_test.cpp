#include "sim/physics/obstacle_flight.hpp"

#include "sim/base/random.hpp"
#include "sim/physics/collision.hpp"
#include "sim/physics/first_approach.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::obstacle_flight_test {
namespace {

Random stream(std::uint64_t index) { return {StreamKey(42, Purpose::collisions, 0, 0), index}; }
double between(Random& random, double low, double high) { return low + (high - low) * random.uniform(); }
double over_decades(Random& random, double low, double high) {
  return std::pow(10, between(random, low, high));
}

template <int D>
struct Flight {
  Vector<D> x, v, g;
  double reach;

  double event() const { return time_to_obstacle<D>(x, v, g, reach); }
  Vector<D> at(double t) const { return x + t * (v + 0.5 * t * g); }
  double gap(double t) const { return at(t).norm() - reach; }
  double slope(double t) const { return at(t).dot(v + t * g); }
  /// What rounding makes of the gap at time t.
  double digits(double t) const { return 4e-15 * (reach + x.norm() + t * v.norm() + t * t * g.norm()); }
  /// Upper bound of the time at which it can still be near.
  double horizon() const {
    return g.norm() > 0 ? 2 * v.norm() / g.norm() + std::sqrt(4 * (x.norm() + 2 * reach) / g.norm())
                        : 2 * x.norm() / v.norm();
  }
};

/// Slow twin: walks up to the event, or the horizon if there is none, and must find the gap open all the way.
template <int D>
void expect_first_meeting(const Flight<D>& flight, int steps) {
  const double event = flight.event();
  ASSERT_GE(event, 0);
  const double end = std::min(event, flight.horizon());
  const bool overlap = flight.gap(0) <= 0;
  for (int i = 1; i < steps; ++i) {
    const double t = end * i / steps;
    if (overlap && flight.slope(t) > 0) continue;
    ASSERT_GT(flight.gap(t), -flight.digits(t)) << "missed at " << t << " before " << event;
  }
  if (event == kNever || (overlap && event == 0)) return;
  const double shift = (flight.v + event * flight.g).norm() * 1e-15 * event;
  EXPECT_LT(std::fabs(flight.gap(event)), flight.digits(event) + shift);
  EXPECT_LT(flight.slope(event),
            (flight.digits(event) + shift) * (flight.v + event * flight.g).norm() + 1e-12);
}

template <int D>
Flight<D> any_flight(Random& random, double gravity) {
  const double reach = over_decades(random, -1, 1), distance = reach * (1 + over_decades(random, -3, 1));
  return {distance * uniform_direction<D>(random), over_decades(random, -1, 1) * uniform_direction<D>(random),
          gravity * uniform_direction<D>(random), reach};
}

template <int D>
void expect_random_flights(std::uint64_t index) {
  Random random = stream(index);
  int met = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Flight<D> flight = any_flight<D>(random, trial % 4 ? over_decades(random, -2, 2) : 0);
    expect_first_meeting<D>(flight, 1000);
    met += flight.event() < kNever;
  }
  EXPECT_GT(met, 200);
  EXPECT_LT(met, 1800);
}
TEST(TimeToObstacle, OfRandomFlightsIsTheFirst) {
  expect_random_flights<2>(0);
  expect_random_flights<3>(1);
}

TEST(TimeToObstacle, OfRandomFlightsIsTheFirstOnAFineScale) {
  Random random = stream(2);
  for (int trial = 0; trial < 2; ++trial) {
    expect_first_meeting<2>(any_flight<2>(random, 1), 1'000'000);
    expect_first_meeting<3>(any_flight<3>(random, 1), 1'000'000);
  }
}

/// Gravity that hardly bends the flight, or bends it at once.
template <int D>
void expect_extreme_gravity(std::uint64_t index) {
  Random random = stream(index);
  for (int trial = 0; trial < 2000; ++trial) {
    Flight<D> flight = any_flight<D>(random, over_decades(random, 3, 12));
    expect_first_meeting<D>(flight, 200);
    flight.g = over_decades(random, -300, -20) * uniform_direction<D>(random);
    Flight<D> straight = flight;
    straight.g.setZero();
    const double bent = flight.event(), expected = straight.event();
    if (expected < kNever) {
      EXPECT_NEAR(bent, expected, 1e-12 * (1 + expected) * flight.reach);
    } else {
      EXPECT_GT(bent, 1e6);  // it may come back after ages
    }
  }
}
TEST(TimeToObstacle, UnderExtremeGravityIsTheFirst) {
  expect_extreme_gravity<2>(3);
  expect_extreme_gravity<3>(4);
}

/// Flown backwards from the point that it is to touch, with the obstacle a little larger or smaller: it hits then, or
/// passes. `bend` is the second derivative of half the squared distance.
template <int D>
void expect_grazing(std::uint64_t index, double distance) {
  Random random = stream(index);
  for (int trial = 0; trial < 1000; ++trial) {
    const Vector<D> normal = uniform_direction<D>(random), any = uniform_direction<D>(random);
    const Vector<D> w = (any - any.dot(normal) * normal).normalized();
    const Vector<D> g = over_decades(random, -1, 1) * uniform_direction<D>(random);
    const double bend = 1 + normal.dot(g), back = distance * (0.5 + random.uniform());
    if (bend < 0.1) continue;  // would touch from inside
    const auto flight = [&](double reach) {
      return Flight<D>{normal - back * w + 0.5 * back * back * g, w - back * g, g, reach};
    };
    const Flight<D> hit = flight(1 + 1e-8), miss = flight(1 - 1e-8);
    if (hit.gap(0) <= 0) continue;
    EXPECT_LT(hit.event(), back);
    if (hit.event() > back - 0.01) {
      const double next_order = 1e-8 * g.norm() / (bend * bend);
      EXPECT_NEAR(hit.event(), back - std::sqrt(2e-8 / bend), 3 * next_order + 1e-8);
      EXPECT_GT(std::fabs(miss.event() - back), 0.001);
    }
    expect_first_meeting<D>(hit, 500);
    expect_first_meeting<D>(miss, 500);
  }
}
TEST(TimeToObstacle, Grazes) {
  expect_grazing<2>(5, 1);
  expect_grazing<3>(6, 1);
  expect_grazing<2>(7, 30);
  expect_grazing<3>(8, 30);
}

/// Just after a bounce: touching, or overlapping by the last digit.
template <int D>
void expect_after_bounce(std::uint64_t index) {
  Random random = stream(index);
  for (int trial = 0; trial < 2000; ++trial) {
    const Vector<D> normal = uniform_direction<D>(random);
    Flight<D> flight{(1 - (trial % 2) * 1e-16) * normal,
                     over_decades(random, -8, 1) * uniform_direction<D>(random), uniform_direction<D>(random),
                     1};
    if (flight.v.dot(normal) < 0) flight.v -= 2 * flight.v.dot(normal) * normal;
    if (flight.v.dot(normal) < 0.01 * flight.v.norm()) continue;
    EXPECT_GT(flight.event(), 0.1 * flight.v.dot(normal));
    expect_first_meeting<D>(flight, 300);
    flight.v = -flight.v;
    if (flight.gap(0) <= 0) {
      EXPECT_EQ(flight.event(), 0);
    }
  }
}
TEST(TimeToObstacle, AfterABounceIsTheNext) {
  expect_after_bounce<2>(9);
  expect_after_bounce<3>(10);
}

/// Up to a million radii away: the place is known to 1e-10 of a radius.
TEST(TimeToObstacle, FromFarAway) {
  Random random = stream(11);
  for (int trial = 0; trial < 1000; ++trial) {
    const Vector<2> point = uniform_direction<2>(random);
    const Vector<2> w = -over_decades(random, 0, 2) * point, g = uniform_direction<2>(random);
    const double back = 1e3;
    const Flight<2> flight{point - back * w + 0.5 * back * back * g, w - back * g, g, 1};
    EXPECT_LT(flight.event(), back + 1e-9);
    expect_first_meeting<2>(flight, 1000);
  }
}

}  // namespace
}  // namespace sandglass::obstacle_flight_test
