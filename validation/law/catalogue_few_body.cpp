#include "validation/law/catalogue.hpp"
#include "validation/law/few_body_bounce.hpp"
#include "validation/law/few_body_line.hpp"
#include "validation/law/parameters.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kOfAFewBalls = "exact; hard balls, binary collisions";

Parameter number(std::string name, std::string summary, double low) {
  return {.name = std::move(name),
          .units = "1",
          .summary = std::move(summary),
          .low = low,
          .high = 1e6,
          .step = 1};
}

std::vector<Parameter> ball_parameters() {
  return {gravity(), elapsed("height", "length", "of the lowest point of the ball at time zero"),
          with_fallback(any_real("velocity", "length/time", "at time zero, upwards"), 0), dissipation()};
}

BouncingBall ball_from(const Arguments& arguments) {
  return {arguments.at("gravity"), arguments.at("height"), arguments.at("velocity"),
          arguments.at("restitution"), 0};
}

Law bouncing_law(std::string name, std::string summary, std::string units,
                 double (*result)(const BouncingBall&, int)) {
  std::vector<Parameter> parameters = ball_parameters();
  parameters.push_back(number("bounce", "1 is the first", 1));
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = "free fall and v' = -r v",
          .units = std::move(units),
          .validity = kOfAFewBalls,
          .parameters = std::move(parameters),
          .evaluate = [result](const Arguments& arguments) {
            return result(ball_from(arguments), static_cast<int>(arguments.at("bounce")));
          }};
}

Law accumulation_law() {
  return {.name = "bouncing-ball-accumulation-time",
          .summary = "when infinitely many bounces are over",
          .source = "sum of bouncing-ball-time",
          .units = "time",
          .validity = "exact; restitution below 1",
          .parameters = ball_parameters(),
          .evaluate = [](const Arguments& arguments) { return accumulation_time(ball_from(arguments)); }};
}

std::array<double, 3> masses_from(const Arguments& arguments) {
  return {arguments.at("mass-1"), arguments.at("mass-2"), arguments.at("mass-3")};
}

std::vector<Parameter> masses() {
  std::vector<Parameter> all;
  for (const char* name : {"mass-1", "mass-2", "mass-3"})
    all.push_back(with_fallback(positive(name, "mass", "of the balls in a row, from left to right"), 1));
  return all;
}

Law collapse_law() {
  return {
      .name = "three-body-collapse-restitution",
      .summary = "largest restitution at which three balls in a row can collide infinitely often",
      .source = "Constantin, Grossman & Mungan 1995; 7 - 4 sqrt(3) for equal masses",
      .units = "1",
      .validity = kOfAFewBalls,
      .parameters = masses(),
      .evaluate = [](const Arguments& arguments) { return collapse_restitution(masses_from(arguments)); }};
}

Law count_law() {
  std::vector<Parameter> parameters = masses();
  parameters.push_back(dissipation());
  return {.name = "three-body-collisions",
          .summary = "most collisions that three balls in a row can make",
          .source = "Constantin, Grossman & Mungan 1995; elastic: Galperin 2003",
          .units = "1",
          .validity = "exact; restitution above three-body-collapse-restitution",
          .parameters = std::move(parameters),
          .evaluate = [](const Arguments& arguments) {
            return most_collisions(masses_from(arguments), arguments.at("restitution"));
          }};
}

Law cradle_law() {
  return {.name = "cradle-speed",
          .summary = "speed with which the blow goes on after some balls of a row of equal ones",
          .source = "((1+r)/2)^n, one collision after the other",
          .units = "length/time",
          .validity = "exact; gaps between the balls, until a ball is caught up from behind",
          .parameters = {number("balls", "balls at rest that were hit so far", 0), dissipation(),
                         with_fallback(positive("speed", "length/time", "of the ball that hits the row"), 1)},
          .evaluate = [](const Arguments& arguments) {
            return cradle_speed(static_cast<int>(arguments.at("balls")), arguments.at("restitution"),
                                arguments.at("speed"));
          }};
}

Law plate_law(std::string name, std::string summary, std::string units,
              double (*result)(const VibratedBall&)) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = "Tufillaro & Albano 1986, without the high-bounce approximation",
          .units = std::move(units),
          .validity = "exact; the floor is fast enough for one bounce a period",
          .parameters = {gravity(), positive("amplitude", "length", "of the floor"),
                         positive("frequency", "1/time", "of the floor"), dissipation()},
          .evaluate = [result](const Arguments& arguments) {
            return result({arguments.at("gravity"), arguments.at("amplitude"), arguments.at("frequency"),
                           arguments.at("restitution")});
          }};
}

double phase_or_nothing(const VibratedBall& ball) {
  return bounce_phase(ball).value_or(std::numeric_limits<double>::quiet_NaN());
}
}  // namespace

std::vector<Law> few_body_laws() {
  return {bouncing_law("bouncing-ball-time", "time of a bounce of a ball on the floor", "time", bounce_time),
          bouncing_law("bouncing-ball-speed", "speed of a ball when it hits the floor", "length/time",
                       bounce_speed),
          accumulation_law(),
          collapse_law(),
          count_law(),
          cradle_law(),
          plate_law("vibrated-ball-phase", "phase of the floor at the one bounce a period, in radians", "1",
                    phase_or_nothing),
          plate_law("vibrated-ball-stability",
                    "acceleration of the floor at the bounce over the largest that is stable", "1",
                    orbit_acceleration_ratio)};
}

}  // namespace sandglass::law
