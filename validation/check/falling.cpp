#include "validation/check/falling.hpp"

#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/worst.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// Momentum under gravity. Collisions keep it, so that walls and gravity alone change it: exact identities for every
// method, to rounding.

namespace sandglass {

bool falls_to_floor(const Scene& scene) {
  const int axis = vertical_axis(scene);
  return capabilities(scene).particles && scene.species.size() == 1 && axis >= 0 && scene.obstacles.empty() &&
         scene.sources.empty() && !has_open_side(scene.domain) &&
         !is_periodic_along(scene, static_cast<std::size_t>(axis));
}

namespace {
std::string vertical(const Subject& subject) {
  return std::string(1, static_cast<char>('x' + vertical_axis(subject.scene())));
}

/// Force of the particles on all walls along the axis.
std::vector<double> force_along(const Subject& subject, std::size_t replica, const std::string& axis) {
  const Series& series = subject.series(replica, "wall-force");
  std::vector<double> force(series.samples(), 0.0);
  for (const std::string& component : series.quantity.components) {
    if (!component.ends_with("-" + axis)) continue;
    const std::vector<double> one = subject.column(replica, "wall-force", component);
    for (std::size_t i = 0; i < one.size(); ++i) force[i] += one[i];
  }
  return force;
}

double gravity(const Subject& subject) {
  return -subject.scene().gravity[static_cast<std::size_t>(vertical_axis(subject.scene()))];
}

double real_particles(const Subject& subject) { return subject.particles() * subject.scene().method.weight; }

double counter(const Subject& subject, std::size_t replica, const std::string& name) {
  const auto& counters = subject.record().replicas[replica].counters;
  const auto found = counters.find(name);
  return found == counters.end() ? 0 : found->second;
}

/// What particles did not gain because their moves were refused: such a particle feels no gravity in that step (Mueller
/// 2001, section 2.3.2).
double missing_weight(const Subject& subject, std::size_t replica) {
  const double refused = counter(subject, replica, "moves-refused");
  if (refused == 0) return 0;
  if (!subject.scene().method.time_step.fixed)
    throw InputError("the weight of refused moves needs a fixed step: give 'method.time-step' as a time");
  return refused * subject.scene().method.weight * subject.species().mass * gravity(subject) *
         *subject.scene().method.time_step.fixed;
}

/// Relative to `scale`: a sum over N particles twice, and a few rounded operations of every particle at each of its
/// collisions and steps, as in conservation.cpp.
double rounding_bound(const Subject& subject, std::size_t replica, double scale) {
  const std::vector<double> all = subject.column(replica, "momentum-scale", "");
  const double changes =
      2 * counter(subject, replica, "collisions") / subject.particles() + counter(subject, replica, "steps");
  return std::numeric_limits<double>::epsilon() * (2 * subject.particles() + 12 * changes) *
         *std::max_element(all.begin(), all.end()) / scale;
}

double total(const std::vector<double>& impulse, std::size_t after) {
  double sum = 0;
  for (std::size_t i = after + 1; i < impulse.size(); ++i) sum += impulse[i];
  return sum;
}

/// What the walls must have given since a sample.
double expected_impulse(const Subject& subject, const Fall& fall, std::size_t since) {
  const law::FallingParticles all = particles_at(subject, fall, since);
  return law::floor_impulse(all, fall.time.back() - fall.time[since],
                            fall.momentum.back() / (all.count * all.mass));
}

double weight_over_time(const Subject& subject, const Fall& fall) {
  return real_particles(subject) * subject.species().mass * gravity(subject) * fall.time.back();
}

Evidence exact(double deviation, double bound) {
  Evidence evidence;
  evidence.value = deviation;
  evidence.budget.systematic = bound;
  evidence.budget.reason = "rounding of sums, collisions and steps";
  return evidence;
}

Evidence momentum_under_gravity(const Subject& subject, const law::Arguments&) {
  double worst = 0, bound = 0;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Fall fall = fall_of(subject, replica);
    const double scale = weight_over_time(subject, fall);
    const double expected = expected_impulse(subject, fall, 0) - missing_weight(subject, replica);
    keep_worst(worst, std::abs(total(fall.impulse, 0) - expected) / scale);
    bound = std::max(bound, rounding_bound(subject, replica, scale));
  }
  return exact(worst, bound);
}

/// First sample not before a time; the last but one at the latest.
std::size_t sample_from(const Fall& fall, double time) {
  const auto found = std::lower_bound(fall.time.begin(), fall.time.end() - 1, time);
  if (found == fall.time.end() - 1)
    throw InputError("no sample from 'settle-time' on but the last: run longer or lower it");
  return static_cast<std::size_t>(found - fall.time.begin());
}

Evidence weight_on_floor(const Subject& subject, const law::Arguments& numbers) {
  std::vector<double> ratios;
  double bound = 0;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Fall fall = fall_of(subject, replica);
    const std::size_t since = sample_from(fall, numbers.at("settle-time"));
    const double expected = expected_impulse(subject, fall, since);
    ratios.push_back(total(fall.impulse, since) / expected);
    bound = std::max(bound, rounding_bound(subject, replica, expected));
  }
  Evidence evidence = from_mean(mean_of_independent(ratios), 1);
  evidence.budget.systematic = bound;
  evidence.budget.reason = "rounding of sums, collisions and steps";
  return evidence;
}

