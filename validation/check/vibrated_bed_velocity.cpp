#include "validation/check/families.hpp"
#include "validation/check/histogram.hpp"
#include "validation/check/vibrated_bed.hpp"

#include <cmath>

// Velocities in a vibrated bed: even along the bottom, skewed along gravity (Müller 2001, figure 3.43). The bottom sends
// energy up, and collisions take it: fast particles go up more often than down, slow ones come down.

namespace sandglass {

namespace {
double middle(const BlockedHistogram& histogram, std::size_t bin) {
  return (histogram.edges[bin] + histogram.edges[bin + 1]) / 2;
}

/// Mean of a power of the velocity about zero, one block.
double moment(const BlockedHistogram& histogram, const std::vector<double>& counts, int order) {
  double sum = 0, total = 0;
  for (std::size_t bin = 0; bin < counts.size(); ++bin) {
    sum += counts[bin] * std::pow(middle(histogram, bin), order);
    total += counts[bin];
  }
  return sum / total;
}

double skewness(const BlockedHistogram& histogram, std::size_t block) {
  const std::vector<double>& counts = histogram.counts[block];
  return moment(histogram, counts, 3) / std::pow(moment(histogram, counts, 2), 1.5);
}

/// Slow particles that come down less those that go up, over both; slow: within half of the root mean square.
double slow_descent(const BlockedHistogram& histogram, std::size_t block) {
  const std::vector<double>& counts = histogram.counts[block];
  const double slow = std::sqrt(moment(histogram, counts, 2)) / 2;
  double down = 0, up = 0;
  for (std::size_t bin = 0; bin < counts.size(); ++bin)
    if (std::abs(middle(histogram, bin)) < slow) (middle(histogram, bin) < 0 ? down : up) += counts[bin];
  return (down - up) / (down + up);
}

/// When the histograms begin that count.
double settled(const Subject& subject, const law::Arguments& numbers) {
  return numbers.at("settle-share") * subject.series(0, "velocity-histogram-x").time.back();
}

Figure velocity_figure(const Subject& subject, double from) {
  Figure figure{"Velocities", {"U", "length/time", false}, {"share per bin", "1", true}, {}, {}};
  for (const std::string& axis : {std::string("x"), vertical_name(subject.scene())}) {
    const BlockedHistogram histogram = blocked_histogram(subject, "velocity-histogram-" + axis, from);
    Figure::Points points{"along " + axis, {}, {}, {}, {}};
    for (std::size_t bin = 0; bin + 1 < histogram.edges.size(); ++bin) {
      std::vector<double> shares;
      for (const std::vector<double>& counts : histogram.counts) {
        double total = 0;
        for (const double count : counts) total += count;
        shares.push_back(counts[bin] / total);
      }
      const Mean share = mean_of_independent(shares);
      if (!(share.value > 0)) continue;
      points.x.push_back(middle(histogram, bin));
      points.y.push_back(share.value);
      points.error.push_back(share.standard_error);
    }
    figure.points.push_back(std::move(points));
  }
  return figure;
}

/// value(histogram, block) along gravity less its size along x, where it is luck.
template <class Value>
Evidence uneven(const Subject& subject, const law::Arguments& numbers, Value value) {
  const double from = settled(subject, numbers);
  const BlockedHistogram across = blocked_histogram(subject, "velocity-histogram-x", from);
  const BlockedHistogram along =
      blocked_histogram(subject, "velocity-histogram-" + vertical_name(subject.scene()), from);
  std::vector<double> down, side;
  for (std::size_t block = 0; block < along.counts.size(); ++block) {
    down.push_back(value(along, block));
    side.push_back(value(across, block));
  }
  const Mean skew = mean_of_independent(down), even = mean_of_independent(side);
  Mean difference = skew;
  difference.value -= std::abs(even.value);
  difference.standard_error = std::hypot(skew.standard_error, even.standard_error);
  Evidence evidence = at_least(difference, numbers.at("least"));
  evidence.figures.push_back(velocity_figure(subject, from));
  return evidence;
}

Evidence evenness_of_bed(const Subject& subject, const law::Arguments& numbers) {
  const double from = settled(subject, numbers);
  const BlockedHistogram across = blocked_histogram(subject, "velocity-histogram-x", from);
  std::vector<double> skews;
  for (std::size_t block = 0; block < across.counts.size(); ++block) skews.push_back(skewness(across, block));
  Evidence evidence = from_mean(mean_of_independent(skews), 0);
  evidence.figures.push_back(velocity_figure(subject, from));
  return evidence;
}

Evidence skewness_of_bed(const Subject& subject, const law::Arguments& numbers) {
  return uneven(subject, numbers, skewness);
}

Evidence descent_of_bed(const Subject& subject, const law::Arguments& numbers) {
  return uneven(subject, numbers, slow_descent);
}
}  // namespace

std::vector<CheckInfo> vibrated_bed_velocity_checks() {
  const law::Parameter least{"least", "1", "how much of it there must be", 0, 10};
  const law::Parameter settle{"settle-share", "1", "share of the run that is left out", 0, 0.9, 0.25};
  return {
      {"vibrated-bed-skewness",
       "third moment of the vertical velocity, less the size of that of the horizontal one, in units of the "
       "second",
       "",
       {"velocity-histogram-x"},
       false,
       {least, settle},
       is_vibrated_bed,
       skewness_of_bed},
      {"vibrated-bed-descent",
       "slow particles that come down more often than up: the most likely vertical velocity is below zero",
       "",
       {"velocity-histogram-x"},
       false,
       {least, settle},
       is_vibrated_bed,
       descent_of_bed},
      {"vibrated-bed-evenness",
       "third moment of the horizontal velocity in units of the second: none in an even distribution",
       "",
       {"velocity-histogram-x"},
       false,
       {settle},
       is_vibrated_bed,
       evenness_of_bed}};
}

}  // namespace sandglass
