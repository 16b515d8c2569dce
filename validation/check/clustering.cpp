#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/clustering_excess.hpp"
#include "validation/check/clustering_reference.hpp"
#include "validation/check/families.hpp"
#include "validation/check/worst.hpp"
#include "validation/law/haff.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

// A large gas that cools leaves Haff's law and clusters (Müller 2001, section 3.2). Times in t0.

namespace sandglass {

namespace {
Evidence passage_evidence(const Mean& time, const ClusteringExcess& excess, double expected) {
  Evidence evidence = from_mean(time, expected);
  evidence.units = "t0";
  evidence.figures.push_back(excess.figure());
  return evidence;
}

Evidence haff_departure(const Subject& subject, const law::Arguments& numbers) {
  const ClusteringExcess excess(subject);
  const double mark = 1 + numbers.at("part");
  return passage_evidence(excess.passage(false, [mark](double) { return mark; }), excess,
                          numbers.at("expected"));
}

Evidence parting(const Subject& subject, const law::Arguments& numbers) {
  const ClusteringExcess excess(subject);
  const double left = 1 - numbers.at("part");
  const auto mark = [left](double time) { return left * clustering_excess(time); };
  return passage_evidence(excess.passage(true, mark), excess, numbers.at("expected"));
}

/// The waves of the velocity that grow keep their energy while Haff's falls, and a box of N particles pins the longest,
/// its mean velocity, to zero: D of them, T/2 each at the start. That part of E is 1/(N E/E0).
double pinned_share(const Subject& subject, const ClusteringPoint& point) {
  return 1 / (subject.particles() * point.excess * law::haff_energy_ratio(point.time, 1));
}

/// Ratio to the reference at one of its times.
Evidence energy_at(const Subject& subject, const ClusteringExcess& excess, const ClusteringPoint& point) {
  const Mean mean = excess.mean_at(point.time);
  Evidence evidence;
  evidence.value = mean.value / point.excess;
  evidence.expected = 1;
  evidence.standard_error = mean.standard_error / point.excess;
  evidence.degrees_of_freedom = mean.degrees_of_freedom;
  evidence.budget.reference = point.standard_error / point.excess;
  evidence.budget.systematic = pinned_share(subject, point);
  evidence.budget.reason = "mean velocity of the box, which the reference's larger box lets grow";
  evidence.summary =
      fmt::format("energy over that of the event-driven reference; worst at t/t0 = {}", point.time);
  return evidence;
}

/// Standard errors beyond the systematic part; NaN counts as the worst.
double excess_of(const Evidence& evidence) {
  const double errors = (std::abs(evidence.value - 1) - evidence.budget.systematic) /
                        std::hypot(evidence.standard_error, evidence.budget.reference);
  return std::isnan(errors) ? INFINITY : errors;
}

Evidence clustering_energy(const Subject& subject, const law::Arguments& numbers) {
  const ClusteringExcess excess(subject);
  std::vector<Evidence> found;
  for (const ClusteringPoint& point : clustering_reference())
    if (point.time > 0 && point.time <= numbers.at("last") * (1 + 1e-9))
      found.push_back(energy_at(subject, excess, point));
  if (found.empty())
    throw InputError("the reference of the clustering gas has no point up to 'last': raise it");
  Evidence worst = *std::max_element(found.begin(), found.end(), [](const Evidence& a, const Evidence& b) {
    return excess_of(a) < excess_of(b);
  });
  worst.comparisons = static_cast<int>(found.size());
  worst.figures.push_back(excess.figure());
  return worst;
}

/// Mean g(r) below contact in the last sample of one replica.
double pairs_below_contact(const Series& series, double diameter, int dimension) {
  const std::vector<double>& edge = series.quantity.axis;
  const std::size_t bins = series.quantity.size(), begin = (series.samples() - 1) * bins;
  double pairs = 0, room = 0;
  for (std::size_t i = 0; i < bins && edge[i + 1] <= diameter * (1 + 1e-9); ++i) {
    const double shell = std::pow(edge[i + 1], dimension) - std::pow(edge[i], dimension);
    pairs += series.value[begin + i] * shell;
    room += shell;
  }
  if (!(room > 0)) throw InputError("'pair-correlation' has no bin below contact: start its range at 0");
  return pairs / room;
}

Evidence excluded_volume(const Subject& subject, const law::Arguments&) {
  Evidence evidence;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Series& series = subject.series(replica, "pair-correlation");
    keep_worst(evidence.value, pairs_below_contact(series, subject.species().diameter, subject.dimension()));
  }
  evidence.budget.reason = "hard particles exclude each other exactly";
  return evidence;
}

bool loses_energy(const Scene& scene) {
  return is_uniform(scene) && scene.species.front().restitution < 1 && !scene.initial.shear_wave &&
         capabilities(scene).collisions;
}

/// What the reference holds for, whatever the method and the number of particles.
bool clusters_like_reference(const Scene& scene) {
  return loses_energy(scene) && scene.domain.dimension == 2 &&
         std::abs(scene.species.front().restitution - 0.8) < 1e-9 && std::abs(fraction(scene) - 0.25) < 1e-6;
}

bool has_hard_pairs(const Scene& scene) { return touches(scene) && is_uniform(scene); }
}  // namespace

std::vector<CheckInfo> clustering_checks() {
  const law::Parameter expected{"expected", "t0", "what the source says", 1e-3, 1e6};
  const law::Parameter part{"part", "1", "by which share the energies then differ", 0.001, 0.9, 0.1};
  const law::Parameter last{"last", "t0", "latest time of the comparison", 0.1, 1000};
  return {{"haff-departure",
           "when the energy of a gas large enough to cluster has risen above Haff's law",
           "haff-time-scale",
           {"energy"},
           false,
           {part, expected},
           loses_energy,
           haff_departure},
          {"event-driven-parting",
           "when the energy has fallen below that of hard disks, event-driven reference",
           "",
           {"energy"},
           false,
           {part, expected},
           clusters_like_reference,
           parting},
          {"clustering-energy",
           "energy of the clustering gas against the event-driven reference",
           "",
           {"energy"},
           false,
           {last},
           clusters_like_reference,
           clustering_energy},
          {"excluded-volume",
           "pairs closer than a diameter at the end, over those of independent particles",
           "",
           {"pair-correlation"},
           false,
           {},
           has_hard_pairs,
           excluded_volume}};
}

}  // namespace sandglass
