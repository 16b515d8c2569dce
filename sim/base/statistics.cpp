#include "sim/base/statistics.hpp"

#include "sim/base/error.hpp"

#include <cmath>
#include <limits>
#include <numeric>

namespace sandglass {

namespace {
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double plain_mean(std::span<const double> samples) {
  return std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
}

double autocovariance(std::span<const double> samples, double mean, std::size_t lag) {
  double sum = 0;
  for (std::size_t i = lag; i < samples.size(); ++i) sum += (samples[i] - mean) * (samples[i - lag] - mean);
  return sum / static_cast<double>(samples.size() - lag);
}

struct Window {
  std::size_t width;
  double
      sum;  ///< autocovariance summed over all lags of the window, both signs: samples * variance of the mean
};

/// Wolff (2004): grow the window until the error of cutting it equals the noise that it lets in.
Window automatic_window(std::span<const double> samples, double mean) {
  constexpr double decay_ratio = 1.5;  // Wolff's S: exponential over integrated correlation time
  const auto count = static_cast<double>(samples.size());
  const double variance = autocovariance(samples, mean, 0);
  Window window{0, variance};
  if (!(variance > 0)) return window;
  for (std::size_t width = 1; width <= samples.size() / 2; ++width) {
    window.width = width;
    window.sum += 2 * autocovariance(samples, mean, width);
    const double time = window.sum / (2 * variance);  // integrated correlation time in samples
    const double exponential = time > 0.5 ? decay_ratio / std::log((2 * time + 1) / (2 * time - 1))
                                          : std::numeric_limits<double>::min();
    const auto w = static_cast<double>(width);
    if (std::exp(-w / exponential) < exponential / std::sqrt(w * count)) break;
  }
  return window;
}
}  // namespace

Mean mean_of_independent(std::span<const double> samples) {
  SANDGLASS_EXPECT(!samples.empty());
  const auto count = static_cast<double>(samples.size());
  const double mean = plain_mean(samples);
  if (samples.size() < 2) return {mean, unknown, count, 0};
  double squares = 0;
  for (double sample : samples) squares += (sample - mean) * (sample - mean);
  return {mean, std::sqrt(squares / (count - 1) / count), count, count - 1};
}

Mean mean_of_correlated(std::span<const double> samples) {
  SANDGLASS_EXPECT(!samples.empty());
  if (samples.size() < 4) return mean_of_independent(samples);
  const auto count = static_cast<double>(samples.size());
  const double mean = plain_mean(samples);
  const Window window = automatic_window(samples, mean);
  const double variance = autocovariance(samples, mean, 0);
  if (!(variance > 0)) return {mean, variance == 0 ? 0.0 : unknown, count, count - 1};
  const double lags = 2.0 * static_cast<double>(window.width) + 1;
  const double corrected = std::max(window.sum, variance / count) * (1 + lags / count);
  return {mean, std::sqrt(corrected / count), count * variance / corrected, std::max(1.0, count / lags - 1)};
}

Mean average(std::span<const Mean> means) {
  SANDGLASS_EXPECT(!means.empty());
  Mean result;
  double squares = 0, fourth = 0;
  for (const Mean& mean : means) {
    const double square = mean.standard_error * mean.standard_error;
    result.value += mean.value;
    result.effective_samples += mean.effective_samples;
    squares += square;
    if (square > 0) fourth += square * square / mean.degrees_of_freedom;  // Welch-Satterthwaite
  }
  const auto count = static_cast<double>(means.size());
  result.value /= count;
  result.standard_error = std::sqrt(squares) / count;
  result.degrees_of_freedom = fourth > 0 ? squares * squares / fourth : result.effective_samples - 1;
  return result;
}

Mean jackknife(std::size_t replicas, const std::function<double(std::span<const std::size_t>)>& function) {
  SANDGLASS_EXPECT(replicas > 0);
  std::vector<std::size_t> all(replicas);
  std::iota(all.begin(), all.end(), std::size_t{0});
  const double whole = function(all);
  if (replicas < 2) return {whole, unknown, 1, 0};
  const auto count = static_cast<double>(replicas);
  std::vector<double> pseudo_values(replicas);
  for (std::size_t left_out = 0; left_out < replicas; ++left_out) {
    std::vector<std::size_t> rest = all;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(left_out));
    pseudo_values[left_out] = count * whole - (count - 1) * function(rest);
  }
  return mean_of_independent(pseudo_values);
}

LineFit fit_line(std::span<const double> x, std::span<const double> y,
                 std::span<const double> standard_error) {
  SANDGLASS_EXPECT(x.size() == y.size() && x.size() == standard_error.size() && x.size() >= 2);
  double weights = 0, mean_x = 0, mean_y = 0;
  const auto weight = [&](std::size_t i) { return 1 / (standard_error[i] * standard_error[i]); };
  for (std::size_t i = 0; i < x.size(); ++i) {
    weights += weight(i);
    mean_x += weight(i) * x[i];
    mean_y += weight(i) * y[i];
  }
  mean_x /= weights;
  mean_y /= weights;
  double spread = 0, product = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    spread += weight(i) * (x[i] - mean_x) * (x[i] - mean_x);
    product += weight(i) * (x[i] - mean_x) * (y[i] - mean_y);
  }
  LineFit fit;
  fit.slope = product / spread;
  fit.intercept = mean_y - fit.slope * mean_x;
  fit.slope_error = std::sqrt(1 / spread);
  fit.intercept_error = std::sqrt(1 / weights + mean_x * mean_x / spread);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double residual = (y[i] - fit.intercept - fit.slope * x[i]) / standard_error[i];
    fit.chi_square += residual * residual;
  }
  fit.degrees_of_freedom = static_cast<double>(x.size()) - 2;
  return fit;
}

}  // namespace sandglass
