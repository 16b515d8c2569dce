#include "validation/check/histogram.hpp"

#include "sim/base/error.hpp"
#include "validation/check/worst.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr std::size_t wanted_blocks = 20;
constexpr double counts_of_a_normal_bin = 30;

double total(const std::vector<double>& counts) { return std::accumulate(counts.begin(), counts.end(), 0.0); }

/// Adds equal stretches of one replica from a time on; the first sample of a histogram over intervals is empty
/// and does no harm.
void add_blocks(const Series& series, double from, std::size_t blocks,
                std::vector<std::vector<double>>& counts) {
  const std::size_t bins = series.quantity.size();
  const auto begin =
      static_cast<std::size_t>(std::ranges::lower_bound(series.time, from) - series.time.begin());
  const std::size_t length = (series.samples() - begin) / blocks;
  for (std::size_t block = 0; block < blocks; ++block) {
    std::vector<double> sum(bins, 0.0);
    for (std::size_t sample = begin + block * length; sample < begin + (block + 1) * length; ++sample)
      for (std::size_t bin = 0; bin < bins; ++bin) sum[bin] += series.value[sample * bins + bin];
    if (total(sum) > 0) counts.push_back(std::move(sum));
  }
}

/// A run of bins with its probability under the theory.
struct Joined {
  std::size_t first, last;  ///< last is exclusive
  double probability;
};

std::vector<Joined> join_bins(const std::vector<double>& edges,
                              const std::function<double(double)>& cumulative, double counts_per_block) {
  std::vector<Joined> joined;
  const std::size_t bins = edges.size() - 1;
  std::size_t first = 0;
  double below = 0;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const double up_to = bin + 1 == bins ? 1.0 : cumulative(edges[bin + 1]);
    if ((up_to - below) * counts_per_block < counts_of_a_normal_bin) continue;
    joined.push_back({first, bin + 1, up_to - below});
    first = bin + 1;
    below = up_to;
  }
  if (!joined.empty()) {  // what is left over is too little for a bin of its own
    joined.back().last = bins;
    joined.back().probability += 1 - below;
  }
  return joined;
}

Mean fraction_of_theory(const BlockedHistogram& histogram, const Joined& bin) {
  std::vector<double> ratios;
  for (const std::vector<double>& counts : histogram.counts) {
    const auto begin = counts.begin();
    const double inside = std::accumulate(begin + static_cast<std::ptrdiff_t>(bin.first),
                                          begin + static_cast<std::ptrdiff_t>(bin.last), 0.0);
    ratios.push_back(inside / total(counts) / bin.probability);
  }
  return mean_of_independent(ratios);
}
}  // namespace

BlockedHistogram blocked_histogram(const Subject& subject, const std::string& quantity, double from) {
  BlockedHistogram histogram;
  histogram.edges = subject.series(0, quantity).quantity.axis;
  const std::size_t blocks = (wanted_blocks + subject.replicas() - 1) / subject.replicas();
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    add_blocks(subject.series(replica, quantity), from, blocks, histogram.counts);
  if (histogram.counts.size() < 2)
    throw InputError(fmt::format("'{}' has too few samples for an error bar: sample {} times or more",
                                 quantity, 2 * wanted_blocks));
  return histogram;
}

BlockedHistogram part_of(const BlockedHistogram& histogram, std::size_t first, std::size_t last) {
  const auto cut = [&](const std::vector<double>& all, std::size_t end) {
    return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(first),
                               all.begin() + static_cast<std::ptrdiff_t>(end));
  };
  BlockedHistogram part{cut(histogram.edges, last + 1), {}};
  for (const std::vector<double>& counts : histogram.counts) part.counts.push_back(cut(counts, last));
  return part;
}

Evidence compare_histogram(const BlockedHistogram& histogram, const std::function<double(double)>& cumulative,
                           const Figure::Axis& axis) {
  double counts = 0;
  for (const std::vector<double>& block : histogram.counts) counts += total(block);
  const double per_block = counts / static_cast<double>(histogram.counts.size());
  WorstRatio worst;
  Figure figure{"Distribution", axis, {"probability density", "1/(" + axis.units + ")", false}, {}, {}};
  Figure::Points points{"measured", {}, {}, {}, {}};
  for (const Joined& bin : join_bins(histogram.edges, cumulative, per_block)) {
    const Mean ratio = fraction_of_theory(histogram, bin);
    const double low = histogram.edges[bin.first], high = histogram.edges[bin.last];
    const double density = bin.probability / (high - low);
    worst.offer(ratio, fmt::format("{:.3g} to {:.3g}", low, high));
    points.x.push_back((low + high) / 2);
    points.y.push_back(ratio.value * density);
    points.error.push_back(ratio.standard_error * density);
    points.expected.push_back(density);
  }
  figure.lines.push_back({"theory", points.x, points.expected});
  figure.points.push_back(std::move(points));
  Evidence evidence = worst.evidence();
  evidence.summary = "worst bin (" + axis.label + " " + worst.label() + ") over its theoretical fraction";
  evidence.figures.push_back(std::move(figure));
  return evidence;
}

}  // namespace sandglass
