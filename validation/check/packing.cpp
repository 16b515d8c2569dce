#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/falling.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"

#include <algorithm>
#include <cmath>

// Particles at rest on a floor, against what room they need.

namespace sandglass {

namespace {
/// Random close packing: Mueller 2001, section 2.3.2.
double densest_fraction(const Subject& subject) { return subject.dimension() == 2 ? 0.82 : 0.64; }

std::size_t vertical(const Subject& subject) {
  return static_cast<std::size_t>(vertical_axis(subject.scene()));
}

double floor_size(const Subject& subject) {
  return volume(subject.scene().domain) / subject.scene().domain.size[vertical(subject)];
}

Evidence packed_height(const Subject& subject, const law::Arguments& numbers) {
  const std::string axis(1, static_cast<char>('x' + vertical_axis(subject.scene())));
  std::vector<double> heights;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    heights.push_back(
        mean_of_independent(late_samples(subject, replica, "centre-of-mass", axis, numbers.at("settle-time")))
            .value);
  law::Gas gas = subject.gas(1);
  gas.fraction = numbers.at("fraction") > 0 ? numbers.at("fraction") : densest_fraction(subject);
  const double count = subject.particles() * subject.scene().method.weight;
  Evidence evidence =
      from_mean(mean_of_independent(heights), law::packed_height(gas, count, floor_size(subject)));
  evidence.units = "length";
  evidence.budget.systematic = gas.diameter / 2 + cell_edge(subject) / 2;
  evidence.budget.reason =
      "layers at floor and surface, half a diameter; where in its cell a particle lies, half an edge";
  return evidence;
}

/// Particles that a bin of the grid holds in the densest packing, as many as fit whole.
double room(const Subject& subject, double bins) {
  const double each = law::particle_volume(subject.gas(1)) * subject.scene().method.weight;
  return std::floor(densest_fraction(subject) * volume(subject.scene().domain) / bins / each * (1 + 1e-9));
}

/// Particles above the room of their bin, over all, at the samples from a time on.
double crowded_share(const Subject& subject, std::size_t replica, double from) {
  const Series& series = subject.series(replica, "fields");
  const std::size_t width = static_cast<std::size_t>(subject.dimension()) + 2,
                    bins = series.quantity.size() / width;
  const double per_density =
      volume(subject.scene().domain) / static_cast<double>(bins) / subject.scene().method.weight;
  const double most = room(subject, static_cast<double>(bins));
  double above = 0, all = 0;
  for (std::size_t i = 0; i < series.value.size(); i += width) {
    if (series.time[i / (bins * width)] < from) continue;
    const double here = std::round(series.value[i] * per_density);
    above += std::max(0.0, here - most);
    all += here;
  }
  if (all == 0) throw InputError("no sample of 'fields' from 'settle-time' on: run longer or lower it");
  return above / all;
}

Evidence crowded_cells(const Subject& subject, const law::Arguments& numbers) {
  std::vector<double> shares;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    shares.push_back(crowded_share(subject, replica, numbers.at("settle-time")));
  Evidence evidence = from_mean(mean_of_independent(shares), numbers.at("most"));
  evidence.kind = Expectation::at_most;
  return evidence;
}

bool rests_in_cells(const Scene& scene) { return falls_to_floor(scene) && capabilities(scene).cells; }
}  // namespace

std::vector<CheckInfo> packing_checks() {
  const law::Parameter settle{"settle-time", "time", "samples before it are left out", 0, 1e12};
  const law::Parameter most{"most", "1", "share that may be above", 0, 1};
  const law::Parameter fraction{
      "fraction", "1", "at which cells take nobody in; 0: the densest random packing", 0, 1, 0};
  return {{"packed-height",
           "centre of mass at rest against that of the densest random packing with a level surface",
           "packed-height",
           {"centre-of-mass"},
           false,
           {settle, fraction},
           falls_to_floor,
           packed_height},
          {"crowded-cells",
           "particles above what their bin holds in the densest random packing, over all particles",
           "",
           {"fields"},
           false,
           {settle, most},
           rests_in_cells,
           crowded_cells}};
}

}  // namespace sandglass
