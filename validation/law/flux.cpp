#include "validation/law/flux.hpp"

// A stream away from the plane (s = -x, x > 0) makes every quantity a small difference of large terms. With
// K(x) defined by sqrt(pi) exp(x^2) erfc(x) = 1/(x + K), they become products: f(-x) = exp(-x^2) K/(x + K).

namespace sandglass::law {

namespace {
constexpr double kRootPi = 1 / std::numbers::inv_sqrtpi;

/// (k/2)/(x + ((k+1)/2)/(x + ...)) from k = first; 60 levels reach rounding for x >= 2.
double continued_fraction(double x, int first) {
  double tail = 0;
  for (int level = 60; level >= first; --level) tail = 0.5 * level / (x + tail);
  return tail;
}

/// K(x), x >= 0: the continued fraction (Laplace) from k = 1.
double mills_remainder(double x) {
  return x < 2 ? 1 / (kRootPi * std::exp(x * x) * std::erfc(x)) - x : continued_fraction(x, 1);
}

/// Mean of w for the density 2 w exp(-(w-s)^2)/f(s), s = -x: the continued fraction from k = 2.
double mean_against_stream(double x) {
  return x < 2 ? 0.5 / mills_remainder(x) - x : continued_fraction(x, 2);
}

/// exp(min(t,0)^2) f(t): the factor that underflows is left to the caller.
double scaled_f(double t) {
  if (t >= 0) return std::exp(-t * t) + kRootPi * t * std::erfc(-t);
  const double remainder = mills_remainder(-t);
  return remainder / (remainder - t);
}

double rate_constant(const Stream& stream) { return std::sqrt(stream.mass / (2 * stream.temperature)); }

Stream mirrored(Stream stream) {
  stream.velocity = -stream.velocity;
  return stream;
}

/// Probability that w > y >= 0 for the density 2 w exp(-(w-s)^2)/f(s).
double survival(double s, double y) {
  if (s >= 0) {
    const double distance = s - y;
    return (std::exp(-distance * distance) + kRootPi * s * std::erfc(-distance)) / scaled_f(s);
  }
  const double edge = y - s;
  const double remainder = mills_remainder(edge);
  return std::exp(y * (2 * s - y)) * (y + remainder) / (edge + remainder) / scaled_f(s);
}
}  // namespace

double flux_forward(const Stream& stream) {
  const double root = rate_constant(stream);
  const double s = root * stream.velocity;
  const double faded = s < 0 ? std::exp(-s * s) : 1;
  return stream.number_density / (2 * kRootPi * root) * faded * scaled_f(s);
}

double flux_backward(const Stream& stream) { return flux_forward(mirrored(stream)); }

double flux_net(const Stream& stream) { return stream.number_density * stream.velocity; }

double flux_density_forward(const Stream& stream, double velocity) {
  if (velocity <= 0) return 0;
  const double root = rate_constant(stream);
  const double s = root * stream.velocity;
  const double w = root * velocity;
  const double exponent = s < 0 ? w * (2 * s - w) : -(w - s) * (w - s);
  return 2 * root * w * std::exp(exponent) / scaled_f(s);
}

double flux_density_backward(const Stream& stream, double velocity) {
  return flux_density_forward(mirrored(stream), -velocity);
}

double flux_cumulative_forward(const Stream& stream, double velocity) {
  if (velocity <= 0) return 0;
  const double root = rate_constant(stream);
  return 1 - survival(root * stream.velocity, root * velocity);
}

double flux_cumulative_backward(const Stream& stream, double velocity) {
  if (velocity >= 0) return 1;
  const double root = rate_constant(stream);
  return survival(-root * stream.velocity, -root * velocity);
}

double flux_mean_forward(const Stream& stream) {
  const double root = rate_constant(stream);
  const double s = root * stream.velocity;
  if (s < 0) return mean_against_stream(-s) / root;
  return (s + kRootPi / 2 * std::erfc(-s) / scaled_f(s)) / root;
}

double flux_mean_backward(const Stream& stream) { return -flux_mean_forward(mirrored(stream)); }

}  // namespace sandglass::law
