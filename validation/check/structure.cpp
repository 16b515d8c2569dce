#include "sim/base/error.hpp"
#include "validation/check/extrapolation.hpp"
#include "validation/check/families.hpp"
#include "validation/law/state.hpp"
#include "validation/law/virial.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr const char* kStructure = "structure-factor";
constexpr const char* kPairs = "pair-correlation";

/// sum_i weights[i] value[first + i] of every sample, one row a replica; only the first sample unless `all`.
std::vector<std::vector<double>> weighted(const Subject& subject, const std::string& quantity,
                                          std::size_t first, const std::vector<double>& weights, bool all) {
  std::vector<std::vector<double>> sums;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Series& series = subject.series(replica, quantity);
    const std::size_t width = series.quantity.size();
    if (first + weights.size() > width || series.samples() == 0)
      throw InputError(fmt::format("'{}' has {} bins, the check needs {}: give the observer more", quantity,
                                   width, first + weights.size()));
    sums.emplace_back();
    for (std::size_t sample = 0; sample < (all ? series.samples() : 1); ++sample) {
      double sum = 0;
      for (std::size_t i = 0; i < weights.size(); ++i)
        sum += weights[i] * series.value[sample * width + first + i];
      sums.back().push_back(sum);
    }
  }
  return sums;
}

/// Independent waves (k and -k are one) in the shells up to `shells` of a box of equal edges.
double waves_within(int dimension, std::size_t shells) {
  const int most = static_cast<int>(shells) + 1;
  double count = 0;
  for (int x = -most; x <= most; ++x)
    for (int y = -most; y <= most; ++y)
      for (int z = dimension == 3 ? -most : 0; z <= (dimension == 3 ? most : 0); ++z) {
        const double shell = std::round(std::sqrt(x * x + y * y + z * z));
        if (shell >= 1 && shell <= static_cast<double>(shells)) ++count;
      }
  return count / 2;
}

Evidence structure_growth(const Subject& subject, const law::Arguments& numbers) {
  const auto shells = static_cast<std::size_t>(numbers.at("shells"));
  double first = 0, last = 0;
  for (const std::vector<double>& samples : weighted(subject, kStructure, 0, mean_weights(shells), true)) {
    first += samples.front();
    last += samples.back();
  }
  const double growth = std::log(last / first), least = std::log(numbers.at("least"));
  Mean mean;
  mean.value = growth;
  // Each wave's |rho_k|^2 is exponential: relative error one, twice.
  mean.standard_error =
      std::sqrt(2 / (waves_within(subject.dimension(), shells) * static_cast<double>(subject.replicas())));
  Evidence evidence = at_least(mean, least);
  evidence.budget.reason = "every wave an exponential variable";
  evidence.summary = fmt::format("ln of the growth of S(k) in the {} lowest shells", shells);
  return evidence;
}

/// First bin at or beyond contact, and how many lie within `width` diameters of it.
struct Near {
  std::size_t first = 0;
  std::vector<double> distance;  ///< of the middle of each bin from contact, in units of the width
};

Near near_contact(const Series& series, double diameter, double width) {
  const std::vector<double>& edges = series.quantity.axis;
  Near near;
  while (near.first + 1 < edges.size() && edges[near.first] < diameter * (1 - 1e-9)) ++near.first;
  for (std::size_t i = near.first; i + 1 < edges.size() && edges[i + 1] <= diameter * (1 + width + 1e-9); ++i)
    near.distance.push_back(((edges[i] + edges[i + 1]) / 2 - diameter) / (width * diameter));
  if (near.distance.size() < 6)
    throw InputError(
        "'pair-correlation' has fewer than six bins between contact and 'width': narrow the bins of the "
        "observer");
  return near;
}

Evidence contact_value(const Subject& subject, const law::Arguments& numbers) {
  const Near near = near_contact(subject.series(0, kPairs), subject.species().diameter, numbers.at("width"));
  const bool steady = is_equilibrium(subject.scene());
  const auto extrapolated = [&](int degree) {
    return pooled(weighted(subject, kPairs, near.first, intercept_weights(near.distance, degree), steady));
  };
  const law::Bounded g = law::reference_contact_value(subject.dimension(), subject.gas(1).fraction);
  // The observer counts pairs over N (N-1)/2 of them.
  const double factor = subject.pair_factor() * subject.particles() / (subject.particles() - 1);
  const Mean mean = extrapolated(3);
  Evidence evidence = from_mean(mean, g.value * factor);
  evidence.budget.reference = g.standard_error;
  const double fall =
      std::log(
          evidence.value /
          (pooled(weighted(subject, kPairs, near.first + near.distance.size() - 1, {1}, steady)).value)) /
      near.distance.back();
  const double bin = near.distance[1] - near.distance[0];
  evidence.budget.systematic =
      g.bound + evidence.value * (std::pow(fall, 4) / (24 * 70) + std::pow(fall * bin, 2) / 24);
  evidence.budget.reason =
      "fourth order that the cubic leaves out, mean over a bin, terms that the equation of state leaves out";
  return evidence;
}

bool touches_evenly(const Scene& scene) { return touches(scene) && is_uniform(scene); }
}  // namespace

std::vector<CheckInfo> structure_checks() {
  return {{"structure-factor-growth",
           "long waves of the density grow between the first sample and the last",
           "",
           {kStructure},
           false,
           {{"shells", "1", "lowest shells of |k| that are used", 1, 100, 3, 1},
            {"least", "1", "smallest factor by which S(k) must grow", 1, 1e9}},
           touches_evenly,
           structure_growth},
          {"contact-value",
           "pair correlation, continued to contact, against the contact value as well as it is known",
           "contact-value-reference",
           {kPairs},
           true,
           {{"width", "diameters", "distance from contact over which g(r) is continued", 1e-3, 1, 0.15}},
           touches_evenly,
           contact_value}};
}

}  // namespace sandglass
