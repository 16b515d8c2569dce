#include "sim/physics/flux_sampler.hpp"

#include <cmath>

#include <boost/random/normal_distribution.hpp>

namespace sandglass {

FluxSampler::FluxSampler(double stream, double thermal)
    : stream_(stream),
      thermal_(thermal),
      ratio_(stream / (M_SQRT2 * thermal)),
      mode_((ratio_ + std::sqrt(ratio_ * ratio_ + 2)) / 2) {}

double FluxSampler::operator()(Random& random) const {
  return M_SQRT2 * thermal_ * (ratio_ > -0.5 ? forward(random) : backward(random));
}

/// With x = W / (sqrt(2) thermal) and s the ratio, ln x <= x / mode - 1 + ln mode turns x exp(-(x - s)^2) into a
/// Gaussian about the mode, since 2 mode (mode - s) = 1.
double FluxSampler::forward(Random& random) const {
  boost::random::normal_distribution<double> normal(mode_, M_SQRT1_2);
  for (;;) {
    const double x = normal(random);
    if (x > 0 && random.uniform() < x / mode_ * std::exp(1 - x / mode_)) return x;
  }
}

/// Against the stream x exp(2 s x) is a Gamma density and exp(-x^2) the acceptance.
double FluxSampler::backward(Random& random) const {
  for (;;) {
    const double x = std::log((1 - random.uniform()) * (1 - random.uniform())) / (2 * ratio_);
    if (random.uniform() < std::exp(-x * x)) return x;
  }
}

double FluxSampler::rate() const {
  const double a = stream_ / thermal_;
  return thermal_ * std::exp(-0.5 * a * a) / std::sqrt(2 * M_PI) + stream_ * 0.5 * std::erfc(-a * M_SQRT1_2);
}

}  // namespace sandglass
