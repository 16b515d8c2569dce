#pragma once

#include "validation/law/rough.hpp"

// A dilute gas that streams along a channel (Kawasaki 1986, chapter 5): its numbers, what becomes of it where it cools, and
// where it falls to the floor.

namespace sandglass::law {

/// First approximation of the viscosity of smooth hard spheres, 5 pi rho c lambda/32 with the mean speed c. (5.2)
double mean_path_viscosity(double density, double mean_speed, double mean_free_path);
/// Mean thermal speed of spheres of a most probable one, 2/sqrt(pi) times it. (5.3)
double mean_speed_of_spheres(double most_probable_speed);
/// sqrt(2 T/m), T an energy. (5.4)
double most_probable_speed(double temperature, double mass);
/// Of a stream of u most probable speeds in a channel h mean free paths high: 16 u h/(5 sqrt(pi)). (5.5)
double channel_reynolds_number(double speed_ratio, double height);
/// u sqrt(2/gamma). (5.6)
double mach_number(double speed_ratio, double heat_capacity_ratio);
/// gamma = 1 + 2/alpha, alpha degrees of freedom. (5.7)
double heat_capacity_ratio(double freedom);

/// A stream along x of rough, inelastic particles, the same at all places across.
struct CoolingStream {
  RoughGas gas;
  double mass = 1, velocity = 1;
  Temperatures temperature;   ///< where it begins
  double mean_free_path = 1;  ///< there
};

struct StreamState {
  double velocity = 0;
  Temperatures temperature;
};

/// Downstream of its beginning, without viscosity and conduction. Mass, momentum and energy pass at the same rate
/// everywhere, save what collisions take (mean field, `rough_energy_change`): with m u + T_t/u = c and T_t = u (c - m u)
///   ((D + 2)/2 c - (D + 1) m u) du/dx = omega dE_tr/(2 u),   omega ~ sqrt(T_t)/u,
/// and freedom/2 dT_r/dx = omega dE_rot/(2 u). Supersonic streams only. To first order in the mean free path over the length
/// on which it cools.
StreamState cooling_stream(const CoolingStream& stream, double distance);

/// A stream along x between a floor and a lid that are mirrors, evenly spread where gravity begins to act.
struct FallingStream {
  double mass = 1, temperature = 1, velocity = 1;
  double gravity = 1, height = 1;
  double freedom = 6;
};

/// What it comes to: one velocity, one temperature, a barometric density. Mirrors drag nobody, so that mass, momentum and
/// energy pass every plane as they entered:
///   m u + T/u = m u_0 + T_0/u_0,
///   m u^2/2 + (alpha/2 + 1) T + m g y(T) = m u_0^2/2 + (alpha/2 + 1) T_0 + m g h/2,
/// y(T) the mean height (`mean_column_height`). The root that is reached without a shock; not a number where there is none.
StreamState falling_stream_end(const FallingStream& stream);

}  // namespace sandglass::law
