#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/shear_cell.hpp"
#include "validation/check/worst.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// Work of moving walls, and what passes open sides: exact identities, to rounding.

namespace sandglass {

namespace {
/// A sum over N particles twice, and a few rounded operations of each at its collisions and steps, as in
/// conservation.cpp.
double rounding_bound(const Subject& subject, std::size_t replica, double particles) {
  const auto& counters = subject.record().replicas[replica].counters;
  const double changes = 2 * counters.at("collisions") / particles + counters.at("steps");
  return std::numeric_limits<double>::epsilon() * (2 * particles + 12 * changes);
}
double rounding_bound(const Subject& subject, std::size_t replica) {
  return rounding_bound(subject, replica, subject.particles());
}

/// Integral over time of what all sides together show, of every `stride`-th number from `first` on.
double total_of_sides(const Subject& subject, std::size_t replica, const std::string& quantity,
                      std::size_t first = 0, std::size_t stride = 1) {
  const Series& series = subject.series(replica, quantity);
  const std::size_t width = series.quantity.size();
  double total = 0, before = 0;
  for (std::size_t sample = 0; sample < series.samples(); ++sample) {
    for (std::size_t side = first; side < width; side += stride)
      total += series.value[sample * width + side] * (series.time[sample] - before);
    before = series.time[sample];
  }
  return total;
}

Evidence wall_work(const Subject& subject, const law::Arguments&) {
  Evidence evidence;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const std::vector<double>& energy = subject.series(replica, "energy").value;
    const double most = *std::max_element(energy.begin(), energy.end());
    keep_worst(
        evidence.value,
        std::abs(energy.back() - energy.front() - total_of_sides(subject, replica, "wall-power")) / most);
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

/// Energy of a replica at each sample, that of spins included.
std::vector<double> energies(const Subject& subject, std::size_t replica) {
  std::vector<double> energy = subject.series(replica, "energy").value;
  if (is_rough(subject.scene())) {
    const std::vector<double>& turning = subject.series(replica, "rotational-energy").value;
    for (std::size_t i = 0; i < energy.size(); ++i) energy[i] += turning.at(i);
  }
  return energy;
}

/// Of a flow through the box: each step rounds the sums of what passes, too.
double exchange_bound(const Subject& subject, std::size_t replica) {
  const auto& counters = subject.record().replicas[replica].counters;
  const double entered = counters.at("particles-entered"), passed = entered + counters.at("particles-left");
  const double particles = std::max(1.0, subject.particles() + entered);  // a box may begin empty
  return rounding_bound(subject, replica, particles) + std::numeric_limits<double>::epsilon() * passed;
}

/// Along axes without gravity: what the particles gain they have taken from the sides.
Evidence side_momentum(const Subject& subject, const law::Arguments&) {
  Evidence evidence;
  const Scene& scene = subject.scene();
  const auto width = static_cast<std::size_t>(subject.dimension());
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const std::vector<double>& momentum = subject.series(replica, "momentum").value;
    const std::vector<double>& scale = subject.series(replica, "momentum-scale").value;
    for (std::size_t axis = 0; axis < width; ++axis) {
      if (axis < scene.gravity.size() && scene.gravity[axis] != 0) continue;
      const double gained = momentum[momentum.size() - width + axis] - momentum[axis];
      keep_worst(evidence.value,
                 std::abs(gained + total_of_sides(subject, replica, "wall-force", axis, width)) /
                     *std::ranges::max_element(scale));
    }
    evidence.budget.systematic = std::max(evidence.budget.systematic, 2 * exchange_bound(subject, replica));
  }
  evidence.budget.reason = "rounding of sums, collisions and steps";
  return evidence;
}

Evidence side_energy(const Subject& subject, const law::Arguments&) {
  Evidence evidence;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const std::vector<double> energy = energies(subject, replica);
    const double taken =
        total_of_sides(subject, replica, "wall-heat") - total_of_sides(subject, replica, "wall-power");
    keep_worst(evidence.value,
               std::abs(energy.back() - energy.front() + taken) / *std::ranges::max_element(energy));
    evidence.budget.systematic = std::max(evidence.budget.systematic, 2 * exchange_bound(subject, replica));
  }
  evidence.budget.reason = "rounding of sums, collisions and steps";
  return evidence;
}

/// A stream, and nothing but its sides gives it momentum or energy: what sources bring and obstacles take is in no series.
bool lives_by_its_sides(const Scene& scene) {
  return !scene.inflows.empty() && scene.sources.empty() && scene.obstacles.empty();
}

/// No collision loses energy, and none is hidden in the height.
bool keeps_energy_between_sides(const Scene& scene) {
  return lives_by_its_sides(scene) && is_weightless(scene) &&
         std::ranges::all_of(scene.species, [](const Species& species) {
           return species.restitution == 1 && std::abs(species.tangential_restitution) == 1 &&
                  !species.friction;
         });
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
           wall_work},
          {"side-momentum",
           "momentum that the particles gain and the sides, open ones among them, give; over all momenta",
           "",
           {"momentum", "momentum-scale", "wall-force"},
           false,
           {},
           lives_by_its_sides,
           side_momentum},
          {"side-energy",
           "energy that particles gain which lose none in collisions, and the sides give; over the largest "
           "energy",
           "",
           {"energy", "wall-power", "wall-heat"},
           false,
           {},
           keeps_energy_between_sides,
           side_energy}};
}

}  // namespace sandglass
