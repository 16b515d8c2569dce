#include "sim/base/error.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/sedimentation.hpp"
#include "validation/check/worst.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

// What a column of gas ends in, at the temperature that its energy at the start leads to (Kawasaki 1986, Appendix B).

namespace sandglass {

namespace {
using Some = Sedimentation::Some;
using Bins = std::vector<double>;

/// Density of each species in each bin along gravity, mean over the samples from a time on.
std::vector<Bins> densities(const Subject& subject, const Sedimentation& column, std::size_t replica,
                            double from) {
  const Series& series = subject.series(replica, "species-density");
  const std::size_t bins = series.quantity.shape.at(column.axis()), species = column.species();
  if (series.quantity.size() != bins * species)
    throw InputError("'species-density' has more than one bin across gravity: give 1 along the other axes");
  std::vector<Bins> sum(species, Bins(bins));
  double samples = 0;
  for (std::size_t sample = 0; sample < series.samples(); ++sample) {
    if (series.time[sample] < from) continue;
    ++samples;
    for (std::size_t bin = 0; bin < bins; ++bin)
      for (std::size_t kind = 0; kind < species; ++kind)
        sum[kind][bin] += series.value[(sample * bins + bin) * species + kind];
  }
  if (samples == 0)
    throw InputError("no sample of 'species-density' from 'settle-time' on: run longer or lower it");
  for (Bins& one : sum)
    for (double& density : one) density /= samples;
  return sum;
}

/// Mean density of the law in a bin.
double expected_density(const Subject& subject, const Sedimentation& column, std::size_t kind,
                        double temperature, std::size_t bin, std::size_t bins) {
  const double thickness = column.height() / static_cast<double>(bins);
  const double low = static_cast<double>(bin) * thickness - column.reach(kind);
  const law::Column own = column.part(kind, temperature);
  const double share = law::barometric_fraction(own, low + thickness) - law::barometric_fraction(own, low);
  return share * static_cast<double>(bins) * number_density(subject.scene(), subject.scene().species[kind]);
}

double mean_over(Some replicas, const std::function<double(std::size_t)>& value) {
  double sum = 0;
  for (const std::size_t replica : replicas) sum += value(replica);
  return sum / static_cast<double>(replicas.size());
}

Evidence sedimentation_profile(const Subject& subject, const law::Arguments& numbers) {
  const Sedimentation column(subject);
  std::vector<std::vector<Bins>> seen;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    seen.push_back(densities(subject, column, replica, numbers.at("settle-time")));
  const std::size_t bins = seen.front().front().size();
  WorstRatio worst;
  Figure figure{"Density of the column at rest",
                {"height", "length", false},
                {"density", "length^-dimension", false},
                {},
                {}};
  for (std::size_t kind = 0; kind < column.species(); ++kind) {
    const std::string& name = subject.scene().species[kind].name;
    Figure::Points points{name, {}, {}, {}, {}};
    for (std::size_t bin = 0; bin < bins; ++bin) {
      const auto law = [&](Some replicas) {
        return expected_density(subject, column, kind, column.temperature(replicas), bin, bins);
      };
      const auto measured = [&](Some replicas) {
        return mean_over(replicas, [&](std::size_t replica) { return seen[replica][kind][bin]; });
      };
      const Mean ratio =
          jackknife(subject.replicas(), [&](Some replicas) { return measured(replicas) / law(replicas); });
      worst.offer(ratio, fmt::format("{} in bin {}", name, bin));
      const std::vector<std::size_t> all = column.all();
      points.x.push_back((static_cast<double>(bin) + 0.5) * column.height() / static_cast<double>(bins));
      points.y.push_back(measured(all));
      points.error.push_back(ratio.standard_error * law(all));
      points.expected.push_back(law(all));
    }
    figure.lines.push_back({name + ", law", points.x, points.expected});
    figure.points.push_back(std::move(points));
  }
  Evidence evidence = worst.evidence();
  evidence.summary =
      "density of each species in each bin over the law at the temperature of the run's own energy; worst: " +
      worst.label();
  evidence.budget.systematic = column.density_shift();
  evidence.budget.reason = "finite N at fixed energy; particles of finite size";
  evidence.figures.push_back(std::move(figure));
  return evidence;
}

/// Mean of one component of one replica from a time on.
double late(const Subject& subject, std::size_t replica, const std::string& quantity,
            const std::string& component, double from) {
  return mean_of_independent(late_samples(subject, replica, quantity, component, from)).value;
}

/// Over the law, replica by replica.
void offer(const Subject& subject, const Sedimentation& column, const std::string& quantity,
           const std::string& component, double from, WorstRatio& worst) {
  std::vector<double> ratios;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    ratios.push_back(late(subject, replica, quantity, component, from) / column.temperature(replica));
  worst.offer(mean_of_independent(ratios), quantity + " " + component);
}

Evidence sedimentation_temperature(const Subject& subject, const law::Arguments& numbers) {
  const Sedimentation column(subject);
  const double from = numbers.at("settle-time");
  WorstRatio worst;
  for (const std::string& component : subject.series(0, "temperature").quantity.components)
    offer(subject, column, "temperature", component, from, worst);
  if (is_rough(subject.scene())) offer(subject, column, "rotational-temperature", "", from, worst);
  Evidence evidence = worst.evidence();
  evidence.summary =
      "temperature of all, along each axis and of the spins, over that of the run's own energy; worst: " +
      worst.label();
  evidence.budget.systematic = column.mean_shift();
  evidence.budget.reason = "finite N at fixed energy; particles of finite size";
  return evidence;
}

Evidence sedimentation_uniform(const Subject& subject, const law::Arguments& numbers) {
  const Sedimentation column(subject);
  std::vector<Bins> seen;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    seen.push_back(
        profile_along(subject, replica, column.axis(), numbers.at("settle-time"), numbers.at("end-time"))
            .temperature);
  WorstRatio worst;
  Figure::Points points{"measured", {}, {}, {}, {}};
  const std::size_t bins = seen.front().size();
  for (std::size_t bin = 0; bin < bins; ++bin) {
    std::vector<double> ratios;
    for (std::size_t replica = 0; replica < seen.size(); ++replica)
      ratios.push_back(seen[replica][bin] / column.temperature(replica));
    const Mean ratio = mean_of_independent(ratios);
    worst.offer(ratio, fmt::format("bin {}", bin));
    points.x.push_back((static_cast<double>(bin) + 0.5) * column.height() / static_cast<double>(bins));
    points.y.push_back(ratio.value);
    points.error.push_back(ratio.standard_error);
    points.expected.push_back(1);
  }
  Evidence evidence = worst.evidence();
  evidence.summary = "temperature in each bin over that of the run's own energy; worst: " + worst.label();
  evidence.budget.systematic = column.temperature_shift(static_cast<double>(bins));
  evidence.budget.reason = "finite N at fixed energy; particles of finite size";
  evidence.figures.push_back({"Temperature of the column at rest",
                              {"height", "length", false},
                              {"temperature over the law", "1", false},
                              {std::move(points)},
                              {}});
  return evidence;
}

CheckInfo rest_check(std::string name, std::string summary, std::string law, std::vector<std::string> needs,
                     std::vector<law::Parameter> numbers,
                     Evidence (*evaluate)(const Subject&, const law::Arguments&)) {
  for (const char* always : {"energy", "centre-of-mass"}) needs.push_back(always);
  return {std::move(name),    std::move(summary), std::move(law), std::move(needs), true,
          std::move(numbers), is_sedimentation,   evaluate};
}
}  // namespace

std::vector<CheckInfo> sedimentation_rest_checks() {
  const law::Parameter settle{"settle-time", "time", "samples before it are left out", 0, 1e12};
  const law::Parameter end{"end-time", "time", "samples after it are left out", 0, 1e12, 1e12};
  return {
      rest_check("sedimentation-profile",
                 "density of each species of a column that has come to rest under gravity, in each bin, over "
                 "the law",
                 "sedimentation-density", {"species-density"}, {settle}, sedimentation_profile),
      rest_check(
          "sedimentation-temperature",
          "temperature of a column that has come to rest, along each axis and of the spins, over that of its "
          "energy at the start",
          "sedimentation-temperature", {"temperature"}, {settle}, sedimentation_temperature),
      rest_check(
          "sedimentation-uniform",
          "temperature in each bin of a column that has come to rest, over that of its energy at the start",
          "sedimentation-temperature", {"fields"}, {settle, end}, sedimentation_uniform)};
}

}  // namespace sandglass
