#include "validation/law/mixture.hpp"

#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/finite_size.hpp"
#include "validation/check/worst.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass {

namespace {
constexpr const char* kTemperature = "species-temperature";
constexpr const char* kCollisions = "species-collisions";

std::vector<law::Component> components(const Scene& scene) {
  std::vector<law::Component> all;
  for (const Species& species : scene.species)
    all.push_back(
        {number_density(scene, species), species.diameter, species.mass, scene.initial.temperature});
  return all;
}

/// 1 where particles are points.
double contact_value(const Subject& subject, std::size_t i, std::size_t j) {
  if (!has_contact_value(subject.scene())) return 1;
  return law::mixture_contact_value(subject.dimension(), components(subject.scene()), i, j);
}

/// Of one component over all replicas, without what comes before `settle` collisions per particle.
Mean settled_mean(const Subject& subject, const std::string& quantity, std::size_t component, double settle) {
  std::vector<std::vector<double>> samples;
  const double particles = static_cast<double>(particle_count(subject.scene()));
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const std::vector<double> collisions = subject.column(replica, "collisions", "");
    const Series& series = subject.series(replica, quantity);
    samples.emplace_back();
    for (std::size_t i = 0; i < series.samples(); ++i)
      if (2 * collisions.at(i) / particles >= settle)
        samples.back().push_back(series.value[i * series.quantity.size() + component]);
  }
  return pooled(samples);
}

/// Collisions of a pair of species per time, one value an interval.
Mean pair_rate(const Subject& subject, std::size_t pair) {
  std::vector<std::vector<double>> rates;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Series& series = subject.series(replica, kCollisions);
    const std::size_t width = series.quantity.size();
    rates.emplace_back();
    for (std::size_t i = 1; i < series.samples(); ++i)
      rates.back().push_back((series.value[i * width + pair] - series.value[(i - 1) * width + pair]) /
                             (series.time[i] - series.time[i - 1]));
  }
  return pooled(rates);
}

Mean over(Mean mean, double unit) {
  mean.value /= unit;
  mean.standard_error /= unit;
  return mean;
}

/// Every pair of species; a particle has N - 1 partners of its own species.
Evidence collision_rates(const Subject& subject, const law::Arguments&) {
  const Scene& scene = subject.scene();
  const auto all = components(scene);
  const double freedom = subject.dimension() * (static_cast<double>(particle_count(scene)) - 1);
  WorstRatio worst;
  std::size_t pair = 0;
  double fewest = HUGE_VAL;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i; j < all.size(); ++j, ++pair) {
      const double count = static_cast<double>(particle_count(scene, scene.species[i]));
      fewest = std::min(fewest, count);
      const double partners = i == j ? (count - 1) / count / 2 : 1;
      const double expected =
          count * partners * relative_speed_factor(freedom) *
          law::mixture_collision_rate(subject.dimension(), all[i], all[j], contact_value(subject, i, j));
      worst.offer(over(pair_rate(subject, pair), expected), "");
    }
  Evidence evidence = worst.evidence();
  if (capabilities(scene).contacts) evidence.budget.systematic = 2 / fewest;
  evidence.budget.reason = "contact value at fixed numbers, O(1/N)";
  return evidence;
}

Evidence equipartition(const Subject& subject, const law::Arguments&) {
  WorstRatio worst;
  for (std::size_t i = 0; i < subject.scene().species.size(); ++i)
    worst.offer(over(settled_mean(subject, kTemperature, i, 0), subject.scene().initial.temperature), "");
  return worst.evidence();
}

/// Mean over replicas and samples of T_1/T_2.
Evidence temperature_ratio(const Subject& subject, const law::Arguments& numbers) {
  const double particles = static_cast<double>(particle_count(subject.scene()));
  std::vector<std::vector<double>> ratios;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const std::vector<double> collisions = subject.column(replica, "collisions", "");
    const Series& series = subject.series(replica, kTemperature);
    ratios.emplace_back();
    for (std::size_t i = 0; i < series.samples(); ++i)
      if (2 * collisions.at(i) / particles >= numbers.at("settle-collisions"))
        ratios.back().push_back(series.value[2 * i] / series.value[2 * i + 1]);
  }
  const auto all = components(subject.scene());
  Evidence evidence = from_mean(
      pooled(ratios),
      law::mixture_temperature_ratio(
          subject.dimension(), subject.species().restitution, all[0], all[1],
          {contact_value(subject, 0, 0), contact_value(subject, 0, 1), contact_value(subject, 1, 1)}));
  evidence.budget.systematic = 2 / particles * evidence.expected;
  evidence.budget.reason = "2/N";
  return evidence;
}

Evidence compressibility(const Subject& subject, const law::Arguments&) {
  std::vector<std::vector<double>> samples;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const std::vector<double> kinetic = subject.column(replica, "pressure", "kinetic");
    const std::vector<double> collisional = subject.column(replica, "pressure", "collisional");
    samples.emplace_back();
    for (std::size_t i = 1; i < kinetic.size(); ++i)
      samples.back().push_back(1 + collisional[i] / kinetic[i]);
  }
  const double expected = has_contact_value(subject.scene())
                              ? law::mixture_compressibility(subject.dimension(), components(subject.scene()))
                              : 1;
  Evidence evidence = from_mean(pooled(samples), expected);
  evidence.budget.systematic = 2 / static_cast<double>(particle_count(subject.scene())) * (expected - 1);
  evidence.budget.reason = "contact value at fixed numbers, O(1/N)";
  return evidence;
}

bool is_mixture(const Scene& scene) {
  Scene one = scene;
  one.species.resize(1);
  return scene.species.size() > 1 && is_uniform(one) && !is_rough(scene) && scene.given.empty() &&
         !scene.initial.shear_wave && guard_of(scene.method).kind == CollapseGuard::none;
}

bool is_elastic_mixture(const Scene& scene) {
  return is_mixture(scene) && scene.initial.exact &&
         std::ranges::all_of(scene.species, [](const Species& each) { return each.restitution == 1; });
}

/// Two species of one restitution, which every pair then has.
bool is_cooling_pair(const Scene& scene) {
  return is_mixture(scene) && scene.species.size() == 2 && scene.species[0].restitution < 1 &&
         scene.species[0].restitution == scene.species[1].restitution;
}
}  // namespace

std::vector<CheckInfo> mixture_checks() {
  const law::Parameter settle{
      "settle-collisions", "1", "collisions per particle left out at the start", 0, 1e9, 10.0};
  return {{"species-collision-rates",
           "collisions of each pair of species per time against theory, the worst of all",
           "mixture-collision-rate",
           {kCollisions},
           true,
           {},
           is_elastic_mixture,
           collision_rates},
          {"species-equipartition",
           "temperature of each species of an elastic mixture over that of all, the worst",
           "",
           {kTemperature, "collisions"},
           true,
           {},
           is_elastic_mixture,
           equipartition},
          {"species-temperature-ratio",
           "temperature of the first species over that of the second in a cooling mixture",
           "mixture-temperature-ratio",
           {kTemperature, "collisions"},
           true,
           {settle},
           is_cooling_pair,
           temperature_ratio},
          {"mixture-compressibility",
           "pressure over kinetic pressure of an elastic mixture",
           "mixture-compressibility",
           {"pressure"},
           true,
           {},
           is_elastic_mixture,
           compressibility}};
}

}  // namespace sandglass
