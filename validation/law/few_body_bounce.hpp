#pragma once

#include <optional>

// A ball that falls on a flat floor, along one line, and on a floor that vibrates. Heights are those of the lowest point
// of the ball, so that contact is at the height of the floor.

namespace sandglass::law {

struct BouncingBall {
  double gravity = 1;               ///< downwards, > 0
  double height = 1, velocity = 0;  ///< at time zero; upwards is positive
  double restitution = 1;           ///< of the floor
  double reference_speed = 0;  ///< r(v) = 1 - (1 - r)(v/v0)^(3/4) below v0 (Bizon et al. 1998); 0: constant
};

/// State between two bounces: how many there have been, height and velocity.
struct BounceState {
  double bounces = 0, height = 0, velocity = 0;
  double since = 0;  ///< time since the last bounce, or since zero
  double left = 0;   ///< time to the next one
};

/// Time of the n-th bounce, n >= 1, with constant restitution: t_1 + 2 v_1 (r + r^2 + ... + r^(n-1))/g.
double bounce_time(const BouncingBall& ball, int n);
/// Speed at the n-th impact, r^(n-1) sqrt(v^2 + 2 g h).
double bounce_speed(const BouncingBall& ball, int n);
/// When infinitely many bounces are over: t_1 + 2 v_1 r/(g (1-r)). Infinite for an elastic floor.
double accumulation_time(const BouncingBall& ball);
/// By adding flight to flight, for either restitution. Throws InputError at or after the accumulation time.
BounceState bouncing_ball(const BouncingBall& ball, double time);

/// A ball on a floor at A sin(2 pi f t) that bounces once a period: each flight takes T = 1/f and comes back to the height
/// where it began, so that it leaves with g T/2 and arrives with -g T/2, and the floor must make up the loss by its speed
/// V = (g T/2) (1-r)/(1+r) = 2 pi f A cos(phi) (Holmes 1982; Tufillaro & Albano 1986).
struct VibratedBall {
  double gravity = 1, amplitude = 0.1, frequency = 1, restitution = 0.5;
};

/// Phase 2 pi f t of the bounce on the branch that can be stable, from 0 to pi/2. Nothing when the floor is too slow.
std::optional<double> bounce_phase(const VibratedBall& ball);
/// Downward acceleration of the floor at the bounce over the largest at which the orbit is stable, 2 g (1+r^2)/(1+r)^2.
/// The linear map of the time and speed of a bounce has determinant r^2 and trace 1 + r^2 - (1+r)^2 a/g; both eigenvalues
/// lie within the unit circle for a from 0 to that bound, without the high-bounce approximation. Stable: 0 to 1.
double orbit_acceleration_ratio(const VibratedBall& ball);
/// Larger modulus of those eigenvalues: what a deviation is multiplied with from bounce to bounce.
double orbit_contraction(const VibratedBall& ball);
/// Height and velocity at a time, on the orbit that bounces at times (n + phi/2 pi)/f.
BounceState period_one_orbit(const VibratedBall& ball, double time);

}  // namespace sandglass::law
