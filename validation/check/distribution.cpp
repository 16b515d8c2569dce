#include "validation/check/families.hpp"
#include "validation/check/finite_size.hpp"
#include "validation/check/histogram.hpp"

namespace sandglass {

namespace {
Evidence velocity_distribution(const Subject& subject, const law::Arguments&) {
  const std::vector<double>& stream = subject.scene().initial.velocity;
  const double mean = stream.empty() ? 0 : stream.front();
  const double variance = subject.mean_temperature() / subject.species().mass;
  const auto cumulative = [&](double velocity) {
    return component_cumulative(velocity - mean, variance, subject.particles(), subject.dimension());
  };
  Evidence evidence = compare_histogram(blocked_histogram(subject, "velocity-histogram-x"), cumulative,
                                        {"velocity", "length/time", false});
  evidence.budget.reason = "finite N is part of the expectation";
  return evidence;
}
}  // namespace

std::vector<CheckInfo> distribution_checks() {
  return {{"velocity-distribution",
           "histogram of the velocity along x against the Maxwellian",
           "",
           {"velocity-histogram-x", "temperature"},
           true,
           {},
           is_equilibrium,
           velocity_distribution}};
}

}  // namespace sandglass
