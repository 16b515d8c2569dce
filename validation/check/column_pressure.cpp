#include "validation/check/column.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/worst.hpp"

namespace sandglass {

namespace {
using Some = std::span<const std::size_t>;

/// Force of a replica on floor or lid from inside, mean over the samples from a time on.
double force_on(const Subject& subject, std::size_t replica, bool lid, double from) {
  const std::string axis(1, static_cast<char>('x' + vertical_axis(subject.scene())));
  const double force = mean_of_independent(late_samples(subject, replica, "wall-force",
                                                        axis + (lid ? "-high-" : "-low-") + axis, from))
                           .value;
  return lid ? force : -force;
}

double floor_less_lid(const law::ObstructedColumn& column) {
  return law::floor_force(column) - law::lid_force(column);
}

Evidence column_pressure(const Subject& subject, const law::Arguments& numbers) {
  const double from = numbers.at("settle-time");
  const double particles = subject.particles() * subject.scene().method.weight;
  const std::vector<double> temperatures = column_temperatures(subject, from);
  std::vector<double> floor, difference;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    floor.push_back(force_on(subject, replica, false, from));
    difference.push_back(floor.back() - force_on(subject, replica, true, from));
  }
  const auto over_law = [&](const std::vector<double>& force, double (*law)(const law::ObstructedColumn&)) {
    return jackknife(subject.replicas(), [&](Some replicas) {
      return mean_over(replicas, force) / particles /
             law(column_at(subject, mean_over(replicas, temperatures)));
    });
  };
  WorstRatio worst;
  worst.offer(over_law(floor, law::floor_force), "floor");
  worst.offer(over_law(difference, floor_less_lid), "floor less lid");
  Evidence evidence = worst.evidence();
  evidence.summary =
      "force on the floor, and what it bears more than the lid, the weight and that of whom obstacles "
      "displace, "
      "over the law of an ideal gas; worst: " +
      worst.label();
  evidence.budget.systematic = column_shift(subject, 1);
  evidence.budget.reason = "finite N at fixed energy; particles of finite size";
  return evidence;
}
}  // namespace

std::vector<CheckInfo> column_pressure_checks() {
  return {{"column-pressure",
           "force of a column at rest on the floor, and that less the force on the lid, over the law of an "
           "ideal gas",
           "column-floor-force",
           {"temperature", "wall-force"},
           true,
           {law::Parameter{"settle-time", "time", "samples before it are left out", 0, 1e12}},
           is_column,
           column_pressure}};
}

}  // namespace sandglass
