#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/law/contact.hpp"
#include "validation/law/transport.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sandglass {

namespace {
/// Amplitudes of the wave after the start has settled, one row a replica, at times that all replicas share.
struct Wave {
  std::vector<double> time;
  std::vector<std::vector<double>> amplitude;  ///< [replica][sample]
};

Wave wave_of(const Subject& subject, double settle) {
  const Series& series = subject.series(0, "shear-mode");
  const std::vector<double> tau = subject.collisions_per_particle(0, series);
  const auto first = std::lower_bound(tau.begin(), tau.end(), settle) - tau.begin();
  if (tau.end() - tau.begin() - first < 2)
    throw InputError(
        "the wave is sampled too rarely: at least two samples after 'settle-collisions' are needed");
  Wave wave{{series.time.begin() + first, series.time.end()}, {}};
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    if (subject.series(replica, "shear-mode").step != series.step ||
        subject.series(replica, "shear-mode").time != series.time)
      throw InputError("the replicas sample the wave at different times: give 'method.time-step' as a time");
    const std::vector<double> all = subject.column(replica, "shear-mode", "");
    wave.amplitude.emplace_back(all.begin() + first, all.end());
  }
  return wave;
}

double wave_number(const Scene& scene) {
  return 2 * std::numbers::pi * scene.initial.shear_wave->periods / scene.domain.size.at(1);
}

double mean_amplitude(const Wave& wave, std::size_t sample, std::span<const std::size_t> replicas) {
  double sum = 0;
  for (std::size_t replica : replicas) sum += wave.amplitude[replica].at(sample);
  return sum / static_cast<double>(replicas.size());
}

/// Decay rate from A(t+dt) = exp(-rate dt) A(t). Both sides are weighted with the wave that theory expects,
/// so that late, noisy samples count little; the estimate is a ratio of sums that are linear in the data,
/// free of the bias that a logarithm of noise has.
double decay_rate(const Wave& wave, double expected_rate, std::span<const std::size_t> replicas) {
  double before = 0, after = 0;
  for (std::size_t i = 1; i < wave.time.size(); ++i) {
    const double weight = std::exp(-expected_rate * (wave.time[i - 1] - wave.time.front()));
    before += weight * mean_amplitude(wave, i - 1, replicas);
    after += weight * mean_amplitude(wave, i, replicas);
  }
  const double interval = (wave.time.back() - wave.time.front()) / static_cast<double>(wave.time.size() - 1);
  return -std::log(after / before) / interval;
}

Figure wave_figure(const Wave& wave, double rate) {
  Figure figure{
      "Decay of the shear wave", {"time", "time", false}, {"amplitude", "length/time", true}, {}, {}};
  Figure::Points points{"measured", wave.time, {}, {}, {}};
  double start = 0;
  for (std::size_t i = 0; i < wave.time.size(); ++i) {
    std::vector<double> values;
    for (const std::vector<double>& replica : wave.amplitude) values.push_back(replica.at(i));
    const Mean mean = mean_of_independent(values);
    if (i == 0) start = mean.value;
    points.y.push_back(mean.value);
    points.error.push_back(mean.standard_error);
    points.expected.push_back(start * std::exp(-rate * (wave.time[i] - wave.time.front())));
  }
  figure.lines.push_back({"theory", points.x, points.expected});
  figure.points.push_back(std::move(points));
  return figure;
}

/// Relative rise of the viscosity because the lost energy of the wave becomes heat. The wave holds m A^2/4 a
/// particle, D/2 of temperature each; the viscosity grows with the root of it. Averaged over the run as
/// decay_rate() weights it.
double heating(const Subject& subject, const Wave& wave, double expected_rate) {
  const double amplitude = subject.scene().initial.shear_wave->amplitude;
  const double full = amplitude * amplitude * subject.species().mass / (2 * subject.dimension()) /
                      subject.scene().initial.temperature;
  double weights = 0, heated = 0;
  for (const double time : wave.time) {
    const double remaining = std::exp(-2 * expected_rate * time);  // of the wave's energy
    weights += remaining;
    heated += remaining * (1 - remaining);
  }
  return std::sqrt(1 + full * heated / weights) - 1;
}

