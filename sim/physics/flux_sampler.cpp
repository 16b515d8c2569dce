#include "sim/physics/flux_sampler.hpp"

#include "sim/base/maxwellian_flux.hpp"

#include <cmath>

#include <boost/random/normal_distribution.hpp>

namespace sandglass {

namespace {
/// Positive root of 2 x (x - s) = 1; far up the stream s itself, to the last digit.
double mode_of(double ratio) { return ratio < 1e8 ? (ratio + std::sqrt(ratio * ratio + 2)) / 2 : ratio; }
}  // namespace

FluxSampler::FluxSampler(double stream, double thermal)
    : stream_(stream), thermal_(thermal), ratio_(stream / (M_SQRT2 * thermal)), mode_(mode_of(ratio_)) {}

double FluxSampler::operator()(Random& random) const {
  if (!(thermal_ > 0)) return stream_;
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

double FluxSampler::rate() const { return maxwellian_flux(stream_, thermal_); }

template <int D>
Vector<D> StreamFlux<D>::operator()(Random& random) const {
  boost::random::normal_distribution<double> normal;
  Vector<D> velocity = stream_;
  velocity[axis_] = direction_ * normal_(random);
  for (int axis = 0; axis < D; ++axis)
    if (axis != axis_) velocity[axis] += thermal_ * normal(random);
  return velocity;
}

template class StreamFlux<2>;
template class StreamFlux<3>;

}  // namespace sandglass
