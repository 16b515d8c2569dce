#include "validation/check/column.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/worst.hpp"

#include <fmt/format.h>

namespace sandglass {

namespace {
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
  ColumnOfReplicas(const Subject& subject, double from)
      : subject_(subject), temperatures_(column_temperatures(subject, from)) {
    for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
      seen_.push_back(look(subject, replica, from));
  }

  std::size_t bins() const { return seen_.front().profile.density.size(); }
  std::size_t axes() const { return seen_.front().temperature.size() - 1; }
  double height() const { return subject_.scene().domain.size[axis()]; }

  double temperature(Some replicas) const { return mean_over(replicas, temperatures_); }
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
  /// Along an axis, or of all beyond the last.
  Mean isotropy(std::size_t along) const {
    return jackknife(seen_.size(), [&](Some replicas) {
      return average_over(replicas, [&](const Seen& seen) { return seen.temperature[along]; }) /
             temperature(replicas);
    });
  }

 private:
  std::size_t axis() const { return static_cast<std::size_t>(vertical_axis(subject_.scene())); }

  /// Mean density of the law in a bin.
  double expected_density(std::size_t bin, double temperature) const {
    const law::ObstructedColumn column = column_at(subject_, temperature);
    const double thickness = height() / static_cast<double>(bins());
    const double low = static_cast<double>(bin) * thickness - reach(subject_.scene());
    const double share =
        law::obstructed_fraction(column, low + thickness) - law::obstructed_fraction(column, low);
    return share * static_cast<double>(bins()) * number_density(subject_.scene(), subject_.species());
  }

  template <class Value>
  double average_over(Some replicas, const Value& value) const {
    double sum = 0;
    for (const std::size_t replica : replicas) sum += value(seen_[replica]);
    return sum / static_cast<double>(replicas.size());
  }

  const Subject& subject_;
  std::vector<double> temperatures_;  ///< of the law
  std::vector<Seen> seen_;
};

void offer_all(const ColumnOfReplicas& column, bool is_warmed, WorstRatio& worst) {
  for (std::size_t bin = 0; bin < column.bins(); ++bin) {
    worst.offer(column.density_ratio(bin), fmt::format("density in bin {}", bin));
    worst.offer(column.temperature_ratio(bin), fmt::format("temperature in bin {}", bin));
  }
  for (std::size_t axis = 0; axis < column.axes(); ++axis)
    worst.offer(column.isotropy(axis), fmt::format("temperature along axis {}", axis));
  if (is_warmed) worst.offer(column.isotropy(column.axes()), "temperature of all");
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

Evidence barometric_column(const Subject& subject, const law::Arguments& numbers) {
  const ColumnOfReplicas column(subject, numbers.at("settle-time"));
  const bool is_warmed = temperature_of_surfaces(subject.scene()).has_value();
  WorstRatio worst;
  offer_all(column, is_warmed, worst);
  Evidence evidence = worst.evidence();
  evidence.summary =
      std::string("density over the barometric law at ") +
      (is_warmed ? "the temperature of the thermal surfaces" : "the run's own temperature") +
      ", and the temperature in each bin and along each axis over that; worst: " + worst.label();
  evidence.budget.systematic = column_shift(subject, static_cast<double>(column.bins()));
  evidence.budget.reason = "finite N at fixed energy; particles of finite size";
  evidence.figures.push_back(density_figure(column));
  return evidence;
}
}  // namespace

std::vector<CheckInfo> column_checks() {
  return {{"barometric-column",
           "density and temperature of a column at rest under gravity, over the barometric law",
           "barometric-fraction",
           {"temperature", "fields"},
           true,
           {law::Parameter{"settle-time", "time", "samples before it are left out", 0, 1e12}},
           is_column,
           barometric_column}};
}

}  // namespace sandglass
