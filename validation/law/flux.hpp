#pragma once

#include <cmath>
#include <numbers>

namespace sandglass::law {

/// A drifting Maxwellian gas and the velocity component normal to a plane, Baryshev (2003) sec. 3.2.1.
struct Stream {
  double number_density = 1;
  double mass = 1;
  double temperature = 1;
  double velocity = 0;  ///< mean velocity normal to the plane, of either sign
};

/// Particles per area and time that cross with W > 0 (forward) and with W < 0 (backward), both positive:
/// n/(2 sqrt(pi c)) f(+-s), f(t) = exp(-t^2) + sqrt(pi) t (1 + erf t), c = m/(2T), s = sqrt(c) U. (3.15),
/// (3.17)
double flux_forward(const Stream& stream);
double flux_backward(const Stream& stream);

/// flux_forward - flux_backward = n U. (3.19)
double flux_net(const Stream& stream);

/// Probability density of the normal velocity W of the particles that cross forward or backward; zero for
/// the other sign. (3.28), (3.29)
double flux_density_forward(const Stream& stream, double velocity);
double flux_density_backward(const Stream& stream, double velocity);

/// Probability that a crossing velocity is below `velocity`. (3.40), (3.47)
double flux_cumulative_forward(const Stream& stream, double velocity);
double flux_cumulative_backward(const Stream& stream, double velocity);

/// Mean crossing velocity: positive forward, negative backward.
double flux_mean_forward(const Stream& stream);
double flux_mean_backward(const Stream& stream);

}  // namespace sandglass::law
