#include "sim/base/error.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/vibrated_bed.hpp"

#include <algorithm>

// Power that bottom, walls and collisions exchange with a vibrated bed. What the walls carry: weight-on-floor.

namespace sandglass {

namespace {
/// Share of the power: a particle that a step leaves on the bottom after 200 hits (docs/motion.md) is lifted by the way that
/// the bottom goes in what is left of the step, and the work is counted at its velocity when that begins. Seen: 6e-9.
constexpr double kLastBounces = 1e-6;

/// Samples from a time on, with the time that each stands for.
struct Window {
  std::size_t first, last;
  double begin, end;
};

Window window_of(const Series& series, double from) {
  const auto first = static_cast<std::size_t>(std::lower_bound(series.time.begin(), series.time.end(), from) -
                                              series.time.begin());
  if (first + 2 > series.samples())
    throw InputError("fewer than two samples after 'settle-share': run longer or sample more often");
  return {first, series.samples() - 1, series.time[first], series.time.back()};
}

/// Energy through a wall in the window, as `wall-power` or `wall-heat` has it: a sample is the mean since the one before.
double energy_through(const Subject& subject, std::size_t replica, const std::string& quantity,
                      const std::string& side, double from) {
  const Series& series = subject.series(replica, quantity);
  const std::vector<double> power = subject.column(replica, quantity, side);
  const Window window = window_of(series, from);
  double energy = 0;
  for (std::size_t i = window.first + 1; i <= window.last; ++i)
    energy += power[i] * (series.time[i] - series.time[i - 1]);
  return energy;
}

/// Change of a quantity from the first to the last sample of the window, and its mean.
struct Change {
  double change, mean;
};

Change change_of(const Subject& subject, std::size_t replica, const std::string& quantity,
                 const std::string& component, double from) {
  const Window window = window_of(subject.series(replica, quantity), from);
  const std::vector<double> values = subject.column(replica, quantity, component);
  double sum = 0;
  for (std::size_t i = window.first; i <= window.last; ++i) sum += values[i];
  return {values[window.last] - values[window.first],
          sum / static_cast<double>(window.last - window.first + 1)};
}

/// Work of all walls that neither they take back as heat nor the bed keeps nor collisions take, over the work of the
/// bottom. A collision takes (1 - r^2) T on average.
double imbalance(const Subject& subject, std::size_t replica, double from) {
  const std::string axis = vertical_name(subject.scene());
  const double bottom = energy_through(subject, replica, "wall-power", axis + "-low", from);
  double rest = 0;
  for (const std::string& side : subject.series(replica, "wall-power").quantity.components)
    rest += energy_through(subject, replica, "wall-power", side, from) -
            energy_through(subject, replica, "wall-heat", side, from);
  const Species& species = subject.species();
  const double real = subject.particles() * subject.scene().method.weight;
  const Change kinetic = change_of(subject, replica, "energy", "", from);
  rest -= kinetic.change;
  rest -= real * species.mass * bed_of(subject).gravity *
          change_of(subject, replica, "centre-of-mass", axis, from).change;
  const double temperature = 2 * kinetic.mean / (real * subject.dimension());
  const double collisions =
      change_of(subject, replica, "collisions", "", from).change * subject.scene().method.weight;
  rest -= (1 - species.restitution * species.restitution) * temperature * collisions;
  return rest / bottom;
}

Evidence power(const Subject& subject, const law::Arguments& numbers) {
  std::vector<double> imbalances;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    imbalances.push_back(imbalance(subject, replica, settled_from(subject, numbers)));
  Evidence evidence = from_mean(mean_of_independent(imbalances), 0);
  const bool elastic = subject.species().restitution == 1;
  evidence.budget.systematic = elastic ? kLastBounces : law::vibrated_bed_expansion(bed_of(subject));
  evidence.budget.reason = elastic ? "rounding, and who rests on the bottom for the rest of a step"
                                   : "one temperature in the whole bed, to order <U^2> m/T";
  evidence.summary = "power of all walls less what they and collisions take, over the power of the bottom";
  return evidence;
}
}  // namespace

std::vector<CheckInfo> vibrated_bed_flow_checks() {
  const law::Parameter settle{"settle-share", "1", "share of the run that is left out", 0, 0.9, 0.25};
  return {{"vibrated-bed-power",
           "power of the walls of a vibrated bed less what they and its collisions take, over the power of "
           "the bottom",
           "",
           {"wall-power", "wall-heat", "energy", "centre-of-mass", "collisions"},
           false,
           {settle},
           is_vibrated_bed,
           power}};
}

}  // namespace sandglass
