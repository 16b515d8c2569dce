#include "sim/base/error.hpp"
#include "validation/check/families.hpp"
#include "validation/check/histogram.hpp"
#include "validation/check/worst.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

// What only methods that find contacts have: impact parameters and overlaps.

namespace sandglass {

namespace {
constexpr const char* kImpact = "impact-parameter";

/// Without correlations the line of centres is spread evenly over the cross-section: F(b) = b^(D-1), b in diameters.
double uncorrelated(int dimension, double b) { return dimension == 2 ? b : b * b; }

Evidence impact_parameter(const Subject& subject, const law::Arguments&) {
  const auto cumulative = [&](double b) { return uncorrelated(subject.dimension(), b); };
  return compare_histogram(blocked_histogram(subject, kImpact), cumulative, {"|b|/d", "1", false});
}

/// Counts of a histogram with its mean, every count at the middle of its bin.
struct Moments {
  double count = 0, sum = 0, squares = 0;

  void add(const std::vector<double>& edges, std::size_t bin, double number) {
    const double middle = (edges[bin] + edges[bin + 1]) / 2;
    count += number;
    sum += number * middle;
    squares += number * middle * middle;
  }
  double mean() const { return sum / count; }
  double variance_of_mean() const { return (squares / count - mean() * mean()) / count; }
};

/// Mean of the theory in the same bins.
double uncorrelated_mean(const std::vector<double>& edges, int dimension) {
  Moments moments;
  for (std::size_t bin = 0; bin + 1 < edges.size(); ++bin)
    moments.add(edges, bin, uncorrelated(dimension, edges[bin + 1]) - uncorrelated(dimension, edges[bin]));
  return moments.mean();
}

Evidence more_grazing(const Subject& subject, const law::Arguments& numbers) {
  const BlockedHistogram histogram = blocked_histogram(subject, kImpact);
  const double even = uncorrelated_mean(histogram.edges, subject.dimension());
  std::vector<double> excess;
  for (const std::vector<double>& counts : histogram.counts) {
    Moments moments;
    for (std::size_t bin = 0; bin < counts.size(); ++bin) moments.add(histogram.edges, bin, counts[bin]);
    excess.push_back(moments.mean() - even);
  }
  return at_least(mean_of_independent(excess), numbers.at("least"));
}

/// Contacts of all replicas in the samples of the first or the last third of each.
Moments third(const Subject& subject, bool last) {
  Moments moments;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Series& series = subject.series(replica, kImpact);
    const std::size_t bins = series.quantity.size(), length = series.samples() / 3;
    const std::size_t begin = last ? series.samples() - length : 0;
    for (std::size_t i = begin * bins; i < (begin + length) * bins; ++i)
      moments.add(series.quantity.axis, i % bins, series.value[i]);
  }
  if (!(moments.count > 1000))
    throw InputError(
        "'impact-parameter' holds too few contacts for a drift: a thousand are needed in the first third of "
        "the samples and in the last");
  return moments;
}

Evidence drift(const Subject& subject, const law::Arguments& numbers) {
  const Moments early = third(subject, false), late = third(subject, true);
  Mean change;
  change.value = std::abs(late.mean() - early.mean());
  change.standard_error = std::sqrt(late.variance_of_mean() + early.variance_of_mean());
  Evidence evidence = at_least(change, numbers.at("least"));
  evidence.budget.reason = "contacts taken as independent of each other";
  return evidence;
}

Evidence overlap(const Subject& subject, const law::Arguments& numbers) {
  Evidence evidence;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    for (double depth : subject.column(replica, "overlap", "")) keep_worst(evidence.value, depth);
  evidence.units = "diameters";
  evidence.kind = Expectation::at_most;
  evidence.expected = numbers.at("deepest");
  evidence.budget.reason = "the bound is what rounding of positions may leave";
  return evidence;
}

/// Müller finds P(b) even for r >= 0.9 at any density (MUL-5).
bool contacts_are_even(const Scene& scene) {
  return touches(scene) && is_uniform(scene) && scene.species.front().restitution >= 0.9 &&
         !scene.initial.shear_wave;
}

bool has_contacts(const Scene& scene) { return touches(scene) && is_uniform(scene); }

law::Parameter least_part(const std::string& summary) { return {"least", "1", summary, 0, 1}; }
}  // namespace

std::vector<CheckInfo> contact_checks() {
  return {{kImpact,
           "histogram of the impact parameter against that of uncorrelated contacts",
           "",
           {kImpact},
           true,
           {},
           contacts_are_even,
           impact_parameter},
          {"impact-parameter-grazing",
           "mean of |b|/d above that of uncorrelated contacts: how much more grazing contacts are",
           "",
           {kImpact},
           false,
           {least_part("smallest excess of the mean of |b|/d that counts")},
           has_contacts,
           more_grazing},
          {"impact-parameter-drift",
           "change of the mean of |b|/d, last third over first: the impact parameter drifts with time",
           "",
           {kImpact},
           false,
           {least_part("smallest change of the mean of |b|/d that counts")},
           has_contacts,
           drift},
          {"overlap",
           "deepest overlap at a collision",
           "",
           {"overlap"},
           false,
           {{"deepest", "diameters", "deepest overlap that rounding may leave", 0, 1, 1e-9}},
           touches,
           overlap}};
}

}  // namespace sandglass
