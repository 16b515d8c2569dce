#include "validation/law/moments.hpp"

#include "sim/base/error.hpp"
#include "validation/check/families.hpp"
#include "validation/check/finite_size.hpp"
#include "validation/check/worst.hpp"
#include "validation/law/sonine.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace sandglass {

namespace {
/// One component of the "moments" series: m6 is <C_x^6>/<C_x^2>^3, s6 is <C^6>/<C^2>^3.
struct Moment {
  std::string name;
  int order;
  bool speed;
};
const std::array<Moment, 6> moments{{{"m4", 4, false},
                                     {"m6", 6, false},
                                     {"m8", 8, false},
                                     {"s4", 4, true},
                                     {"s6", 6, true},
                                     {"s8", 8, true}}};

double maxwell_value(const Moment& moment, int dimension) {
  if (!moment.speed) return law::maxwell_component_moment(moment.order, 1);
  return law::maxwell_speed_moment(dimension, moment.order, 1) / std::pow(dimension, moment.order / 2);
}

double expected_value(const Moment& moment, const Subject& subject) {
  const double sharing = moment.speed ? subject.degrees_of_freedom() : subject.particles() - 1;
  return maxwell_value(moment, subject.dimension()) * self_normalised_factor(moment.order, sharing);
}

Mean measured(const Moment& moment, const Subject& subject) {
  std::vector<std::vector<double>> samples;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    samples.push_back(subject.column(replica, "moments", moment.name));
  return pooled(samples);
}

Evidence velocity_moments(const Subject& subject, const law::Arguments&) {
  Figure figure{"Velocity moments over those of a Maxwellian",
                {"order of the moment (speed at + 0.2)", "1", false},
                {"ratio", "1", false},
                {},
                {}};
  Figure::Points points{"measured", {}, {}, {}, {}};
  WorstRatio worst;
  for (const Moment& moment : moments) {
    Mean ratio = measured(moment, subject);
    const double expected = expected_value(moment, subject);
    ratio.value /= expected;
    ratio.standard_error /= expected;
    worst.offer(ratio, moment.name);
    points.x.push_back(moment.order + (moment.speed ? 0.2 : 0));
    points.y.push_back(ratio.value);
    points.error.push_back(ratio.standard_error);
    points.expected.push_back(1);
  }
  figure.points.push_back(std::move(points));
  Evidence evidence = worst.evidence();
  evidence.summary = "worst of six velocity moments (" + worst.label() + ") over its Maxwell value";
  evidence.budget.reason = "finite N is part of the expectation";
  evidence.figures.push_back(std::move(figure));
  return evidence;
}

/// A moment of the speed over Maxwell's, less one, at each sample of a replica: a2 at order 4, 3 a2 - a3 at order 6.
std::vector<double> excess_samples(const Subject& subject, std::size_t replica, int order) {
  const Moment& moment = order == 4 ? moments[3] : moments[4];
  const double maxwell = maxwell_value(moment, subject.dimension()) *
                         self_normalised_factor(order, subject.degrees_of_freedom());
  std::vector<double> excess = subject.column(replica, "moments", moment.name);
  for (double& value : excess) value = value / maxwell - 1;
  return excess;
}

/// Mean over replicas at each sample, against collisions per particle.
Figure excess_figure(const Subject& subject, int order, double expected) {
  Figure figure{order == 4 ? "Fourth moment of the speed" : "Sixth moment of the speed",
                {"collisions per particle", "1", false},
                {order == 4 ? "a2" : "3 a2 - a3", "1", false},
                {},
                {}};
  Figure::Points points{
      "measured", subject.collisions_per_particle(0, subject.series(0, "moments")), {}, {}, {}};
  std::vector<std::vector<double>> samples;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    samples.push_back(excess_samples(subject, replica, order));
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    std::vector<double> at_one_time;
    for (const std::vector<double>& replica : samples)
      if (i < replica.size()) at_one_time.push_back(replica[i]);
    const Mean mean = mean_of_independent(at_one_time);
    points.y.push_back(mean.value);
    points.error.push_back(mean.standard_error);
    points.expected.push_back(expected);
  }
  figure.lines.push_back({"third Sonine order", {points.x.front(), points.x.back()}, {expected, expected}});
  figure.points.push_back(std::move(points));
  return figure;
}

std::vector<double> settled_samples(const Subject& subject, std::size_t replica, int order, double settle) {
  const std::vector<double> tau =
      subject.collisions_per_particle(replica, subject.series(replica, "moments"));
  const std::vector<double> all = excess_samples(subject, replica, order);
  std::vector<double> settled;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (tau[i] >= settle) settled.push_back(all[i]);
  if (settled.empty())
    throw InputError(
        "the run ends before the velocity distribution settles: run longer than 'settle-collisions'");
  return settled;
}

Evidence excess(const Subject& subject, int order, double settle, double expected, double error) {
  std::vector<std::vector<double>> settled;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    settled.push_back(settled_samples(subject, replica, order, settle));
  Evidence evidence = from_mean(pooled(settled), expected);
  evidence.budget.systematic = error;
  evidence.budget.reason = "third Sonine order: two ways to linearise differ, a4 is left out";
  evidence.effect = std::abs(expected);
  evidence.without = "a Maxwellian";
  evidence.figures.push_back(excess_figure(subject, order, expected));
  return evidence;
}

/// Expected value of a function of (a2, a3), and its error by the other linearisation and the next order.
template <class Function>
std::pair<double, double> third_order(const Subject& subject, const Function& function,
                                      double of_the_next_order) {
  const int dimension = subject.dimension();
  const double r = subject.species().restitution;
  const double value = function(law::sonine_coefficients<3>(dimension, r));
  const double other = function(law::sonine_coefficients<3>(dimension, r, law::Linearised::products));
  return {value, std::abs(value - other) + of_the_next_order * (1 - r * r)};
}

Evidence sonine_coefficient(const Subject& subject, const law::Arguments& numbers) {
  const auto [expected, error] = third_order(
      subject, [](const Eigen::Vector2d& a) { return a[0]; }, law::kNextOrderOfA2);
  return excess(subject, 4, numbers.at("settle-collisions"), expected, error);
}

Evidence sixth_moment(const Subject& subject, const law::Arguments& numbers) {
  const auto [expected, error] = third_order(subject, law::sonine_sixth_moment, law::kNextOrderOfSixthMoment);
  return excess(subject, 6, numbers.at("settle-collisions"), expected, error);
}
}  // namespace

std::vector<CheckInfo> moment_checks() {
  const law::Parameter settle{
      "settle-collisions", "1", "collisions per particle left out at the start", 0, 1e9, 10.0};
  return {{"velocity-moments",
           "moments of order 4, 6 and 8 of component and speed over their Maxwell values",
           "maxwell-component-moment",
           {"moments"},
           true,
           {},
           is_equilibrium,
           velocity_moments},
          {"sonine-coefficient",
           "fourth moment of the cooling gas against a2 of the third Sonine order",
           "sonine-a2-third-order",
           {"moments", "collisions"},
           false,
           {settle},
           is_cooling,
           sonine_coefficient},
          {"sonine-sixth-moment",
           "sixth moment of the cooling gas against 3 a2 - a3 of the third Sonine order",
           "sonine-sixth-moment",
           {"moments", "collisions"},
           false,
           {settle},
           is_cooling,
           sixth_moment}};
}

}  // namespace sandglass
