#pragma once

#include <array>

// Balls in a row that move along it only. Masses from left to right; r is the normal restitution of every pair.

namespace sandglass::law {

/// The outer two masses as the middle one sees them: m1 m3/((m1 + m2)(m2 + m3)), 1/4 for equal masses.
double row_coupling(const std::array<double, 3>& masses);

/// Largest restitution at which three balls can collide infinitely often: with a_n = (1+r) m/(m + m_middle) in turn for
/// the left and the right ball, the approach speeds follow w_{n+1} = a_n w_n - r w_{n-1}, which stays positive for ever
/// if (1+r)^2 c >= 4 r, c the coupling: (1 - s)/(1 + s), s = sqrt(1 - c). Equal masses: 7 - 4 sqrt(3) (Constantin,
/// Grossman & Mungan 1995; McNamara & Young 1992).
double collapse_restitution(const std::array<double, 3>& masses);

/// Most collisions that three balls can make, pi/arccos(sqrt(c/r) (1+r)/2) rounded up: then the phase of the solution
/// r^(n/2) sin(n phi + d) has passed half a turn. Infinite up to the restitution of collapse; elastic: Galperin 2003.
double most_collisions(const std::array<double, 3>& masses, double restitution);

/// Velocities and number of collisions when all is over, by the two collision matrices in turn. The left pair
/// starts; the right pair must not collide before.
struct RowResult {
  std::array<double, 3> velocities;
  double collisions;  ///< infinite when it never ends; the velocities are then those of the limit
};
RowResult three_in_a_row(const std::array<double, 3>& masses, double restitution,
                         std::array<double, 3> velocities);

/// Speed of ball k = 0, 1, ... of a row of equal ones at rest when a ball with `speed` has hit the first and the blow has
/// come to k: speed ((1+r)/2)^k. It holds as long as no ball from behind has caught up.
double cradle_speed(int balls_passed, double restitution, double speed);

}  // namespace sandglass::law
