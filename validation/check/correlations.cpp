#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/correlations_reference.hpp"
#include "validation/check/families.hpp"
#include "validation/check/impact_fit.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

// What correlations change in a cooling gas: its energy at a number of collisions, whatever their rate, and the
// impact parameters of these collisions (Müller 2001, section 3.6).

namespace sandglass {

namespace {
/// ln(E/E0) of one replica at a number of collisions per particle, straight between samples.
double log_energy(const Subject& subject, std::size_t replica, double collisions) {
  const Series& series = subject.series(replica, "energy");
  const std::vector<double> tau = subject.collisions_per_particle(replica, series);
  const std::vector<double> energy = subject.column(replica, "energy", "");
  const auto after = std::upper_bound(tau.begin(), tau.end(), collisions * (1 - 1e-9));
  if (after == tau.end() || after == tau.begin())
    throw InputError(fmt::format(
        "the run has no sample at {:g} collisions per particle: run longer, sample from the start, or "
        "choose another 'collisions'",
        collisions));
  const auto i = static_cast<std::size_t>(after - tau.begin());
  const double share = (collisions - tau[i - 1]) / (tau[i] - tau[i - 1]);
  return (1 - share) * std::log(energy[i - 1] / energy[0]) + share * std::log(energy[i] / energy[0]);
}

Mean mean_log_energy(const Subject& subject, double collisions) {
  std::vector<double> values;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    values.push_back(log_energy(subject, replica, collisions));
  return mean_of_independent(values);
}

const CoolingPoint& reference(const Subject& subject, double collisions) {
  return correlations_reference_at(subject.particles(), fraction(subject.scene(), subject.species()),
                                   collisions);
}

Figure energy_figure(const Subject& subject) {
  Figure figure{
      "Energy per collision", {"collisions per particle", "1", false}, {"ln(E/E0)", "1", false}, {}, {}};
  Figure::Points measured{"measured", {}, {}, {}, {}};
  Figure::Line hard{"hard disks", {}, {}}, hybrid{"hybrid Monte Carlo", {}, {}},
      direct{"direct Monte Carlo", {}, {}};
  const double last = subject.collisions_per_particle(0, subject.series(0, "energy")).back();
  for (const CoolingPoint& point : correlations_reference()) {
    if (point.particles != subject.particles() ||
        std::abs(point.area_fraction - fraction(subject.scene(), subject.species())) > 1e-6)
      continue;
    for (auto [line, value] :
         {std::pair{&hard, point.event_driven}, {&hybrid, point.hsmc}, {&direct, point.dsmc}}) {
      line->x.push_back(point.collisions);
      line->y.push_back(value);
    }
    if (point.collisions > last * 0.98) continue;
    const Mean mean = mean_log_energy(subject, point.collisions);
    measured.x.push_back(point.collisions);
    measured.y.push_back(mean.value);
    measured.error.push_back(mean.standard_error);
  }
  figure.points.push_back(std::move(measured));
  figure.lines = {hard, hybrid, direct};
  return figure;
}

Evidence energy_beside_hard_disks(const Subject& subject, const law::Arguments& numbers) {
  const double collisions = numbers.at("collisions");
  const CoolingPoint& point = reference(subject, collisions);
  Evidence evidence = from_mean(mean_log_energy(subject, collisions), point.event_driven);
  evidence.budget.reference = point.event_driven_error;
  evidence.summary = fmt::format("ln(E/E0) at {:g} collisions per particle, beside hard disks", collisions);
  evidence.figures.push_back(energy_figure(subject));
  return evidence;
}

Evidence energy_below_hard_disks(const Subject& subject, const law::Arguments& numbers) {
  const double collisions = numbers.at("collisions");
  const CoolingPoint& point = reference(subject, collisions);
  Mean below = mean_log_energy(subject, collisions);
  below.value = point.event_driven - below.value;
  Evidence evidence = at_least(below, numbers.at("least"));
  evidence.budget.reference = point.event_driven_error;
  evidence.summary = fmt::format(
      "by how much ln(E/E0) lies below that of hard disks at {:g} collisions per particle", collisions);
  evidence.figures.push_back(energy_figure(subject));
  return evidence;
}

/// Of the distance from a method with uniform impact parameters to hard disks, the part that a run with fitted ones covers.
Evidence correction(const Subject& subject, const law::Arguments& numbers) {
  const double collisions = numbers.at("collisions");
  const CoolingPoint& point = reference(subject, collisions);
  const bool cells = has_full_cells(subject.scene());
  const double plain = cells ? point.hsmc : point.dsmc, error = cells ? point.hsmc_error : point.dsmc_error;
  const double gap = point.event_driven - plain;
  Mean part = mean_log_energy(subject, collisions);
  part.value = (part.value - plain) / gap;
  part.standard_error /= std::abs(gap);
  Evidence evidence = from_mean(part, 0);
  evidence.budget.reference =
      std::hypot(error * (1 - part.value), point.event_driven_error * part.value) / std::abs(gap);
  evidence.summary = fmt::format(
      "part of the distance to hard disks that fitted impact parameters cover, {:g} collisions per particle",
      collisions);
  evidence.figures.push_back(energy_figure(subject));
  return evidence;
}

/// c of the collisions of one replica between two numbers of collisions per particle.
double coefficient(const Subject& subject, std::size_t replica, double from, double to) {
  const Series& series = subject.series(replica, "impact-parameter");
  const std::size_t bins = series.quantity.size();
  std::vector<double> counts(2 * bins), edges(2 * bins + 1);
  double total = 0;
  for (std::size_t sample = 0; sample < series.samples(); ++sample) {
    const double before = total;
    for (std::size_t bin = 0; bin < bins; ++bin) total += series.value[sample * bins + bin];
    const double scale = 2 / subject.particles();
    if (before * scale < from * (1 - 1e-2) || total * scale > to * (1 + 1e-2)) continue;
    for (std::size_t bin = 0; bin < bins; ++bin) {
      counts[bins + bin] += series.value[sample * bins + bin] / 2;
      counts[bins - 1 - bin] += series.value[sample * bins + bin] / 2;
    }
  }
  for (std::size_t bin = 0; bin <= bins; ++bin) {
    edges[bins + bin] = series.quantity.axis[bin];
    edges[bins - bin] = -series.quantity.axis[bin];
  }
  return fit_impact_coefficient(2, edges, counts).value;
}

Evidence impact_coefficient(const Subject& subject, const law::Arguments& numbers) {
  std::vector<double> values;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    values.push_back(coefficient(subject, replica, numbers.at("from"), numbers.at("to")));
  Evidence evidence = from_mean(mean_of_independent(values), 0);
  if (numbers.at("least") > 0) evidence = at_least(mean_of_independent(values), numbers.at("least"));
  evidence.summary = fmt::format("c of p(b) = a/(1 - c b^2) from {:g} to {:g} collisions per particle",
                                 numbers.at("from"), numbers.at("to"));
  return evidence;
}

bool cools_like_reference(const Scene& scene) {
  return is_uniform(scene) && scene.domain.dimension == 2 && capabilities(scene).collisions &&
         std::abs(scene.species.front().restitution - 0.85) < 1e-9;
}

bool finds_contacts(const Scene& scene) {
  return is_uniform(scene) && touches(scene) && scene.domain.dimension == 2;
}
}  // namespace

std::vector<CheckInfo> correlation_checks() {
  const law::Parameter collisions{"collisions", "1", "collisions per particle", 1, 1e6};
  const law::Parameter least{"least", "1", "how much of it there must be", 0, 100};
  return {
      {"energy-at-collisions",
       "energy of a cooling gas after a number of collisions, beside hard disks",
       "",
       {"energy", "collisions"},
       false,
       {collisions},
       cools_like_reference,
       energy_beside_hard_disks},
      {"energy-below-hard-disks",
       "by how much the logarithm of the energy lies below that of hard disks after a number of collisions",
       "",
       {"energy", "collisions"},
       false,
       {collisions, least},
       cools_like_reference,
       energy_below_hard_disks},
      {"impact-correction",
       "part of the distance to hard disks that fitted impact parameters cover",
       "",
       {"energy", "collisions"},
       false,
       {collisions},
       cools_like_reference,
       correction},
      {"impact-coefficient",
       "coefficient c of the impact distribution a/(1 - c b^2) in a window of collisions per particle",
       "impact-normalisation",
       {"impact-parameter"},
       false,
       {law::Parameter{"from", "1", "collisions per particle", 0, 1e6},
        law::Parameter{"to", "1", "collisions per particle", 0, 1e6},
        law::Parameter{"least", "1", "c that there must be; 0: c is to be 0", 0, 1, 0}},
       finds_contacts,
       impact_coefficient}};
}

}  // namespace sandglass
