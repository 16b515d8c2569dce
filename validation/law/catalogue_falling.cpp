#include "validation/law/catalogue.hpp"
#include "validation/law/falling.hpp"
#include "validation/law/parameters.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kMomentum = "momentum of all particles; collisions keep it";
constexpr const char* kFree = "exact until a particle hits a wall across gravity or a rough one; any method";

Parameter count() { return positive("particles", "1", "number of particles"); }
Parameter time() { return elapsed("time", "time", "since the start"); }
Parameter height() { return any_real("height", "length", "of the centre of mass at time zero"); }
Parameter velocity(std::string name, std::string summary) {
  return with_fallback(any_real(std::move(name), "length/time", std::move(summary)), 0);
}
Parameter start() { return velocity("velocity", "of the centre of mass at time zero, upwards"); }

double value_or(const Arguments& given, const std::string& name, double fallback) {
  const auto found = given.find(name);
  return found == given.end() ? fallback : found->second;
}

FallingParticles particles_from(const Arguments& given) {
  return {value_or(given, "particles", 1), value_or(given, "mass", 1), given.at("gravity"),
          value_or(given, "height", 0), value_or(given, "velocity", 0)};
}

Law falling_law(std::string name, std::string summary, std::string units, std::vector<Parameter> parameters,
                double (*result)(const FallingParticles&, double)) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = kMomentum,
          .units = std::move(units),
          .validity = kFree,
          .parameters = std::move(parameters),
          .evaluate = [result](const Arguments& given) {
            return result(particles_from(given), given.at("time"));
          }};
}

Law fall_time_law() {
  return {.name = "fall-time",
          .summary = "time until a particle hits the floor",
          .source = "free fall",
          .units = "time",
          .validity = "exact; no collision on the way",
          .parameters = {elapsed("height", "length", "of its lowest point above the floor"),
                         velocity("velocity", "at time zero, upwards"), gravity()},
          .evaluate = [](const Arguments& given) {
            return fall_time(given.at("height"), given.at("velocity"), given.at("gravity"));
          }};
}

Law impulse_law() {
  return {.name = "floor-impulse",
          .summary = "time integral of the force of the floor on particles that fall on it",
          .source = kMomentum,
          .units = "mass length/time",
          .validity = "exact; side walls without friction, any method",
          .parameters = {count(), mass(), gravity(), time(), start(),
                         velocity("end-velocity", "of the centre of mass at the end, upwards")},
          .evaluate = [](const Arguments& given) {
            return floor_impulse(particles_from(given), given.at("time"), given.at("end-velocity"));
          }};
}

Law loss_law() {
  return {.name = "collapse-loss",
          .summary = "energy per particle that collisions take until all lie at rest",
          .source = "balance of kinetic and potential energy",
          .units = "mass length^2 time^-2",
          .validity = "exact; walls at rest, smooth particles, any method",
          .parameters = {mass(), gravity(), height(),
                         any_real("end-height", "length", "of the centre of mass at rest"),
                         elapsed("kinetic-energy", "mass length^2 time^-2", "per particle at time zero")},
          .evaluate = [](const Arguments& given) {
            return collapse_loss(particles_from(given), given.at("end-height"), given.at("kinetic-energy"));
          }};
}

Law packing_law() {
  return {.name = "packed-height",
          .summary = "centre of mass of a packing with a level surface on a floor",
          .source =
              "area or volume of the particles over the packing's fraction; random close packing 0.82 "
              "(2D), 0.64 (3D): Mueller 2001, sec. 2.3.2",
          .units = "length",
          .validity = "many layers: floor and surface change it by about a diameter",
          .parameters = with_fraction(
              {count(), diameter(), positive("floor", "length^(dimension-1)", "width or area of the floor")}),
          .evaluate = [](const Arguments& given) {
            return packed_height(gas_from(given), given.at("particles"), given.at("floor"));
          }};
}

Law friction_law() {
  return {.name = "steady-wall-friction",
          .summary = "upward force of all walls on particles that flow steadily along gravity",
          .source = kMomentum,
          .units = "mass length time^-2",
          .validity =
              "exact for the mean over a time in which the momentum does not change; periodic along gravity",
          .parameters = {count(), mass(), gravity()},
          .evaluate = [](const Arguments& given) { return steady_wall_friction(particles_from(given)); }};
}
}  // namespace

std::vector<Law> falling_laws() {
  return {falling_law("falling-height", "height of the centre of mass in free fall", "length",
                      {gravity(), time(), height(), start()}, falling_height),
          falling_law("falling-velocity", "velocity of the centre of mass in free fall, upwards",
                      "length/time", {gravity(), time(), start()}, falling_velocity),
          fall_time_law(),
          impulse_law(),
          loss_law(),
          packing_law(),
          friction_law()};
}

}  // namespace sandglass::law
