#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/pair_reference.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

// Density and velocity correlations of the particles of a cooling gas, beside those of hard disks (Müller 2001, section
// 3.6.2, figures 3.38 to 3.41). Velocity correlations are taken over the temperature, which is one of the things that differ.

namespace sandglass {

namespace {
/// The sample of a series that was taken after 140 collisions per particle.
std::size_t sample_of(const Subject& subject, std::size_t replica, const Series& series) {
  const std::vector<double> tau = subject.collisions_per_particle(replica, series);
  for (std::size_t sample = 0; sample < tau.size(); ++sample)
    if (std::abs(tau[sample] / kPairCollisions - 1) < 0.02) return sample;
  throw InputError(fmt::format(
      "'{}' has no sample after {:g} collisions per particle: observe it every {{ collisions-per-particle = "
      "{:g} }} and run longer than that",
      series.quantity.name, kPairCollisions, kPairCollisions));
}

/// T/m at a time, from the energy of one replica.
double heat_at(const Subject& subject, std::size_t replica, double time) {
  const Series& series = subject.series(replica, "energy");
  const std::vector<double> energy = subject.column(replica, "energy", "");
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < series.samples(); ++i)
    if (std::abs(series.time[i] - time) < std::abs(series.time[nearest] - time)) nearest = i;
  return 2 * energy[nearest] / (subject.particles() * subject.dimension() * subject.species().mass);
}

/// Mean over the area of the shell from 2 to 5 diameters.
double in_shell(const Series& series, std::size_t sample, double diameter) {
  const std::vector<double>& edges = series.quantity.axis;
  const std::size_t bins = series.quantity.size();
  double sum = 0, area = 0;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    if (edges[bin] < kPairFrom * diameter * (1 - 1e-9) || edges[bin + 1] > kPairTo * diameter * (1 + 1e-9))
      continue;
    const double ring = edges[bin + 1] * edges[bin + 1] - edges[bin] * edges[bin];
    sum += ring * series.value[sample * bins + bin];
    area += ring;
  }
  if (!(area > 0))
    throw InputError(fmt::format("'{}' has no bins from {:g} to {:g} diameters", series.quantity.name,
                                 kPairFrom, kPairTo));
  return sum / area;
}

Mean correlation(const Subject& subject, const std::string& name) {
  std::vector<double> values;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Series& series = subject.series(replica, name);
    const std::size_t sample = sample_of(subject, replica, series);
    const double value = in_shell(series, sample, subject.species().diameter);
    values.push_back(name == "pair-correlation" ? value - 1
                                                : value / heat_at(subject, replica, series.time[sample]));
  }
  return mean_of_independent(values);
}

const PairPoint& reference(const Subject& subject) {
  return pair_reference_at(subject.particles(), fraction(subject.scene(), subject.species()),
                           subject.species().restitution);
}

Evidence beside(const Mean& mean, double expected, double error, const std::string& what) {
  Evidence evidence = from_mean(mean, expected);
  evidence.budget.reference = error;
  evidence.summary = fmt::format("{}, {:g} to {:g} diameters apart after {:g} collisions per particle", what,
                                 kPairFrom, kPairTo, kPairCollisions);
  return evidence;
}

Evidence density(const Subject& subject, const law::Arguments&) {
  const PairPoint& point = reference(subject);
  return beside(correlation(subject, "pair-correlation"), point.density, point.density_error,
                "density correlation g - 1");
}

Evidence parallel(const Subject& subject, const law::Arguments&) {
  const PairPoint& point = reference(subject);
  return beside(correlation(subject, "pair-velocity-parallel"), point.parallel, point.parallel_error,
                "parallel velocity correlation over T/m");
}

Evidence transverse(const Subject& subject, const law::Arguments&) {
  const PairPoint& point = reference(subject);
  return beside(correlation(subject, "pair-velocity-transverse"), point.transverse, point.transverse_error,
                "transverse velocity correlation over T/m");
}

bool has_reference(const Scene& scene) {
  if (!is_uniform(scene) || scene.domain.dimension != 2 || !capabilities(scene).collisions ||
      scene.run.duration.collisions.value_or(0) < kPairCollisions)
    return false;
  return find_pair_reference(static_cast<double>(particle_count(scene)),
                             fraction(scene, scene.species.front()),
                             scene.species.front().restitution) != nullptr;
}
}  // namespace

std::vector<CheckInfo> pair_correlation_checks() {
  const auto beside_hard_disks = [](const char* name, const char* what, const char* series, auto check) {
    return CheckInfo{name,
                     fmt::format("{} of a cooling gas beside that of hard disks", what),
                     "",
                     {series, "energy", "collisions"},
                     false,
                     {},
                     has_reference,
                     check};
  };
  return {beside_hard_disks("density-correlation", "density correlation", "pair-correlation", density),
          beside_hard_disks("parallel-correlation", "parallel velocity correlation", "pair-velocity-parallel",
                            parallel),
          beside_hard_disks("transverse-correlation", "transverse velocity correlation",
                            "pair-velocity-transverse", transverse)};
}

}  // namespace sandglass
