#include "validation/check/families.hpp"
#include "validation/check/worst.hpp"

#include <cmath>

// Regions in which simulated particles stand for other numbers of real ones: what crosses is kept in the mean.

namespace sandglass {

namespace {
/// At the end, all replicas together.
double total(const Subject& subject, const char* quantity, const std::string& component) {
  double sum = 0;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    sum += subject.column(replica, quantity, component).back();
  return sum;
}

/// Mass, momentum and energy behind the borders over those before them. Their variance is known, not estimated: that of the
/// number of copies, at every crossing.
Evidence cloning_balance(const Subject& subject, const law::Arguments&) {
  WorstRatio worst;
  for (const std::string& name : subject.series(0, "cloning-brought").quantity.components) {
    const double brought = total(subject, "cloning-brought", name),
                 gained = total(subject, "cloning-gained", name),
                 variance = total(subject, "cloning-variance", name);
    // A whole number of copies leaves nothing to chance.
    if (brought == 0 || (gained == 0 && variance == 0)) continue;
    Mean ratio;
    ratio.value = 1 + gained / brought;
    ratio.standard_error = std::sqrt(variance) / brought;
    worst.offer(ratio, name);
  }
  Evidence evidence = worst.evidence();
  evidence.summary =
      "mass, momenta and energy of copies over those of who crosses between regions; worst: " + worst.label();
  evidence.budget.systematic = 1e-9;
  evidence.budget.reason = "rounding of sums";
  return evidence;
}

bool has_regions(const Scene& scene) { return !scene.regions.empty(); }
}  // namespace

std::vector<CheckInfo> cloning_checks() {
  return {{"cloning-balance",
           "mass, momenta and energy of copies over those of who crosses between regions of other weights",
           "",
           {"cloning-brought", "cloning-gained", "cloning-variance"},
           true,
           {},
           has_regions,
           cloning_balance,
           true}};
}

}  // namespace sandglass
