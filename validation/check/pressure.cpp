#include "validation/check/families.hpp"
#include "validation/law/state.hpp"
#include "validation/law/virial.hpp"

#include <limits>

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

Evidence against(const Subject& subject, const law::Bounded& theory) {
  std::vector<std::vector<double>> samples;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    samples.push_back(compressibility_samples(subject, replica));
  const double partners = subject.pair_factor();
  Evidence evidence = from_mean(pooled(samples), 1 + (theory.value - 1) * partners);
  evidence.budget.reference = theory.standard_error;
  evidence.budget.systematic = subject.missing_pairs() * (theory.value - 1) + theory.bound;
  evidence.budget.reason = "pairs that an offset takes from a cell, (1-S)/N_c";
  evidence.effect = evidence.expected - 1;
  evidence.without = "an ideal gas";
  return evidence;
}

Evidence compressibility(const Subject& subject, const law::Arguments&) {
  const law::Gas gas = subject.gas(subject.scene().initial.temperature);
  return against(subject, {law::compressibility_factor(gas), 0, 0});
}

Evidence reference_compressibility(const Subject& subject, const law::Arguments&) {
  Evidence evidence = against(subject, law::reference_compressibility(subject.gas(1)));
  evidence.budget.reason += "; terms that the virial series leaves out";
  return evidence;
}

Evidence kinetic_pressure(const Subject& subject, const law::Arguments&) {
  std::vector<std::vector<double>> samples;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    std::vector<double> kinetic = subject.column(replica, "pressure", "kinetic");
    kinetic.erase(kinetic.begin());
    samples.push_back(std::move(kinetic));
  }
  const double expected = law::kinetic_pressure(subject.gas(subject.scene().initial.temperature));
  Evidence evidence = from_mean(pooled(samples), expected);
  evidence.units = "mass length^(2-D) time^-2";
  evidence.budget.systematic = std::numeric_limits<double>::epsilon() * subject.particles() * expected;
  evidence.budget.reason = "rounding of a sum over particles";
  return evidence;
}

/// The temperature of the scene is that of the run, not of its expectation.
bool has_exact_temperature(const Scene& scene) { return is_equilibrium(scene) && scene.initial.exact; }
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
          {"compressibility-reference",
           "the same against the equation of state as well as it is known",
           "compressibility-reference",
           {"pressure"},
           true,
           {},
           uniform,
           reference_compressibility},
          {"kinetic-pressure",
           "momentum carried by free flight against n T",
           "kinetic-pressure",
           {"pressure"},
           true,
           {},
           has_exact_temperature,
           kinetic_pressure}};
}

}  // namespace sandglass
