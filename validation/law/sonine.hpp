#pragma once

namespace sandglass::law {

/// First Sonine coefficient of the homogeneous cooling state, van Noije & Ernst (1998):
/// f(c) = phi(c) (1 + a2 S2(c^2)). Independent of density; error O(a2^2), with
/// |a2| below 0.1 for r > 0.5 and up to 0.28 (2D, r = 0).
double sonine_a2(int dimension, double restitution);

/// a2 from the same two collisional moments with the stationarity condition linearised in the form
/// mu4/(1+a2) = (D+2) mu2, Montanero & Santos (2000): nearer to simulations for r < 0.6.
double sonine_a2_relinearised(int dimension, double restitution);

/// Collision rate over that of a Maxwellian of the same temperature: 1 - a2/16 + O(a2^2).
double sonine_collision_factor(double a2);

/// Cooling rate over that of a Maxwellian of the same temperature: 1 + 3 a2/16 + O(a2^2).
double sonine_cooling_factor(double a2);

}  // namespace sandglass::law
