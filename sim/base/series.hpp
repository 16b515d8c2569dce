#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sandglass {

/// What an observer measures: its name, units and the shape of one sample.
struct Quantity {
  std::string name;                ///< hyphenated, e.g. "temperature"
  std::string units;               ///< in scene units, e.g. "mass length^2 time^-2"; "1" when dimensionless
  std::string summary;             ///< one sentence
  std::vector<std::size_t> shape;  ///< shape of one sample; empty for a scalar
  std::vector<std::string> components;  ///< names of the flattened components; may be empty
  std::vector<double> axis;  ///< bin edges of the last dimension (histograms, fields); may be empty
  std::string axis_label;    ///< e.g. "velocity [length/time]"

  std::size_t size() const {
    std::size_t product = 1;
    for (std::size_t extent : shape) product *= extent;
    return product;
  }
};

/// Samples of one quantity in one replica: value[sample][component], row major.
struct Series {
  Quantity quantity;
  std::vector<std::uint64_t> step;
  std::vector<double> time;
  std::vector<double> value;

  std::size_t samples() const { return step.size(); }
};

/// Mean of a quantity over samples and replicas, without the transient at the start of the run, with a standard error that
/// accounts for correlation in time.
struct Estimate {
  Quantity quantity;
  std::vector<double> value;
  std::vector<double> standard_error;  ///< NaN where it cannot be known (one sample, one replica)
  double effective_samples =
      0;  ///< independent samples that the error rests on (smallest over components that vary)
  double start_time = 0;  ///< of the part of the run that it is the mean of (sim/base/steady.hpp)
  bool drifts = false;    ///< a component went on changing in that part: no steady mean
};

}  // namespace sandglass
