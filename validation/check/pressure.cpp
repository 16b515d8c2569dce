#include "validation/check/families.hpp"
#include "validation/law/state.hpp"

namespace sandglass {

namespace {
/// 1 + collisional/kinetic pressure of each interval; the sample at time zero has no interval before it.
std::vector<double> compressibility_samples(const Subject& subject, std::size_t replica) {
  const std::vector<double> kinetic = subject.column(replica, "pressure", "kinetic");
  const std::vector<double> collisional = subject.column(replica, "pressure", "collisional");
  std::vector<double> samples;
  for (std::size_t i = 1; i < kinetic.size(); ++i) samples.push_back(1 + collisional[i] / kinetic[i]);
  return samples;
}

/// A dissipative gas cools by this fraction in one step. Moves see the temperature of the end of a step,
/// collisions that of its course: the ratio of the two pressures cannot be known better than this.
double cooling_in_a_step(const Subject& subject) {
  const double r = subject.species().restitution;
  return (1 - r * r) / subject.dimension() * subject.collisions_per_step();
}

Evidence from_mean(const Mean& mean, double expected) {
  Evidence evidence;
  evidence.value = mean.value;
  evidence.standard_error = mean.standard_error;
  evidence.degrees_of_freedom = mean.degrees_of_freedom;
  evidence.expected = expected;
  return evidence;
}

Evidence compressibility(const Subject& subject, const law::Arguments&) {
  std::vector<std::vector<double>> samples;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    samples.push_back(compressibility_samples(subject, replica));
  const double expected = law::compressibility_factor(subject.gas(subject.scene().initial.temperature));
  Evidence evidence = from_mean(pooled(samples), expected);
  evidence.budget.systematic = cooling_in_a_step(subject) * (expected - 1);
  if (evidence.budget.systematic > 0) evidence.budget.reason = "the gas cools during a step";
  return evidence;
}

Evidence kinetic_pressure(const Subject& subject, const law::Arguments&) {
  std::vector<std::vector<double>> samples;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    std::vector<double> kinetic = subject.column(replica, "pressure", "kinetic");
    kinetic.erase(kinetic.begin());
    samples.push_back(std::move(kinetic));
  }
  const double expected = law::kinetic_pressure(subject.gas(subject.mean_temperature())) *
                          (subject.particles() - 1) / subject.particles();
  Evidence evidence = from_mean(pooled(samples), expected);
  evidence.units = "mass length^(2-D) time^-2";
  evidence.budget.reason = "finite N is part of the expectation";
  return evidence;
}
}  // namespace

std::vector<CheckInfo> pressure_checks() {
  const auto uniform = [](const Scene& scene) { return is_equilibrium(scene) || is_cooling(scene); };
  return {{"compressibility",
           "pressure over kinetic pressure against the equation of state",
           "compressibility-factor",
           {"pressure"},
           true,
           {},
           uniform,
           compressibility},
          {"kinetic-pressure",
           "momentum carried by free flight against n T",
           "kinetic-pressure",
           {"pressure", "temperature"},
           true,
           {},
           is_equilibrium,
           kinetic_pressure}};
}

}  // namespace sandglass
