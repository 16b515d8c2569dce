#include "validation/check/families.hpp"
#include "validation/law/state.hpp"
#include "validation/law/virial.hpp"

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

Evidence against(const Subject& subject, const law::Bounded& theory, double carried = 1) {
  std::vector<std::vector<double>> samples;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    samples.push_back(compressibility_samples(subject, replica));
  const law::Bounded missing = subject.missing_pairs();
  const double partners = subject.pair_factor() * (1 - missing.value) * carried;
  Evidence evidence = from_mean(pooled(samples), 1 + (theory.value - 1) * partners);
  evidence.budget.reference = theory.standard_error;
  evidence.budget.systematic = missing.bound * (theory.value - 1) + theory.bound;
  evidence.budget.reason = "pairs that an offset takes from a cell, between the limits of pair_deficit";
  evidence.effect = evidence.expected - 1;
  evidence.without = "an ideal gas";
  return evidence;
}

/// An offset carries m d r c_n where a contact hands over m d (1 + r) c_n/2.
Evidence compressibility(const Subject& subject, const law::Arguments& numbers) {
  const law::Gas gas = subject.gas(subject.scene().initial.temperature);
  const double r = gas.restitution, offset = numbers.at("by-offset") > 0 ? 2 * r / (1 + r) : 1;
  return against(subject, {law::compressibility_factor(gas), 0, 0}, numbers.at("carried") * offset);
}

Evidence reference_compressibility(const Subject& subject, const law::Arguments&) {
  Evidence evidence = against(subject, law::reference_compressibility(subject.gas(1)));
  evidence.budget.reason += "; terms that the virial series leaves out";
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
           {{"carried", "1", "part of the collisional momentum that the method carries", 0, 1, 1.0},
            {"by-offset", "1", "1: as an offset carries it, 2r/(1+r) of it", 0, 1, 0.0}},
           uniform,
           compressibility},
          {"compressibility-reference",
           "the same against the equation of state as well as it is known",
           "compressibility-reference",
           {"pressure"},
           true,
           {},
           uniform,
           reference_compressibility}};
}

}  // namespace sandglass
