#include "sim/base/error.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/vibrated_bed.hpp"

#include <algorithm>

// What floor, walls and collisions exchange with a vibrated bed: weight and power. Both hold for every method.

namespace sandglass {

namespace {
Evidence weight(const Subject& subject, const law::Arguments& numbers) {
  const std::string axis = vertical_name(subject.scene());
  std::vector<std::vector<double>> forces;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const auto force = [&](const std::string& side) {
      return late_samples(subject, replica, "wall-force", axis + side + axis, settled_from(subject, numbers));
    };
    std::vector<double> down = force("-low-");
    const std::vector<double> up = force("-high-");
    for (std::size_t i = 0; i < down.size(); ++i) down[i] = -down[i] - up[i];
    forces.push_back(std::move(down));
  }
  const Scene& scene = subject.scene();
  Evidence evidence = from_mean(pooled(forces), subject.particles() * scene.method.weight *
                                                    subject.species().mass * bed_of(subject).gravity);
  evidence.units = "mass length time^-2";
  evidence.summary = "mean force on the bottom, less that on the lid, against the weight";
  return evidence;
}

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

/// Work of a wall in the window; a sample is the mean power since the one before.
double work_of(const Subject& subject, std::size_t replica, const std::string& side, double from) {
  const Series& series = subject.series(replica, "wall-power");
  const std::vector<double> power = subject.column(replica, "wall-power", side);
  const Window window = window_of(series, from);
  double work = 0;
  for (std::size_t i = window.first + 1; i <= window.last; ++i)
    work += power[i] * (series.time[i] - series.time[i - 1]);
  return work;
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

/// Work of all walls that neither the bed keeps nor collisions take, over the work of the bottom. A collision takes
/// (1 - r^2) T on average.
double imbalance(const Subject& subject, std::size_t replica, double from) {
  const std::string axis = vertical_name(subject.scene());
  const double bottom = work_of(subject, replica, axis + "-low", from);
  double rest = 0;
  for (const std::string& side : subject.series(replica, "wall-power").quantity.components)
    rest += work_of(subject, replica, side, from);
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
  evidence.budget.systematic = elastic ? 1e-9 : law::vibrated_bed_expansion(bed_of(subject));
  evidence.budget.reason = elastic ? "rounding" : "one temperature in the whole bed, to order <U^2> m/T";
  evidence.summary = "power of all walls less what collisions take, over the power of the bottom";
  return evidence;
}
}  // namespace

std::vector<CheckInfo> vibrated_bed_flow_checks() {
  const law::Parameter settle{"settle-share", "1", "share of the run that is left out", 0, 0.9, 0.25};
  return {{"vibrated-bed-weight",
           "mean force on the bottom of a vibrated bed against the weight",
           "floor-impulse",
           {"wall-force"},
           true,
           {settle},
           is_vibrated_bed,
           weight},
          {"vibrated-bed-power",
           "power of the walls of a vibrated bed less what its collisions take, over the power of the bottom",
           "",
           {"wall-power", "energy", "centre-of-mass", "collisions"},
           false,
           {settle},
           is_vibrated_bed,
           power}};
}

}  // namespace sandglass
