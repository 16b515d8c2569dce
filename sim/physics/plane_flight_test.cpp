#include "sim/physics/plane_flight.hpp"

#include "sim/base/random.hpp"
#include "sim/physics/first_approach.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::plane_flight_test {
namespace {

Random stream(std::uint64_t index) { return {StreamKey(41, Purpose::collisions, 0, 0), index}; }
double between(Random& random, double low, double high) { return low + (high - low) * random.uniform(); }
double over_decades(Random& random, double low, double high) {
  return std::pow(10, between(random, low, high));
}

double gap_at(const Arc& particle, const PlaneMotion& plane, double t) {
  return particle.at(t) - plane.at(t);
}
double slope_at(const Arc& particle, const PlaneMotion& plane, double t) {
  return particle.speed_at(t) - plane.velocity_at(t);
}
/// What rounding makes of the gap at time t.
double digits(const Arc& arc, const PlaneMotion& plane, double t) {
  const double phase = std::fabs(plane.amplitude) * (1 + plane.angular_frequency() * t);
  return 4e-15 *
         (std::fabs(arc.place) + std::fabs(plane.position) +
          t * (std::fabs(arc.speed) + std::fabs(plane.speed)) + std::fabs(arc.acceleration) * t * t + phase);
}

/// Slow twin: walks up to the event, or `horizon` if there is none, and must find the gap open all the way.
void expect_first_meeting(const Arc& particle, const PlaneMotion& plane, double horizon, int steps) {
  const double event = time_to_plane(particle, plane);
  ASSERT_GE(event, 0);
  const bool now = gap_at(particle, plane, 0) <= 0;
  const double end = std::min(event, horizon);
  for (int i = 1; i < steps; ++i) {
    const double t = end * i / steps, gap = gap_at(particle, plane, t);
    if (now && slope_at(particle, plane, t) > 0) continue;  // an overlap that shrinks
    ASSERT_GT(gap, -digits(particle, plane, t)) << "missed at " << t << " before " << event;
  }
  if (event == kNever || (now && event == 0)) return;
  const double shift = std::fabs(slope_at(particle, plane, event)) * 4e-16 * event;
  EXPECT_LT(gap_at(particle, plane, event), digits(particle, plane, event) + shift);
}

/// Starts outside the plane, at any scale of vibration.
PlaneMotion any_plane(Random& random) {
  return {between(random, -1, 1), between(random, -1, 1), over_decades(random, -4, 0.5),
          over_decades(random, -2, 2.5), between(random, -3, 3)};
}

TEST(TimeToPlane, OfRandomFlightsIsTheFirst) {
  Random random = stream(0);
  int met = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const PlaneMotion plane = any_plane(random);
    const Arc arc{plane.at(0) + over_decades(random, -6, 1), between(random, -2, 2), between(random, -2, 2)};
    expect_first_meeting(arc, plane, 20, 2000);
    met += time_to_plane(arc, plane) < kNever;
  }
  EXPECT_GT(met, 1000);
  EXPECT_LT(met, 2900);
}

TEST(TimeToPlane, OfRandomFlightsIsTheFirstOnAFineScale) {
  Random random = stream(1);
  for (int trial = 0; trial < 4; ++trial) {
    const PlaneMotion plane = any_plane(random);
    const Arc arc{plane.at(0) + over_decades(random, -3, 0.5), between(random, -2, 0), -1};
    expect_first_meeting(arc, plane, 20, 1'000'000);
  }
}

/// After a bounce the particle touches, or overlaps by the last digit, and leaves; then gravity brings it back.
TEST(TimeToPlane, AfterABounceIsTheNext) {
  Random random = stream(2);
  for (int trial = 0; trial < 3000; ++trial) {
    const PlaneMotion plane = any_plane(random);
    const double leaving = over_decades(random, -6, 1);
    const Arc arc{plane.at(0) - (trial % 2) * 1e-16, plane.velocity_at(0) + leaving, -1};
    const double next = time_to_plane(arc, plane);
    ASSERT_LT(next, kNever);
    // Its slope must change sign first.
    const double strongest = 1 + plane.amplitude * std::pow(plane.angular_frequency(), 2);
    EXPECT_GT(next, 0.99 * leaving / strongest);
    expect_first_meeting(arc, plane, 20, 500);
  }
}

