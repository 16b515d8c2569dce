#include "sim/base/steady.hpp"

#include "sim/base/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass {

namespace {
constexpr std::size_t batch = 5, fewest_samples = 20;
constexpr double clear_errors = 4, fewest_independent = 5;
constexpr double rounding = 1e-12;  ///< momentum is zero but for rounding

std::vector<double> means_of_five(std::span<const double> samples) {
  std::vector<double> means;
  for (std::size_t i = 0; i + batch <= samples.size(); i += batch)
    means.push_back(mean_of_independent(samples.subspan(i, batch)).value);
  return means;
}

/// Adds the squares about its mean of what each cut leaves, in units of those of the second half.
void add_squares(const std::vector<double>& means, std::vector<double>& squares) {
  const double origin = mean_of_independent(means).value;
  std::vector<double> left(squares.size());
  double sum = 0, square = 0;
  for (std::size_t i = means.size(); i-- > 0;) {
    const double value = means[i] - origin;
    sum += value;
    square += value * value;
    if (i < left.size()) left[i] = square - sum * sum / static_cast<double>(means.size() - i);
  }
  if (!(left.front() > 0) || !std::isfinite(left.front())) return;
  const double unit = left.back() > 0 ? left.back() : left.front();
  for (std::size_t cut = 0; cut < left.size(); ++cut) squares[cut] += left[cut] / unit;
}
}  // namespace

std::size_t steady_from(const Rows& rows) {
  if (rows.empty() || rows.front().size() < fewest_samples) return 0;
  const std::size_t batches = rows.front().size() / batch;
  std::vector<double> squares(batches / 2 + 1);
  for (const std::vector<double>& row : rows) add_squares(means_of_five(row), squares);
  for (std::size_t cut = 0; cut < squares.size(); ++cut) {
    const auto length = static_cast<double>(batches - cut);
    squares[cut] /= length * length;
  }
  return batch * static_cast<std::size_t>(std::ranges::min_element(squares) - squares.begin());
}

bool drifts(std::span<const double> samples) {
  if (samples.size() < fewest_samples) return false;
  const std::size_t half = samples.size() / 2;
  const Mean early = mean_of_correlated(samples.first(half)),
             late = mean_of_correlated(samples.subspan(half));
  const double apart = std::abs(late.value - early.value);
  if (apart < rounding_share * std::max(std::abs(early.value), std::abs(late.value)) + rounding) return false;
  return apart > clear_errors * std::hypot(early.standard_error, late.standard_error) ||
         mean_of_correlated(samples).effective_samples < fewest_independent;
}

}  // namespace sandglass
