#include "validation/law/mixing.hpp"

#include "validation/law/quadrature.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::law {

namespace {
/// Antiderivative of (u - xi) u^-q.
double antiderivative(double u, double q, double xi) {
  const double first = q == 2 ? std::log(u) : std::pow(u, 2 - q) / (2 - q);
  const double second = q == 1 ? std::log(u) : std::pow(u, 1 - q) / (1 - q);
  return first - xi * second;
}

double between(const PairRepulsion& law, double q, double low, double high) {
  const double xi = law.softening_length;
  return low < high ? antiderivative(high + xi, q, xi) - antiderivative(low + xi, q, xi) : 0;
}

/// What is left of the square of the radial speed, over that of the speed.
double radial(const PairRepulsion& law, double mass, double speed, double impact, double distance) {
  return 1 - impact * impact / (distance * distance) -
         2 * repulsion_work(law, mass, distance) / (speed * speed);
}
}  // namespace

double repulsion_acceleration(const PairRepulsion& law, double mass, double distance) {
  if (!(distance < law.cutoff)) return 0;
  const double softened = distance + law.softening_length;
  const double core = distance < law.diameter ? std::pow(softened / law.diameter, law.core_exponent) : 1;
  return law.coefficient * mass * distance / (std::pow(softened, law.exponent) * core);
}

double repulsion_work(const PairRepulsion& law, double mass, double distance) {
  const double core_end = std::min(law.diameter, law.cutoff);
  const double core = std::pow(law.diameter, law.core_exponent) *
                      between(law, law.exponent + law.core_exponent, distance, core_end);
  const double shell = between(law, law.exponent, std::max(distance, core_end), law.cutoff);
  return law.coefficient * mass * (core + shell);
}

double turning_distance(const PairRepulsion& law, double mass, double speed, double impact) {
  double inside = 0, outside = std::max(impact, law.cutoff) * (1 + 1e-12);
  for (int i = 0; i < 200; ++i) {
    const double middle = (inside + outside) / 2;
    (radial(law, mass, speed, impact, middle) > 0 ? outside : inside) = middle;
  }
  return outside;
}

/// Over theta, with 1/r = sin(theta)/r_turn: the integrand stays finite at the turning point.
double deflection_angle(const PairRepulsion& law, double mass, double speed, double impact) {
  const double turn = turning_distance(law, mass, speed, impact);
  const auto swept = [&](double theta) {
    const double left = radial(law, mass, speed, impact, turn / std::sin(theta));
    return left > 0 ? impact / turn * std::cos(theta) / std::sqrt(left) : 0;
  };
  const auto angle_of = [&](double distance) { return std::asin(std::min(1.0, turn / distance)); };
  double angle = 0, from = 1e-12;
  for (const double to : {angle_of(law.cutoff), angle_of(law.diameter), M_PI / 2}) {
    if (to > from) angle += quadrature::integral(swept, from, to);
    from = std::max(from, to);
  }
  return M_PI - 2 * angle;
}

double stable_step(const PairRepulsion& law, double mass, double speed) {
  const double turn = turning_distance(law, mass, speed, 0), width = 1e-5 * turn;
  const double slope =
      (repulsion_acceleration(law, mass, turn + width) - repulsion_acceleration(law, mass, turn - width)) /
      (2 * width);
  return 2 / std::sqrt(std::abs(slope));
}

double cage_frequency(const PairRepulsion& law, double mass, double distance) {
  return std::sqrt(2 * law.coefficient * mass * (law.exponent + law.core_exponent - 1) *
                   std::pow(law.diameter / distance, law.core_exponent) / std::pow(distance, law.exponent));
}

double leapfrog_place(double angle, double steps) {
  const double half = angle * angle / 2;
  if (angle <= 2) return std::cos(steps * std::acos(1 - half));
  return (std::fmod(steps, 2) == 0 ? 1 : -1) * std::cosh(steps * std::acosh(half - 1));
}

double listed_wall_factor(double path, double smallest) {
  return 1 - std::log1p(path / smallest) * smallest / path;
}

}  // namespace sandglass::law