/// At constant speed towards the crests of a plane: the level of a crest, give or take a billionth of the amplitude.
TEST(TimeToPlane, GrazesTheCrests) {
  for (const double amplitude : {1e-9, 1e-3, 1.0})
    for (const double frequency : {0.3, 50.0, 1e6}) {
      const PlaneMotion plane{0, 0, amplitude, frequency, 0.3};
      const double crest = (0.25 - 0.3 / (2 * M_PI)) / frequency;
      EXPECT_EQ(time_to_plane({amplitude * (1 + 1e-9), 0, 0}, plane), kNever);
      // 1 - cos x = 1e-9: half the width of the crest above the level.
      EXPECT_NEAR(time_to_plane({amplitude * (1 - 1e-9), 0, 0}, plane),
                  crest - std::sqrt(2e-9) / (2 * M_PI * frequency), 1e-10 / frequency);
    }
}

/// Against a plane that hardly moves it falls as on a fixed one.
TEST(TimeToPlane, WithoutAmplitudeOrFrequencyIsAParabola) {
  const Arc arc{3, 1, -2};  // 3 + t - t^2
  const double expected = (1 + std::sqrt(13)) / 2;
  EXPECT_NEAR(time_to_plane(arc, {}), expected, 1e-15);
  EXPECT_NEAR(time_to_plane(arc, {1, 0, -1, 0, M_PI / 2}), expected, 1e-15);
  EXPECT_NEAR(time_to_plane(arc, {0, 0, 1e-15, 1e3, 0}), expected, 1e-14);
  EXPECT_NEAR(time_to_plane(arc, {0, 0, 1, 1e-15, 0}), expected, 1e-13);
}

TEST(TimeToPlane, TouchingAndApproachingIsNow) {
  const PlaneMotion rising{1, 0, 0.5, 1, 0}, sinking{1, 0, 0.5, 1, M_PI};
  EXPECT_EQ(time_to_plane({1, 0, 0}, rising), 0);
  EXPECT_EQ(time_to_plane({0.9, 3, 0}, rising), 0);       // overlaps, slower than the plane: pi
  EXPECT_EQ(time_to_plane({0.9, 4, 0}, rising), kNever);  // faster
  EXPECT_GT(time_to_plane({1, 0, 0}, sinking), 0.4);      // waits for its return
  EXPECT_LT(time_to_plane({1, 0, 0}, sinking), 0.6);
}

/// Deep below and rising for many periods: nothing until it slows down or comes out and falls back.
TEST(TimeToPlane, DeepBelowWaits) {
  const PlaneMotion plane{0, 0, 1e-3, 1, 0};
  EXPECT_EQ(time_to_plane({-50, 1, 0}, plane), kNever);
  EXPECT_NEAR(time_to_plane({-50, 2, -0.01}, plane), (2 + std::sqrt(3)) / 0.01, 1);
  EXPECT_NEAR(time_to_plane({-500, 1, -0.01}, plane), 100, 2);
  // Its speed falls below the plane's, 2 pi, at 372, long before it turns at 1000.
  EXPECT_NEAR(time_to_plane({-1e5, 10, -0.01}, {0, 0, 1, 1, 0}), 372, 0.05);
}

TEST(TimeToPlane, IsFiniteOrNeverAtExtremes) {
  for (const double place : {1e-300, 1.0, 1e150})
    for (const double speed : {-1e150, -1e-300, 0.0, 1e-300})
      for (const double acceleration : {-1e100, -1e-300, 0.0, 1e-300})
        for (const double frequency : {1e-200, 1.0, 1e100}) {
          const double event = time_to_plane({place, speed, acceleration}, {0, 0, 1e-5, frequency, -1});
          EXPECT_GE(event, 0) << place << ' ' << speed << ' ' << acceleration << ' ' << frequency;
        }
}

TEST(TimeToFall, OfAParabola) {
  EXPECT_NEAR(time_to_fall({1, -2, 0}), 0.5, 1e-16);
  EXPECT_EQ(time_to_fall({1, 2, 0}), kNever);
  EXPECT_NEAR(time_to_fall({3, -4, 2}), 1, 1e-15);  // (t - 1)(t - 3)
  EXPECT_EQ(time_to_fall({5, -4, 2}), kNever);
  EXPECT_NEAR(time_to_fall({0, 1, -2}), 1, 1e-16);
  EXPECT_EQ(time_to_fall({0, -1, 2}), 0);
  EXPECT_EQ(time_to_fall({-1, 1, 0}), kNever);
  EXPECT_EQ(time_to_fall({-1, 1, -2}), 0.5);  // turns below
  EXPECT_EQ(time_to_fall({0, 0, 0}), kNever);
  EXPECT_NEAR(time_to_fall({1, -1e-9, 1e-30}), 1e9, 1e-3);
}

}  // namespace
}  // namespace sandglass::plane_flight_test
