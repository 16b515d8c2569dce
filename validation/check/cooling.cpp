#include "sim/base/error.hpp"
#include "validation/check/families.hpp"
#include "validation/law/haff.hpp"
#include "validation/law/shear_modes.hpp"
#include "validation/law/sonine.hpp"

#include <cmath>

// Both checks average a rate over intervals between samples after the start has settled. Samples that are
// equally spaced in collisions carry equal information, so the plain average is the efficient one.

namespace sandglass {

namespace {
struct Decay {
  std::vector<double> time, collisions, energy;  ///< at the samples of one replica; collisions per particle
};

Decay decay_of(const Subject& subject, std::size_t replica) {
  const Series& series = subject.series(replica, "energy");
  return {series.time, subject.collisions_per_particle(replica, series),
          subject.column(replica, "energy", "")};
}

/// rate(decay, i) of every interval [i-1, i] that starts after `settle` collisions per particle.
template <class Rate>
std::vector<std::vector<double>> settled_rates(const Subject& subject, double settle, Rate rate) {
  std::vector<std::vector<double>> rates;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Decay decay = decay_of(subject, replica);
    rates.emplace_back();
    for (std::size_t i = 1; i < decay.time.size(); ++i)
      if (decay.collisions[i - 1] >= settle) rates.back().push_back(rate(decay, i));
    if (rates.back().empty())
      throw InputError(
          "the run ends before it settles: run longer than 'settle-collisions', or sample more often");
  }
  return rates;
}

/// Relative error of a cooling rate from theory and finite size. Sonine: the closures of a2 differ, and its
/// square is left out (the coefficients are those of the rate's own expansion, rounded up). N: moments of a
/// sphere instead of a Gaussian, and fluctuations of the energy, 1/N each. Cell: two particles that share a
/// cell of N_c collide again with probability 1/N_c before they part, slowed down by 1-r. Pairs that are missing from a
/// cell make the rate smaller; as fast ones they would have lost more than others, by less than they are missing.
double systematic_of_rate(const Subject& subject) {
  const double r = subject.species().restitution;
  const double a2 = law::sonine_a2(subject.dimension(), r);
  const double closure = std::abs(a2 - law::sonine_a2_relinearised(subject.dimension(), r));
  const double cell = subject.particles_per_cell();
  return (closure + a2 * a2) / 4 + 2 / subject.particles() + (cell > 0 ? (1 - r) / cell : 0);
}

/// Energy of stable shear waves is not heat: where they hold a share f of it, all of it is lost more slowly by that, and
/// Haff's time scale, which a lower temperature stretches, is longer by 1.5 f. The law bounds f: half of it is expected,
/// half allowed. Nothing is said of a box in which a wave grows.
double half_of_shear_modes(const Subject& subject) {
  const double share = law::shear_mode_share(subject.gas(subject.scene().initial.temperature),
                                             subject.scene().domain.size, subject.particles());
  return std::isfinite(share) ? share / 2 : 0;
}

Evidence rate_evidence(const Mean& rate, const Subject& subject) {
  Evidence evidence;
  evidence.value = rate.value;
  evidence.standard_error = rate.standard_error;
  evidence.degrees_of_freedom = rate.degrees_of_freedom;
  evidence.budget.systematic = systematic_of_rate(subject);
  evidence.budget.reason =
      "first Sonine order, 2/N, repeated contacts and missing pairs inside a cell, shear waves";
  return evidence;
}

/// E/E0 against time or collisions. Mean over replicas of sqrt(E0/E), which grows evenly, at each sample.
Figure energy_figure(const Subject& subject, const Figure::Axis& axis, bool against_time,
                     const std::function<double(double)>& theory) {
  Figure figure{"Energy of the cooling gas", axis, {"E/E0", "1", true}, {}, {}};
  Figure::Points points{"measured", {}, {}, {}, {}};
  std::vector<Decay> decays;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    decays.push_back(decay_of(subject, replica));
  for (std::size_t i = 1; i < decays.front().time.size(); ++i) {
    std::vector<double> x, root;
    for (const Decay& decay : decays) {
      if (i >= decay.time.size()) continue;
      x.push_back(against_time ? decay.time[i] : decay.collisions[i]);
      root.push_back(std::sqrt(decay.energy.front() / decay.energy[i]));
    }
    const Mean mean = mean_of_independent(root);
    points.x.push_back(mean_of_independent(x).value);
    points.y.push_back(1 / (mean.value * mean.value));
    points.error.push_back(2 * mean.standard_error / std::pow(mean.value, 3));
    points.expected.push_back(theory(points.x.back()));
  }
  figure.lines.push_back({"theory", points.x, points.expected});
  figure.points.push_back(std::move(points));
  return figure;
}

Evidence haff_cooling(const Subject& subject, const law::Arguments& numbers) {
  const auto growth = [](const Decay& decay, std::size_t i) {
    const auto root = [&](std::size_t at) { return std::sqrt(decay.energy.front() / decay.energy[at]); };
    return (root(i) - root(i - 1)) / (decay.time[i] - decay.time[i - 1]);
  };
  const Mean rate = pooled(settled_rates(subject, numbers.at("settle-collisions"), growth));
  Evidence evidence = rate_evidence(rate, subject);
  evidence.units = "time";
  evidence.value = 1 / rate.value;
  evidence.standard_error = rate.standard_error / (rate.value * rate.value);
  const double waves = 1.5 * half_of_shear_modes(subject);
  const law::Bounded missing = subject.missing_pairs();
  const double scale = law::haff_time_scale_sonine(subject.gas(subject.scene().initial.temperature)) *
                       (1 + waves) / (1 - missing.value) /
                       contact_ratio(subject, numbers.at("contact-value"));
  evidence.expected = scale;
  evidence.budget.systematic = scale * (evidence.budget.systematic + waves + missing.bound);
  evidence.effect = scale;
  evidence.without = "no cooling";
  const auto theory = [scale](double time) { return law::haff_energy_ratio(time, scale); };
  evidence.figures.push_back(energy_figure(subject, {"time", "time", true}, true, theory));
  return evidence;
}

Evidence cooling_per_collision(const Subject& subject, const law::Arguments& numbers) {
  const auto loss = [](const Decay& decay, std::size_t i) {
    return std::log(decay.energy[i - 1] / decay.energy[i]) / (decay.collisions[i] - decay.collisions[i - 1]);
  };
  Evidence evidence =
      rate_evidence(pooled(settled_rates(subject, numbers.at("settle-collisions"), loss)), subject);
  const double r = subject.species().restitution;
  const double a2 = law::sonine_a2(subject.dimension(), r), waves = half_of_shear_modes(subject);
  evidence.expected = (1 - r * r) / subject.dimension() * law::sonine_cooling_factor(a2) /
                      law::sonine_collision_factor(a2) * (1 - waves);
  evidence.budget.systematic =
      evidence.expected * (evidence.budget.systematic + waves + subject.missing_pairs().value);
  evidence.effect = evidence.expected;
  evidence.without = "no cooling";
  const auto theory = [&](double collisions) { return std::exp(-evidence.expected * collisions); };
  evidence.figures.push_back(energy_figure(subject, {"collisions per particle", "1", false}, false, theory));
  return evidence;
}
}  // namespace

std::vector<CheckInfo> cooling_checks() {
  const law::Parameter settle{
      "settle-collisions", "1", "collisions per particle left out at the start", 0, 1e9, 10.0};
  return {{"haff-cooling",
           "time scale of the energy's decay against Haff's law with the Sonine correction",
           "haff-time-scale-sonine",
           {"energy", "collisions"},
           true,
           {settle, contact_number()},
           is_cooling,
           haff_cooling},
          {"cooling-per-collision",
           "energy lost per collision, whatever the collision rate",
           "haff-energy-ratio-of-collisions",
           {"energy", "collisions"},
           true,
           {settle},
           is_cooling,
           cooling_per_collision}};
}

}  // namespace sandglass
