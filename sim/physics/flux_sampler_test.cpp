#include "sim/physics/flux_sampler.hpp"

#include "sim/base/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

// The density W exp(-(W - U)^2 / (2 thermal^2)) on W > 0, integrated numerically, is the slow twin.

namespace sandglass::flux_sampler_test {
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

/// Mean and error of f of `count` velocities that pass along +x or -x.
template <int D>
Mean mean_over(const StreamFlux<D>& flux, int count, double (*f)(const Vector<D>&)) {
  Random random(StreamKey(3, Purpose::inflow, 0, 0), D);
  std::vector<double> values(static_cast<std::size_t>(count));
  for (double& value : values) value = f(flux(random));
  return mean_of_independent(values);
}

double density_of(double a) { return std::exp(-a * a / 2) / std::sqrt(2 * M_PI); }
double share_below(double a) { return std::erfc(-a * M_SQRT1_2) / 2; }

/// Number, momentum and energy that a drifting Maxwellian sends through a plane, of mass and number density one. With
/// a = U/s: E[v; v > 0] = U F(a) + s f(a), E[v^2; v > 0] = (U^2 + s^2) F + U s f, E[v^3; v > 0] = (U^3 + 3 U s^2) F +
/// (U^2 + 2 s^2) s f, F and f the normal distribution and its density.
template <int D>
void expect_fluxes(double ratio) {
  const double s = kThermal, stream = M_SQRT2 * ratio * s, along = 0.6, a = stream / s;
  const double number = stream * share_below(a) + s * density_of(a);
  const double momentum = (stream * stream + s * s) * share_below(a) + stream * s * density_of(a);
  const double cube = (stream * stream * stream + 3 * stream * s * s) * share_below(a) +
                      (stream * stream + 2 * s * s) * s * density_of(a);
  for (const double direction : {1.0, -1.0}) {
    Vector<D> drift = Vector<D>::Constant(along);
    drift[0] = direction * stream;
    const StreamFlux<D> flux(drift, s, 0, direction);
    EXPECT_NEAR(flux.rate() / number, 1, 1e-9) << ratio;
    const auto expect = [&](double (*f)(const Vector<D>&), double per_particle) {
      const Mean mean = mean_over<D>(flux, 100'000, f);
      EXPECT_NEAR(mean.value, per_particle, 4.5 * mean.standard_error) << "S " << ratio << " in " << D;
    };
    expect([](const Vector<D>& v) { return std::abs(v[0]); }, momentum / number);
    expect([](const Vector<D>& v) { return v[1]; }, along);
    expect([](const Vector<D>& v) { return v.squaredNorm() / 2; },
           (cube / number + (D - 1) * (along * along + s * s)) / 2);
    expect([](const Vector<D>& v) { return static_cast<double>(v[0] > 0); }, direction > 0);
  }
}

TEST(StreamFlux, CarriesTheClosedFormsOfAMaxwellian) {
  for (const double ratio : {-3.0, -1.0, -0.4, 0.0, 0.5, 2.2567, 10.0}) {
    expect_fluxes<2>(ratio);
    expect_fluxes<3>(ratio);
  }
}

TEST(StreamFlux, OfABeamIsTheBeam) {
  Random random(StreamKey(3, Purpose::inflow, 0, 0), 0);
  const StreamFlux<3> beam({-2, 0.5, 0.25}, 0, 0, -1);
  EXPECT_EQ(beam.rate(), 2);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(beam(random), Vector<3>(-2, 0.5, 0.25));
  EXPECT_EQ(StreamFlux<3>({2, 0, 0}, 0, 0, -1).rate(), 0);
  EXPECT_EQ(StreamFlux<3>({0, 1, 0}, 0, 0, 1).rate(), 0);
}

/// As cold as numbers get, and as far against the stream: nothing overflows, and nobody moves the wrong way.
TEST(StreamFlux, HoldsForExtremeStreams) {
  for (const double thermal : {1e-300, 1e-160, 1e-9, 1e9}) {
    Random random(StreamKey(3, Purpose::inflow, 0, 1), 0);
    const StreamFlux<2> with({1, 0}, thermal, 0, 1), against({-1, 0}, thermal, 0, 1);
    EXPECT_GE(against.rate(), 0);
    EXPECT_TRUE(std::isfinite(with.rate()));
    for (int i = 0; i < 20; ++i) {
      EXPECT_GT(with(random)[0], 0);
      EXPECT_GE(against(random)[0], 0);
      EXPECT_TRUE(with(random).allFinite());
    }
  }
}

TEST(FluxSampler, RatesOfBothSidesDifferByTheStream) {
  const double up = FluxSampler(0.8, kThermal).rate(), down = FluxSampler(-0.8, kThermal).rate();
  EXPECT_NEAR(up - down, 0.8, 1e-14);
}

}  // namespace
}  // namespace sandglass::flux_sampler_test
