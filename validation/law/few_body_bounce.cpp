#include "validation/law/few_body_bounce.hpp"

#include "sim/base/error.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace sandglass::law {

namespace {
constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kMost = 1e7;  // bounces

double restitution_at(const BouncingBall& ball, double speed) {
  if (!(speed < ball.reference_speed)) return ball.restitution;
  return 1 - (1 - ball.restitution) * std::pow(speed / ball.reference_speed, 0.75);
}

double first_speed(const BouncingBall& ball) {
  return std::hypot(ball.velocity, std::sqrt(2 * ball.gravity * ball.height));
}

double first_time(const BouncingBall& ball) { return (ball.velocity + first_speed(ball)) / ball.gravity; }

BounceState flying(double bounces, double height, double velocity, double gravity, double since,
                   double flight) {
  return {bounces, height + (velocity - gravity * since / 2) * since, velocity - gravity * since, since,
          flight - since};
}
}  // namespace

double bounce_speed(const BouncingBall& ball, int n) {
  return first_speed(ball) * std::pow(ball.restitution, n - 1);
}

double bounce_time(const BouncingBall& ball, int n) {
  const double r = ball.restitution;
  const double powers = r == 1 ? n - 1 : r * (1 - std::pow(r, n - 1)) / (1 - r);
  return first_time(ball) + 2 * first_speed(ball) / ball.gravity * powers;
}

double accumulation_time(const BouncingBall& ball) {
  if (ball.restitution == 1) return kInfinite;
  return first_time(ball) + 2 * first_speed(ball) / ball.gravity * ball.restitution / (1 - ball.restitution);
}

BounceState bouncing_ball(const BouncingBall& ball, double time) {
  if (time < first_time(ball))
    return flying(0, ball.height, ball.velocity, ball.gravity, time, first_time(ball));
  double begin = first_time(ball), impact = first_speed(ball);
  for (double bounces = 1; bounces < kMost; ++bounces) {
    const double speed = restitution_at(ball, impact) * impact, flight = 2 * speed / ball.gravity;
    if (begin + flight == begin) break;
    if (time < begin + flight) return flying(bounces, 0, speed, ball.gravity, time - begin, flight);
    begin += flight;
    impact = speed;
  }
  throw InputError(fmt::format("the ball has bounced for ever by time {}: end before {}", time, begin));
}

std::optional<double> bounce_phase(const VibratedBall& ball) {
  const double needed = ball.gravity / (2 * ball.frequency) * (1 - ball.restitution) / (1 + ball.restitution);
  const double largest = kTurn * ball.frequency * ball.amplitude;
  if (needed > largest) return std::nullopt;
  return std::acos(needed / largest);
}

double orbit_acceleration_ratio(const VibratedBall& ball) {
  const std::optional<double> phase = bounce_phase(ball);
  if (!phase) return std::numeric_limits<double>::quiet_NaN();
  const double rate = kTurn * ball.frequency, r = ball.restitution;
  const double acceleration = ball.amplitude * rate * rate * std::sin(*phase);
  return acceleration / (2 * ball.gravity * (1 + r * r) / ((1 + r) * (1 + r)));
}

double orbit_contraction(const VibratedBall& ball) {
  const double r = ball.restitution, trace = (1 + r * r) * (1 - 2 * orbit_acceleration_ratio(ball));
  const double inside = trace * trace / 4 - r * r;
  return inside < 0 ? r : std::abs(trace) / 2 + std::sqrt(inside);
}

BounceState period_one_orbit(const VibratedBall& ball, double time) {
  const std::optional<double> phase = bounce_phase(ball);
  if (!phase)
    throw InputError("the floor is too slow for one bounce a period: raise 'amplitude' or 'frequency'");
  const double turns = time * ball.frequency - *phase / kTurn, period = 1 / ball.frequency;
  const double since = (turns - std::floor(turns)) * period;
  return flying(std::floor(turns), ball.amplitude * std::sin(*phase), ball.gravity * period / 2, ball.gravity,
                since, period);
}

}  // namespace sandglass::law
