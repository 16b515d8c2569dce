#include "validation/check/families.hpp"
#include "validation/check/finite_size.hpp"
#include "validation/law/enskog.hpp"
#include "validation/law/virial.hpp"

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

law::Bounded enskog_rate(const law::Gas& gas) { return {law::collision_rate(gas), 0, 0}; }

/// The measured rate against what `rate_of` makes of the gas at the run's own temperature.
Evidence against(const Subject& subject, law::Bounded (*rate_of)(const law::Gas&),
                 double factor_of_method = 1) {
  std::vector<std::vector<double>> rates;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    rates.push_back(interval_rates(subject, replica));
  const Mean rate = pooled(rates);
  const law::Bounded theory = rate_of(subject.gas(subject.mean_temperature()));
  const law::Bounded missing = subject.missing_pairs();
  const double factor = subject.pair_factor() * relative_speed_factor(subject.degrees_of_freedom()) *
                        (1 - missing.value) * factor_of_method;
  Evidence evidence = from_mean(rate, theory.value * factor);
  evidence.units = "1/time";
  evidence.budget.reference = theory.standard_error * factor;
  evidence.budget.systematic = missing.bound * evidence.expected + theory.bound * factor;
  evidence.budget.reason = missing.value > 0
                               ? "pairs that an offset takes from a cell, between the limits of pair_deficit"
                               : "finite N is part of the expectation";
  const double scatter = mean_of_independent(rates.front()).standard_error;
  evidence.figures.push_back(rate_figure(subject.series(0, "collisions").time, rates.front(),
                                         evidence.expected,
                                         scatter * std::sqrt(static_cast<double>(rates.front().size()))));
  return evidence;
}

Evidence collision_rate(const Subject& subject, const law::Arguments& numbers) {
  return against(subject, enskog_rate, contact_ratio(subject, numbers.at("contact-value")));
}

Evidence reference_rate(const Subject& subject, const law::Arguments&) {
  Evidence evidence = against(subject, law::reference_collision_rate);
  evidence.budget.reason += "; terms that the virial series leaves out";
  return evidence;
}

Evidence mean_free_time(const Subject& subject, const law::Arguments& numbers) {
  Evidence evidence = against(subject, law::reference_collision_rate);
  evidence.units = "time";
  evidence.standard_error /= evidence.value * evidence.value;
  evidence.value = 1 / evidence.value;
  evidence.expected = numbers.at("stated");
  evidence.budget = {0, numbers.at("digit"), "last digit of the number that the source gives", 0};
  evidence.figures.clear();
  return evidence;
}
}  // namespace

std::vector<CheckInfo> collision_checks() {
  return {{"collision-rate",
           "collisions per particle and time against Enskog, at the run's own temperature",
           "enskog-collision-rate",
           {"collisions", "temperature"},
           true,
           {contact_number()},
           is_equilibrium,
           collision_rate},
          {"collision-rate-reference",
           "the same against the contact value as well as it is known",
           "collision-rate-reference",
           {"collisions", "temperature"},
           true,
           {},
           is_equilibrium,
           reference_rate},
          {"mean-free-time",
           "time per particle between collisions against the number that a source states",
           "",
           {"collisions", "temperature"},
           true,
           {{"stated", "time", "mean free time that the source states", 1e-300, 1e300},
            {"digit", "time", "what its last digit leaves open", 0, 1e300}},
           is_equilibrium,
           mean_free_time}};
}

}  // namespace sandglass
