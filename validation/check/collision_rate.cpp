#include "validation/check/families.hpp"
#include "validation/check/finite_size.hpp"
#include "validation/law/enskog.hpp"

#include <cmath>

namespace sandglass {

namespace {
/// Collisions per particle and time over each interval between samples.
std::vector<double> interval_rates(const Subject& subject, std::size_t replica) {
  const std::vector<double> time = subject.series(replica, "collisions").time;
  const std::vector<double> collisions = subject.column(replica, "collisions", "");
  std::vector<double> rates;
  for (std::size_t i = 1; i < time.size(); ++i)
    rates.push_back(2 * (collisions[i] - collisions[i - 1]) / subject.particles() / (time[i] - time[i - 1]));
  return rates;
}

Figure rate_figure(const std::vector<double>& time, const std::vector<double>& rates, double expected,
                   double error) {
  Figure figure{"Collisions per particle and time",
                {"time", "time", false},
                {"collision rate", "1/time", false},
                {},
                {}};
  const std::vector<double> middle(time.begin() + 1, time.end());
  figure.points.push_back({"first replica", middle, rates, std::vector<double>(rates.size(), error),
                           std::vector<double>(rates.size(), expected)});
  figure.lines.push_back({"Enskog", {time.front(), time.back()}, {expected, expected}});
  return figure;
}

Evidence collision_rate(const Subject& subject, const law::Arguments&) {
  std::vector<std::vector<double>> rates;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    rates.push_back(interval_rates(subject, replica));
  const Mean rate = pooled(rates);
  Evidence evidence;
  evidence.units = "1/time";
  evidence.value = rate.value;
  evidence.standard_error = rate.standard_error;
  evidence.degrees_of_freedom = rate.degrees_of_freedom;
  evidence.expected = law::collision_rate(subject.gas(subject.mean_temperature())) *
                      collision_rate_factor(subject.particles(), subject.dimension());
  evidence.budget.systematic = subject.missing_pairs() * evidence.expected;
  evidence.budget.reason = subject.missing_pairs() > 0 ? "pairs that an offset takes from a cell, (1-S)/N_c"
                                                       : "finite N is part of the expectation";
  const double scatter = mean_of_independent(rates.front()).standard_error;
  evidence.figures.push_back(rate_figure(subject.series(0, "collisions").time, rates.front(),
                                         evidence.expected,
                                         scatter * std::sqrt(static_cast<double>(rates.front().size()))));
  return evidence;
}
}  // namespace

std::vector<CheckInfo> collision_checks() {
  return {{"collision-rate",
           "collisions per particle and time against Enskog, at the run's own temperature",
           "enskog-collision-rate",
           {"collisions", "temperature"},
           true,
           {},
           is_equilibrium,
           collision_rate}};
}

}  // namespace sandglass
