#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/worst.hpp"
#include "validation/law/free_molecular.hpp"
#include "validation/law/isolated_column.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

// A column of gas at rest under gravity between mirrors: density against the barometric law at the temperature
// that the run itself has, and that temperature the same everywhere and along each axis.

namespace sandglass {

namespace {
bool is_between_mirrors(const Scene& scene, std::size_t axis) {
  return is_mirror(wall_at(scene, axis, false)) && is_mirror(wall_at(scene, axis, true));
}

bool is_column(const Scene& scene) {
  if (!is_plain_gas(scene) || vertical_axis(scene) < 0 || !scene.obstacles.empty()) return false;
  for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis)
    if (!is_periodic_along(scene, axis) && !is_between_mirrors(scene, axis)) return false;
  return true;
}

/// What one replica has to say.
struct Seen {
  Profile profile;
  std::vector<double> temperature;  ///< along each axis, and their mean
};

Seen look(const Subject& subject, std::size_t replica, double from) {
  Seen seen{profile_along(subject, replica, static_cast<std::size_t>(vertical_axis(subject.scene())), from),
            {}};
  for (const std::string& component : subject.series(replica, "temperature").quantity.components)
    seen.temperature.push_back(
        mean_of_independent(late_samples(subject, replica, "temperature", component, from)).value);
  return seen;
}

using Some = std::span<const std::size_t>;

class ColumnOfReplicas {
 public:
  ColumnOfReplicas(const Subject& subject, double from) : subject_(subject) {
    for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
      seen_.push_back(look(subject, replica, from));
  }

  std::size_t bins() const { return seen_.front().profile.density.size(); }
  std::size_t axes() const { return seen_.front().temperature.size() - 1; }
  double height() const { return subject_.scene().domain.size[axis()]; }

  double temperature(Some replicas) const {
    return average_over(replicas, [](const Seen& seen) { return seen.temperature.back(); });
  }
  Mean density_ratio(std::size_t bin) const {
    return jackknife(seen_.size(), [&](Some replicas) {
      return average_over(replicas, [&](const Seen& seen) { return seen.profile.density[bin]; }) /
             expected_density(bin, temperature(replicas));
    });
  }
  Mean temperature_ratio(std::size_t bin) const {
    return jackknife(seen_.size(), [&](Some replicas) {
      return average_over(replicas, [&](const Seen& seen) { return seen.profile.temperature[bin]; }) /
             temperature(replicas);
    });
  }
  Mean isotropy(std::size_t along) const {
    return jackknife(seen_.size(), [&](Some replicas) {
      return average_over(replicas, [&](const Seen& seen) { return seen.temperature[along]; }) /
             temperature(replicas);
    });
  }

 private:
  std::size_t axis() const { return static_cast<std::size_t>(vertical_axis(subject_.scene())); }

  /// Mean density of the law in a bin; centres stay `reach` away from both ends.
  double expected_density(std::size_t bin, double temperature) const {
    const Scene& scene = subject_.scene();
    const law::Column column{subject_.species().mass, temperature, -scene.gravity[axis()],
                             height() - 2 * reach(scene)};
    const double thickness = height() / static_cast<double>(bins());
    const double low = static_cast<double>(bin) * thickness - reach(scene);
    const double share =
        law::barometric_fraction(column, low + thickness) - law::barometric_fraction(column, low);
    return share * static_cast<double>(bins()) * number_density(scene, subject_.species());
  }

  template <class Value>
  double average_over(Some replicas, const Value& value) const {
    double sum = 0;
    for (const std::size_t replica : replicas) sum += value(seen_[replica]);
    return sum / static_cast<double>(replicas.size());
  }

  const Subject& subject_;
  std::vector<Seen> seen_;
};

void offer_all(const ColumnOfReplicas& column, WorstRatio& worst) {
  for (std::size_t bin = 0; bin < column.bins(); ++bin) {
    worst.offer(column.density_ratio(bin), fmt::format("density in bin {}", bin));
    worst.offer(column.temperature_ratio(bin), fmt::format("temperature in bin {}", bin));
  }
  for (std::size_t axis = 0; axis < column.axes(); ++axis)
    worst.offer(column.isotropy(axis), fmt::format("temperature along axis {}", axis));
}

Figure density_figure(const ColumnOfReplicas& column) {
  Figure figure{
      "Density of the column", {"height", "length", false}, {"density over the law", "1", false}, {}, {}};
  Figure::Points points{"measured", {}, {}, {}, {}};
  for (std::size_t bin = 0; bin < column.bins(); ++bin) {
    const Mean ratio = column.density_ratio(bin);
    points.x.push_back((static_cast<double>(bin) + 0.5) * column.height() /
                       static_cast<double>(column.bins()));
    points.y.push_back(ratio.value);
    points.error.push_back(ratio.standard_error);
    points.expected.push_back(1);
  }
  figure.points.push_back(std::move(points));
  return figure;
}

law::Column column_of(const Subject& subject) {
  const Scene& scene = subject.scene();
  const auto axis = static_cast<std::size_t>(vertical_axis(scene));
  return {subject.species().mass, subject.mean_temperature(), -scene.gravity[axis], scene.domain.size[axis]};
}

/// Particles in the emptiest of the bins, by the law.
double fewest_in_a_bin(const law::Column& column, double bins, double particles) {
  return particles * (1 - law::barometric_fraction(column, column.height * (1 - 1 / bins)));
}

/// Where particles collide, N of them share one energy; where they have a size, the floor holds fewer. To first order in
/// 1/N and in the size, at the height where it shows most: a bin lies between such heights.
double systematic(const Subject& subject, double bins) {
  if (!capabilities(subject.scene()).collisions) return 0;
  const law::Column column = column_of(subject);
  const law::IsolatedColumn shifts(column, subject.dimension(), subject.particles());
  const double excluded = touches(subject.scene()) ? law::excluded_fraction(subject.gas(1)) : 0;
  double temperature = 0, density = 0, size = 0;
  for (const double z : {0.0, shifts.largest_density_height(), column.height}) {
    temperature = std::max(temperature, std::abs(shifts.temperature_shift(z)));
    density = std::max(density, std::abs(shifts.density_shift(z)));
    size = std::max(size, std::abs(law::excluded_volume_shift(column, excluded, z)));
  }
  const double few = fewest_in_a_bin(column, bins, subject.particles());
  return std::max(temperature * law::weight_of_crowded_samples(few), density + size);
}

Evidence barometric_column(const Subject& subject, const law::Arguments& numbers) {
  const ColumnOfReplicas column(subject, numbers.at("settle-time"));
  WorstRatio worst;
  offer_all(column, worst);
  Evidence evidence = worst.evidence();
  evidence.summary =
      "density over the barometric law at the run's own temperature, and that temperature in each bin "
      "and along each axis over their mean; worst: " +
      worst.label();
  evidence.budget.systematic = systematic(subject, static_cast<double>(column.bins()));
  evidence.budget.reason = "finite N at fixed energy; particles of finite size";
  evidence.figures.push_back(density_figure(column));
  return evidence;
}
}  // namespace

std::vector<CheckInfo> column_checks() {
  return {{"barometric-column",
           "density and temperature of a column between mirrors under gravity, over the barometric law",
           "barometric-fraction",
           {"temperature", "fields"},
           true,
           {law::Parameter{"settle-time", "time", "samples before it are left out", 0, 1e12}},
           is_column,
           barometric_column}};
}

}  // namespace sandglass
