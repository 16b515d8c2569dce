#pragma once

#include "validation/check/evidence.hpp"
#include "validation/check/subject.hpp"

#include <functional>
#include <string>
#include <vector>

namespace sandglass {

/// Counts per bin of a run, cut into blocks that can be taken as independent: one per replica, or, when there
/// are few replicas, equal stretches of each.
struct BlockedHistogram {
  std::vector<double> edges;                ///< bins + 1
  std::vector<std::vector<double>> counts;  ///< [block][bin]
};

/// Of the samples from a time on. Throws InputError when the series is missing or too short for the blocks.
BlockedHistogram blocked_histogram(const Subject& subject, const std::string& quantity, double from = 0);

/// The bins from `first` to `last` (exclusive) of the histogram.
BlockedHistogram part_of(const BlockedHistogram& histogram, std::size_t first, std::size_t last);

/// Tests every bin of a histogram against a cumulative distribution. The first and the last bin hold
/// everything beyond them too. Bins are joined until theory expects at least 30 counts a block in each, so
/// that their means are normal; each is judged by the scatter of its fraction over the blocks, which needs no
/// assumption on correlation. The evidence is the bin that is worst in its own standard errors. Throws
/// InputError when there are too few counts.
Evidence compare_histogram(const BlockedHistogram& histogram, const std::function<double(double)>& cumulative,
                           const Figure::Axis& axis);

}  // namespace sandglass
