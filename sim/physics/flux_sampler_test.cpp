#include "sim/physics/flux_sampler.hpp"

#include "sim/base/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

// The density W exp(-(W - U)^2 / (2 thermal^2)) on W > 0, integrated numerically, is the slow twin.

namespace sandglass {
namespace {

constexpr double kThermal = 1.7;
/// In thermal speeds; -0.71 is where the sampler changes its way.
constexpr double kStreams[] = {-5, -2, -0.75, -0.65, 0, 0.5, 2, 5};

class FluxDensity {
 public:
  explicit FluxDensity(double stream) : stream_(stream), cumulated_(kPoints + 1), step_(upper() / kPoints) {
    for (int i = 0; i < kPoints; ++i) cumulated_[index(i + 1)] = cumulated_[index(i)] + simpson(i * step_, 0);
  }
  double upper() const { return std::max(0.0, stream_) + 9 * kThermal; }
  double total() const { return cumulated_.back(); }
  double moment(int order) const {
    double sum = 0;
    for (int i = 0; i < kPoints; ++i) sum += simpson(i * step_, order);
    return sum / total();
  }
  /// Velocity below which this part of the distribution lies.
  double quantile(double part) const {
    const auto above = std::upper_bound(cumulated_.begin(), cumulated_.end(), part * total());
    const auto low = static_cast<double>(above - cumulated_.begin() - 1);
    return step_ * (low + (part * total() - *(above - 1)) / (*above - *(above - 1)));
  }

 private:
  static constexpr int kPoints = 40000;
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  double density(double w, int order) const {
    const double u = (w - stream_) / kThermal;
    return std::pow(w, order + 1) * std::exp(-0.5 * u * u);
  }
  double simpson(double from, int order) const {
    return step_ / 6 *
           (density(from, order) + 4 * density(from + step_ / 2, order) + density(from + step_, order));
  }

  double stream_;
  std::vector<double> cumulated_;
  double step_;
};

std::vector<double> draw(double stream, int count) {
  const FluxSampler sampler(stream, kThermal);
  Random random(StreamKey(2, Purpose::crossings, 0, 0), 0);
  std::vector<double> samples(static_cast<std::size_t>(count));
  for (double& sample : samples) sample = sampler(random);
  return samples;
}

TEST(FluxSampler, HasTheMomentsOfItsDensity) {
  for (double ratio : kStreams) {
    const FluxDensity density(ratio * kThermal);
    std::vector<double> samples = draw(ratio * kThermal, 200'000);
    const Mean mean = mean_of_independent(samples);
    EXPECT_NEAR(mean.value, density.moment(1), 4.5 * mean.standard_error) << "U/thermal " << ratio;
    for (double& sample : samples) sample *= sample;
    const Mean square = mean_of_independent(samples);
    EXPECT_NEAR(square.value, density.moment(2), 4.5 * square.standard_error) << "U/thermal " << ratio;
  }
}

/// 50 bins of equal probability: 49 degrees of freedom, standard deviation 9.9.
TEST(FluxSampler, HasItsDensity) {
  constexpr int kBins = 50, kDraws = 200'000;
  for (double ratio : kStreams) {
    const FluxDensity density(ratio * kThermal);
    std::vector<double> edges;
    for (int i = 1; i < kBins; ++i) edges.push_back(density.quantile(static_cast<double>(i) / kBins));
    std::vector<double> count(kBins);
    for (double velocity : draw(ratio * kThermal, kDraws)) {
      ASSERT_GT(velocity, 0);
      ++count[static_cast<std::size_t>(std::upper_bound(edges.begin(), edges.end(), velocity) -
                                       edges.begin())];
    }
    double chi = 0;
    for (double n : count) chi += std::pow(n - kDraws / kBins, 2) / (kDraws / kBins);
    EXPECT_LT(chi, 49 + 5 * 9.9) << "U/thermal " << ratio;
    EXPECT_GT(chi, 49 - 4 * 9.9) << "U/thermal " << ratio;
  }
}

TEST(FluxSampler, RateIsTheIntegralOfTheDensity) {
  for (double ratio : kStreams) {
    const double integral = FluxDensity(ratio * kThermal).total() / (std::sqrt(2 * M_PI) * kThermal);
    EXPECT_NEAR(FluxSampler(ratio * kThermal, kThermal).rate() / integral, 1, 1e-8) << "U/thermal " << ratio;
  }
}

TEST(FluxSampler, RatesOfBothSidesDifferByTheStream) {
  const double up = FluxSampler(0.8, kThermal).rate(), down = FluxSampler(-0.8, kThermal).rate();
  EXPECT_NEAR(up - down, 0.8, 1e-14);
}

}  // namespace
}  // namespace sandglass
