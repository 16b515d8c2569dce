#include "validation/check/impact_fit.hpp"

#include "sim/base/error.hpp"
#include "validation/law/impact.hpp"

#include <cmath>
#include <numeric>

namespace sandglass {

namespace {
// The fit runs in s = -ln(1 - c), in which the likelihood is smooth: c = 1 - e^(-s).
constexpr double kLow = -4.61512, kHigh = 14;

struct Likelihood {
  int dimension;
  std::span<const double> edges, counts;

  double operator()(double s) const {
    const double c = -std::expm1(-s);
    double sum = 0, below = law::impact_cumulative(dimension, c, edges[0]);
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const double next = law::impact_cumulative(dimension, c, edges[i + 1]);
      if (counts[i] > 0) sum += counts[i] * std::log(next - below);
      below = next;
    }
    return sum;
  }

  double bend(double s) const {
    constexpr double h = 1e-3;
    return ((*this)(s + h) - 2 * (*this)(s) + (*this)(s - h)) / (h * h);
  }
};

/// Golden sections: the likelihood has one maximum.
double highest_of(const Likelihood& likelihood) {
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double low = kLow, high = kHigh;
  while (high - low > 1e-7) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    (likelihood(left) > likelihood(right) ? high : low) = likelihood(left) > likelihood(right) ? right : left;
  }
  return (low + high) / 2;
}
}  // namespace

Mean fit_impact_coefficient(int dimension, std::span<const double> edges, std::span<const double> counts) {
  SANDGLASS_EXPECT(edges.size() == counts.size() + 1);
  const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
  if (counts.size() < 2 || !(total > 0))
    throw InputError("no collisions to fit an impact distribution to: run longer, two bins or more");
  const Likelihood likelihood{dimension, edges, counts};
  const double s = highest_of(likelihood);
  if (s < kLow + 1e-3 || s > kHigh - 1e-3)
    throw InputError(
        "the impact parameters lie at one end of their range: a/(1 - c b^2) does not describe them");
  Mean fit;
  fit.value = -std::expm1(-s);
  fit.standard_error = std::exp(-s) / std::sqrt(-likelihood.bend(s));
  fit.effective_samples = total;
  return fit;
}

}  // namespace sandglass