/// Largest departure from the law before a wall acts, over the height of the start; NaN when one acts before the second
/// sample.
double departure(const Subject& subject, const Fall& fall) {
  const law::FallingParticles all = particles_at(subject, fall, 0);
  double worst = 0;
  std::size_t i = 1;
  for (; i < fall.time.size() && fall.impulse[i] == 0; ++i)
    keep_worst(worst,
               std::abs(fall.height[i] - law::falling_height(all, fall.time[i] - fall.time[0])) / all.height);
  return i > 1 ? worst : std::numeric_limits<double>::quiet_NaN();
}

Evidence free_fall(const Subject& subject, const law::Arguments&) {
  double worst = 0, bound = 0;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Fall fall = fall_of(subject, replica);
    keep_worst(worst, departure(subject, fall));
    bound = std::max(bound, rounding_bound(subject, replica, weight_over_time(subject, fall)));
  }
  return exact(worst, bound);
}
}  // namespace

Fall fall_of(const Subject& subject, std::size_t replica) {
  const Series& centre = subject.series(replica, "centre-of-mass");
  const Series& walls = subject.series(replica, "wall-force");
  Fall fall{centre.time,
            subject.column(replica, "centre-of-mass", vertical(subject)),
            subject.column(replica, "momentum", vertical(subject)),
            {0}};
  if (fall.time != subject.series(replica, "momentum").time || fall.time.size() != walls.time.size() + 1 ||
      !std::equal(walls.time.begin(), walls.time.end(), fall.time.begin() + 1))
    throw InputError(
        "'centre-of-mass', 'momentum' and 'wall-force' are sampled at different times: give them the same "
        "'every'");
  const std::vector<double> force = force_along(subject, replica, vertical(subject));
  for (std::size_t i = 0; i < force.size(); ++i)
    fall.impulse.push_back(-force[i] * (fall.time[i + 1] - fall.time[i]));
  return fall;
}

double cell_edge(const Subject& subject) {
  const std::vector<double> cells = cells_along(subject.scene());
  const auto axis = static_cast<std::size_t>(vertical_axis(subject.scene()));
  return cells.empty() ? 0 : subject.scene().domain.size[axis] / cells[axis];
}

law::FallingParticles particles_at(const Subject& subject, const Fall& fall, std::size_t sample) {
  const double count = real_particles(subject), mass = subject.species().mass;
  return {count, mass, gravity(subject), fall.height[sample], fall.momentum[sample] / (count * mass)};
}

std::vector<CheckInfo> falling_checks() {
  const std::vector<std::string> needs = {"centre-of-mass", "momentum", "momentum-scale", "wall-force"};
  const law::Parameter settle{"settle-time", "time", "samples before it are left out", 0, 1e12, 0.0};
  return {{"free-fall",
           "height of the centre of mass until the first particle hits a wall, largest departure from free "
           "fall over its height at the start",
           "falling-height",
           needs,
           false,
           {},
           falls_to_floor,
           free_fall},
          {"momentum-under-gravity",
           "impulse of all walls against weight and gain of momentum, less the weight of refused moves, over "
           "the impulse of the weight",
           "floor-impulse",
           needs,
           false,
           {},
           falls_to_floor,
           momentum_under_gravity},
          {"weight-on-floor",
           "impulse of the walls over that of the weight less the gain of momentum",
           "floor-impulse",
           needs,
           true,
           {settle},
           falls_to_floor,
           weight_on_floor}};
}

}  // namespace sandglass
