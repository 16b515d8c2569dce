#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/shear_cell.hpp"
#include "validation/check/worst.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// Work of moving walls: exact identities, to rounding.

namespace sandglass {

namespace {
/// A sum over N particles twice, and a few rounded operations of each at its collisions and steps, as in
/// conservation.cpp.
double rounding_bound(const Subject& subject, std::size_t replica) {
  const auto& counters = subject.record().replicas[replica].counters;
  const double changes = 2 * counters.at("collisions") / subject.particles() + counters.at("steps");
  return std::numeric_limits<double>::epsilon() * (2 * subject.particles() + 12 * changes);
}

double total_work(const Subject& subject, std::size_t replica) {
  const Series& power = subject.series(replica, "wall-power");
  const std::size_t width = power.quantity.size();
  double work = 0, before = 0;
  for (std::size_t sample = 0; sample < power.samples(); ++sample) {
    for (std::size_t side = 0; side < width; ++side)
      work += power.value[sample * width + side] * (power.time[sample] - before);
    before = power.time[sample];
  }
  return work;
}

Evidence wall_work(const Subject& subject, const law::Arguments&) {
  Evidence evidence;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const std::vector<double>& energy = subject.series(replica, "energy").value;
    const double most = *std::max_element(energy.begin(), energy.end());
    keep_worst(evidence.value,
               std::abs(energy.back() - energy.front() - total_work(subject, replica)) / most);
    evidence.budget.systematic = std::max(evidence.budget.systematic, 2 * rounding_bound(subject, replica));
  }
  evidence.budget.reason = "rounding of sums, collisions and steps";
  return evidence;
}

/// Largest |power + force times velocity of the wall| over the largest power, of walls across y.
double mismatch(const Subject& subject, std::size_t replica) {
  double worst = 0, most = 0;
  for (const bool high : {false, true}) {
    const std::string side = high ? "y-high" : "y-low";
    const double velocity = wall_at(subject.scene(), 1, high).velocity[0];
    const std::vector<double> power = subject.column(replica, "wall-power", side),
                              force = subject.column(replica, "wall-force", side + "-x");
    for (std::size_t i = 0; i < power.size(); ++i) {
      keep_worst(worst, std::abs(power[i] + force[i] * velocity));
      most = std::max(most, std::abs(force[i] * velocity));
    }
  }
  return worst / most;
}

Evidence wall_power(const Subject& subject, const law::Arguments&) {
  Evidence evidence;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    keep_worst(evidence.value, mismatch(subject, replica));
    evidence.budget.systematic = std::max(evidence.budget.systematic, 2 * rounding_bound(subject, replica));
  }
  evidence.budget.reason = "rounding of sums over hits";
  return evidence;
}

bool keeps_energy(const Scene& scene) {
  return is_shear_cell(scene) && scene.species.front().restitution == 1 &&
         wall_at(scene, 1, false).surface.restitution == 1 &&
         wall_at(scene, 1, true).surface.restitution == 1;
}
}  // namespace

std::vector<CheckInfo> wall_balance_checks() {
  return {{"wall-power",
           "power of each wall against force times its velocity, over the largest power",
           "",
           {"wall-force", "wall-power"},
           false,
           {},
           is_shear_cell,
           wall_power},
          {"wall-work",
           "gain of energy less the work of the walls in an elastic gas, over the largest energy",
           "",
           {"energy", "wall-power"},
           false,
           {},
           keeps_energy,
           wall_work}};
}

}  // namespace sandglass
