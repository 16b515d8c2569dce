#include "validation/law/rough.hpp"

#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/inertia.hpp"
#include "validation/law/contact.hpp"
#include "validation/law/enskog.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sandglass {

namespace {
constexpr const char* kRotation = "rotational-temperature";

law::RoughGas rough_gas(const Subject& subject) {
  const Species& species = subject.species();
  const bool slides_freely = species.friction && *species.friction == 0;
  return {subject.dimension(), species.restitution, slides_freely ? -1 : species.tangential_restitution,
          inertia_of(species, subject.dimension())};
}

double freedom_of_rotation(const Subject& subject) { return subject.dimension() == 2 ? 1 : 3; }

/// One replica: granular temperatures over the translational one of the start.
struct Course {
  std::vector<double> time, collisions, translation, rotation;
};

Course course_of(const Subject& subject, std::size_t replica) {
  const Series& series = subject.series(replica, kRotation);
  Course course{series.time, subject.collisions_per_particle(replica, series),
                subject.column(replica, "temperature", "total"), series.value};
  const double start = course.translation.at(0);
  for (double& each : course.translation) each /= start;
  for (double& each : course.rotation) each /= start;
  return course;
}

law::Temperatures start_of(const Subject& subject) {
  return {1, subject.scene().initial.spin_temperature / subject.scene().initial.temperature};
}

/// Exponential between samples.
double at(const std::vector<double>& x, const std::vector<double>& y, double place) {
  const auto after = std::ranges::upper_bound(x, place);
  if (after == x.end() || after == x.begin()) return std::nan("");
  const auto i = static_cast<std::size_t>(after - x.begin());
  const double part = (place - x[i - 1]) / (x[i] - x[i - 1]);
  return std::exp((1 - part) * std::log(y[i - 1]) + part * std::log(y[i]));
}

Figure figure_of(const Subject& subject) {
  Figure figure{"Cooling of rough particles",
                {"collisions per particle", "1", false},
                {"granular temperature over that of the start", "1", true},
                {},
                {}};
  const Course course = course_of(subject, 0);
  Figure::Points translation{"translation", {}, {}, {}, {}}, rotation{"rotation", {}, {}, {}, {}};
  for (std::size_t i = 0; i < course.collisions.size(); ++i) {
    const double tau = course.collisions[i];
    const law::Temperatures theory = law::rough_cooling(rough_gas(subject), start_of(subject), tau);
    const auto add = [&](Figure::Points& points, double value, double expected, double freedom) {
      points.x.push_back(tau);
      points.y.push_back(value);
      points.error.push_back(value * std::sqrt(2 / (freedom * subject.particles())));
      points.expected.push_back(expected);
    };
    add(translation, course.translation[i], theory.translation, subject.dimension());
    add(rotation, course.rotation[i], theory.rotation, freedom_of_rotation(subject));
  }
  for (const Figure::Points* points : {&translation, &rotation})
    figure.lines.push_back({"mean field, " + points->name, points->x, points->expected});
  figure.points = {translation, rotation};
  return figure;
}

/// Mean over replicas of `value`, relative errors of the theory left to the case.
template <class Value>
Evidence over_replicas(const Subject& subject, double expected, Value value) {
  std::vector<double> values;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    values.push_back(value(course_of(subject, replica)));
  Evidence evidence = from_mean(mean_of_independent(values), expected);
  evidence.budget.systematic = 2 / subject.particles() * expected;
  evidence.budget.reason = "2/N";
  return evidence;
}

Evidence translation_after(const Subject& subject, const law::Arguments& numbers) {
  const double tau = numbers.at("collisions");
  const double expected = law::rough_cooling(rough_gas(subject), start_of(subject), tau).translation;
  Evidence evidence = over_replicas(subject, expected,
                                    [tau](const Course& c) { return at(c.collisions, c.translation, tau); });
  evidence.figures.push_back(figure_of(subject));
  return evidence;
}

Evidence rotation_after(const Subject& subject, const law::Arguments& numbers) {
  const double tau = numbers.at("collisions");
  const double expected = law::rough_cooling(rough_gas(subject), start_of(subject), tau).rotation;
  return over_replicas(subject, expected,
                       [tau](const Course& c) { return at(c.collisions, c.rotation, tau); });
}

/// Enskog's rate; that of points where nothing raises it.
double rate_at(const Subject& subject, double temperature) {
  law::Gas gas = subject.gas(temperature);
  const double enskog = law::collision_rate(gas) * subject.pair_factor();
  return has_contact_value(subject.scene()) ? enskog
                                            : enskog / law::contact_value(gas.dimension, gas.fraction);
}

double mean_free_time(const Subject& subject) {
  return 1 / rate_at(subject, subject.scene().initial.temperature);
}

/// At the temperature of each moment, which spins let fluctuate.
Evidence collision_rate(const Subject& subject, const law::Arguments&) {
  std::vector<std::vector<double>> ratios;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Course course = course_of(subject, replica);
    const auto temperature = subject.column(replica, "temperature", "total");
    ratios.emplace_back();
    for (std::size_t i = 1; i < course.time.size(); ++i)
      ratios.back().push_back((course.collisions[i] - course.collisions[i - 1]) /
                              (course.time[i] - course.time[i - 1]) /
                              rate_at(subject, (temperature[i] + temperature[i - 1]) / 2));
  }
  const law::Bounded missing = subject.missing_pairs();
  Evidence evidence = from_mean(pooled(ratios), 1 - missing.value);
  evidence.budget.systematic = missing.bound + 2 / subject.particles();
  evidence.budget.reason = "pairs that an offset takes from a cell, between the limits of pair_deficit; 2/N";
  return evidence;
}
Evidence energy_in_time(const Subject& subject, const law::Arguments& numbers) {
  const double turning = freedom_of_rotation(subject), moving = subject.dimension();
  const auto energy = [&](const law::Temperatures& now) {
    return (moving * now.translation + turning * now.rotation) / (moving + turning);
  };
  const double times = numbers.at("mean-free-times"), time = times * mean_free_time(subject);
  const double expected = energy(law::rough_cooling_in_time(rough_gas(subject), start_of(subject), times));
  return over_replicas(subject, expected, [&](const Course& c) {
    return energy({at(c.time, c.translation, time), at(c.time, c.rotation, time)});
  });
}

