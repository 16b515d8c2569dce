#pragma once

#include <Eigen/Core>

namespace sandglass::law {

/// First Sonine coefficient of the homogeneous cooling state, van Noije & Ernst (1998):
/// f(c) = phi(c) (1 + a2 S2(c^2)). Independent of density; error O(a2^2), with
/// |a2| below 0.1 for r > 0.5 and up to 0.28 (2D, r = 0).
double sonine_a2(int dimension, double restitution);

/// a2 from the same two collisional moments with the stationarity condition linearised in the form
/// mu4/(1+a2) = (D+2) mu2, Montanero & Santos (2000): nearer to simulations for r < 0.6.
double sonine_a2_relinearised(int dimension, double restitution);

/// Which form of the stationarity of <c^2j>, mu_2j = (2j/D) <c^2j> mu_2, is linearised: as it stands (van Noije & Ernst),
/// or divided by the moment (Montanero & Santos). Their distance is an error of either.
enum class Linearised { products, ratios };

/// Coefficients a2 to a_Order of f(c) = phi(c) (1 + a2 S2(c^2) + a3 S3(c^2) + ...) in the homogeneous cooling state, from
/// the moments of order 4 to 2 Order; Order 2 is the two closed forms above. The series is asymptotic: what the next
/// order, in ratios, moves at most stands below.
template <int Order>
Eigen::Vector<double, Order - 1> sonine_coefficients(int dimension, double restitution,
                                                     Linearised form = Linearised::ratios);
extern template Eigen::Vector2d sonine_coefficients<3>(int, double, Linearised);

/// Sixth moment of the speed over Maxwell's, less one: 3 a2 - a3.
inline double sonine_sixth_moment(const Eigen::Vector2d& a) { return 3 * a[0] - a[1]; }

/// Times 1 - r^2: bounds on what order 4 changes in a2 and 3 a2 - a3 of order 3 for r from 0.3 on. Below, where up to 0.0035
/// and 0.005 are reached, the two linearisations lie further apart than that.
constexpr double kNextOrderOfA2 = 0.0022, kNextOrderOfSixthMoment = 0.002;

/// Collision rate over that of a Maxwellian of the same temperature: 1 - a2/16 + O(a2^2).
double sonine_collision_factor(double a2);

/// Cooling rate over that of a Maxwellian of the same temperature: 1 + 3 a2/16 + O(a2^2).
double sonine_cooling_factor(double a2);

}  // namespace sandglass::law