/// Collision rate over that of the dilute gas.
double contact_factor(const Subject& subject) {
  const law::Gas gas = subject.gas(subject.scene().initial.temperature);
  return has_contact_value(subject.scene()) ? law::contact_value(gas.dimension, gas.fraction) : 1;
}

/// Relative departure from the Navier-Stokes decay. To second order a stress that relaxes in the time eta0/(g n T) gives
/// nu k^2 (1 + q), a distribution that does (BGK) gives nu k^2 (1 - q), q the decay in such a time; what is carried over a
/// diameter sees sin^2(kd/2)/(kd/2)^2 of the gradient: (kd)^2/12 less.
double departure(const Subject& subject, double viscosity) {
  const law::Gas gas = subject.gas(subject.scene().initial.temperature);
  const double relaxation = law::boltzmann_shear_viscosity(gas, law::SonineOrder::first) /
                            (contact_factor(subject) * law::number_density(gas) * gas.temperature);
  const double k = wave_number(subject.scene());
  return k * k * viscosity * relaxation + std::pow(k * gas.diameter, 2) / 12;
}

/// Holds the decay of the wave against a viscosity.
Evidence decay_against(const Subject& subject, const law::Arguments& numbers, double viscosity) {
  const double square = std::pow(wave_number(subject.scene()), 2);
  const Wave wave = wave_of(subject, numbers.at("settle-collisions"));
  const Mean decay = jackknife(subject.replicas(), [&](std::span<const std::size_t> replicas) {
    return decay_rate(wave, viscosity * square, replicas);
  });
  Evidence evidence;
  evidence.units = "length^2/time";
  evidence.value = decay.value / square;
  evidence.standard_error = decay.standard_error / square;
  evidence.degrees_of_freedom = decay.degrees_of_freedom;
  const double heat = heating(subject, wave, viscosity * square);
  evidence.expected = viscosity * (1 + heat);
  evidence.budget.systematic = (heat / 2 + departure(subject, viscosity)) * viscosity;
  evidence.budget.reason =
      "half of the correction for heating, and the second order in k times the mean free path";
  evidence.figures.push_back(wave_figure(wave, evidence.expected * square));
  return evidence;
}

Evidence shear_wave_viscosity(const Subject& subject, const law::Arguments& numbers) {
  const law::Gas gas = subject.gas(subject.scene().initial.temperature);
  return decay_against(subject, numbers, law::enskog_kinematic_viscosity(gas, law::SonineOrder::converged));
}

law::CellScheme scheme_of(const Subject& subject) {
  const Scene& scene = subject.scene();
  const double diameter = subject.species().diameter;
  return {.contact = contact_factor(subject),
          .along = offset_along(scene, diameter, 1) / diameter,
          .random = random_offset(scene),
          .cell_edge = scene.domain.size.at(1) / cells_along(scene).at(1) / diameter,
          .collisions_per_step = subject.collisions_per_step()};
}

Evidence monte_carlo_viscosity(const Subject& subject, const law::Arguments& numbers) {
  const law::Gas gas = subject.gas(subject.scene().initial.temperature);
  return decay_against(
      subject, numbers,
      law::monte_carlo_kinematic_viscosity(gas, scheme_of(subject), law::SonineOrder::converged));
}

bool is_shear_wave(const Scene& scene) {
  return is_uniform(scene) && scene.species.front().restitution == 1 && scene.initial.shear_wave.has_value();
}

bool is_monte_carlo_shear_wave(const Scene& scene) {
  return is_shear_wave(scene) && capabilities(scene).cells && !has_partners_at_contact(scene) &&
         !has_full_cells(scene);
}
}  // namespace

std::vector<CheckInfo> shear_checks() {
  const law::Parameter settle{
      "settle-collisions", "1", "collisions per particle left out at the start", 0, 1e9, 5.0};
  return {{"shear-wave-viscosity",
           "decay of a sine of velocity against the kinematic viscosity",
           "kinematic-viscosity-converged",
           {"shear-mode", "collisions"},
           true,
           {settle},
           is_shear_wave,
           shear_wave_viscosity},
          {"monte-carlo-viscosity",
           "decay of a sine of velocity against what the method's own collisions make of viscosity",
           "monte-carlo-kinematic-viscosity",
           {"shear-mode", "collisions"},
           true,
           {settle},
           is_monte_carlo_shear_wave,
           monte_carlo_viscosity}};
}

}  // namespace sandglass