Evidence temperature_ratio(const Subject& subject, const law::Arguments& numbers) {
  std::vector<std::vector<double>> ratios;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Course course = course_of(subject, replica);
    ratios.emplace_back();
    for (std::size_t i = 0; i < course.collisions.size(); ++i)
      if (course.collisions[i] >= numbers.at("settle-collisions"))
        ratios.back().push_back(course.rotation[i] / course.translation[i]);
  }
  const double expected = law::rough_temperature_ratio(rough_gas(subject));
  Evidence evidence = from_mean(pooled(ratios), expected);
  evidence.budget.systematic = 2 / subject.particles() * expected;
  evidence.budget.reason = "2/N";
  return evidence;
}

/// Largest relative drift; rounding as of the checks of conservation, for three rounded sums a collision more.
Evidence energy_conservation(const Subject& subject, const law::Arguments&) {
  double largest = 0, collisions = 0;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const auto moving = subject.column(replica, "energy", ""),
               turning = subject.column(replica, "rotational-energy", "");
    for (std::size_t i = 1; i < moving.size(); ++i)
      largest =
          std::max(largest, std::abs((moving[i] + turning[i]) / (moving.front() + turning.front()) - 1));
    collisions = std::max(collisions,
                          subject.collisions_per_particle(replica, subject.series(replica, "energy")).back());
  }
  Evidence evidence;
  evidence.value = largest;
  evidence.budget.systematic =
      2 * std::numeric_limits<double>::epsilon() * (4 * subject.particles() + 24 * collisions);
  evidence.budget.reason = "rounding of sums and collisions";
  return evidence;
}

Evidence rotation_kept(const Subject& subject, const law::Arguments&) {
  double largest = 0;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const auto turning = subject.column(replica, "rotational-energy", "");
    for (const double each : turning) largest = std::max(largest, std::abs(each / turning.front() - 1));
  }
  Evidence evidence;
  evidence.value = largest;
  evidence.budget.systematic = 2 * std::numeric_limits<double>::epsilon() * subject.particles();
  evidence.budget.reason = "rounding of a sum over particles";
  return evidence;
}

/// A uniform gas of one species that spins.
bool spins(const Scene& scene) {
  Scene smooth = scene;
  for (Species& species : smooth.species) species.tangential_restitution = -1;
  return is_rough(scene) && is_uniform(smooth) && scene.given.empty() && !scene.initial.shear_wave &&
         guard_of(scene.method).kind == CollapseGuard::none;
}

bool slides_never(const Scene& scene) {
  const auto& friction = scene.species.front().friction;
  return spins(scene) && (!friction || *friction == 0);
}

bool is_smooth_with_spins(const Scene& scene) {
  return spins(scene) && scene.species.front().friction && *scene.species.front().friction == 0;
}

bool keeps_energy(const Scene& scene) {
  const Species& species = scene.species.front();
  return spins(scene) && species.restitution == 1 &&
         (is_smooth_with_spins(scene) || (species.tangential_restitution == 1 && !species.friction));
}

bool exchanges(const Scene& scene) { return slides_never(scene) && !is_smooth_with_spins(scene); }
}  // namespace

std::vector<CheckInfo> rough_checks() {
  const law::Parameter settle{
      "settle-collisions", "1", "collisions per particle left out at the start", 0, 1e9, 10.0};
  const law::Parameter collisions{"collisions", "1", "per particle, when the temperature is read", 0, 1e9};
  const std::vector<std::string> temperatures{"temperature", kRotation, "collisions"};
  return {{"rough-translation",
           "translational temperature after some collisions per particle against mean field",
           "rough-translation",
           temperatures,
           true,
           {collisions},
           slides_never,
           translation_after},
          {"rough-rotation",
           "rotational temperature after some collisions per particle against mean field",
           "rough-rotation",
           temperatures,
           true,
           {collisions},
           slides_never,
           rotation_after},
          {"rough-energy-in-time",
           "energy of translation and rotation after some mean free times of the start, dilute",
           "rough-translation-in-time",
           temperatures,
           true,
           {{"mean-free-times", "1", "of the start", 0, 1e6}},
           slides_never,
           energy_in_time},
          {"rough-temperature-ratio",
           "rotational over translational temperature after many collisions",
           "rough-temperature-ratio",
           temperatures,
           true,
           {settle},
           exchanges,
           temperature_ratio},
          {"rough-collision-rate",
           "collisions per time of a gas of rough particles that keep their energy over Enskog's, or that of "
           "points",
           "enskog-collision-rate",
           temperatures,
           true,
           {},
           keeps_energy,
           collision_rate},
          {"rough-energy-conservation",
           "largest drift of the energy of translation and rotation where contacts keep it",
           "",
           {"energy", "rotational-energy", "collisions"},
           false,
           {},
           keeps_energy,
           energy_conservation},
          {"rotation-kept",
           "largest drift of the rotational energy where nothing turns particles",
           "",
           {"rotational-energy"},
           false,
           {},
           is_smooth_with_spins,
           rotation_kept}};
}

}  // namespace sandglass
