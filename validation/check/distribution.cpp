#include "validation/check/families.hpp"
#include "validation/check/finite_size.hpp"
#include "validation/check/histogram.hpp"

namespace sandglass {

namespace {
std::size_t axis_of_observer(const Scene& scene, const std::string& what) {
  for (const Observe& observe : scene.observe)
    if (observe.what == what) return static_cast<std::size_t>(observe.axis);
  return 0;
}

Evidence velocity_distribution(const Subject& subject, const law::Arguments&) {
  const std::vector<double>& stream = subject.scene().initial.velocity;
  const std::size_t axis = axis_of_observer(subject.scene(), "velocity-histogram");
  const double mean = stream.empty() ? 0 : stream.at(axis);
  const double variance = subject.mean_temperature() / subject.species().mass;
  const auto cumulative = [&](double velocity) {
    return component_cumulative(velocity - mean, variance, subject.particles(), subject.dimension());
  };
  Evidence evidence = compare_histogram(blocked_histogram(subject, "velocity-histogram"), cumulative,
                                        {"velocity", "length/time", false});
  evidence.budget.reason = "finite N is part of the expectation";
  return evidence;
}
}  // namespace

std::vector<CheckInfo> distribution_checks() {
  return {{"velocity-distribution",
           "histogram of one velocity component against the Maxwellian",
           "",
           {"velocity-histogram", "temperature"},
           true,
           {},
           is_equilibrium,
           velocity_distribution}};
}

}  // namespace sandglass
