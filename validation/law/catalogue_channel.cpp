#include "validation/law/catalogue.hpp"
#include "validation/law/channel.hpp"
#include "validation/law/parameters.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kSpheres = "dilute gas of smooth hard spheres";

Parameter freedom() {
  return {.name = "degrees-of-freedom",
          .units = "1",
          .summary = "of a particle, spins included: 3 for smooth spheres, 6 for rough ones",
          .low = 1,
          .high = 6};
}
Parameter speed_ratio() {
  return positive("speed-ratio", "1", "stream velocity over the most probable thermal speed sqrt(2 T/m)");
}
Parameter supersonic() {
  return {.name = "speed-ratio",
          .units = "1",
          .summary = "of the start: stream velocity over the most probable thermal speed sqrt(2 T/m)",
          .low = 1.1,
          .high = 8};
}

Law viscosity_law() {
  return {.name = "mean-path-viscosity",
          .summary = "viscosity from mass density, mean speed and mean free path",
          .source = "Kawasaki 1986, (5.2), from Bird 1976",
          .units = "mass length^-1 time^-1",
          .validity = std::string(kSpheres) + ", first Sonine order",
          .parameters = {positive("mass-density", "mass length^-3", "of the gas"),
                         positive("mean-speed", "length/time", "thermal"),
                         positive("mean-free-path", "length", "of the gas")},
          .evaluate = [](const Arguments& given) {
            return mean_path_viscosity(given.at("mass-density"), given.at("mean-speed"),
                                       given.at("mean-free-path"));
          }};
}

Law reynolds_law() {
  return {.name = "channel-reynolds-number",
          .summary = "Reynolds number of a stream in a channel, by the viscosity of smooth spheres",
          .source = "Kawasaki 1986, (5.5)",
          .units = "1",
          .validity = kSpheres,
          .parameters = {speed_ratio(), positive("channel-height", "1", "in mean free paths")},
          .evaluate = [](const Arguments& given) {
            return channel_reynolds_number(given.at("speed-ratio"), given.at("channel-height"));
          }};
}

Law mach_law() {
  return {.name = "mach-number",
          .summary = "stream velocity over the speed of sound of an ideal gas",
          .source = "Kawasaki 1986, (5.6) and (5.7)",
          .units = "1",
          .validity = "ideal gas whose degrees of freedom share one temperature",
          .parameters = {speed_ratio(), freedom()},
          .evaluate = [](const Arguments& given) {
            return mach_number(given.at("speed-ratio"), heat_capacity_ratio(given.at("degrees-of-freedom")));
          }};
}

/// Units of the start: temperature, mass and mean free path one.
CoolingStream cooling_from(const Arguments& given) {
  return {{static_cast<int>(given.at("dimension")), given.at("restitution"),
           given.at("tangential-restitution"), given.at("moment-of-inertia")},
          1,
          given.at("speed-ratio") * most_probable_speed(1, 1),
          {1, given.at("initial-ratio")},
          1};
}

Law cooling_law(std::string name, std::string summary, double (*part)(const StreamState&, double)) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source =
              "mass, momentum and energy of a steady flow with the mean field of Huthmann & Zippelius "
              "1997; docs/theory.md",
          .units = "1",
          .validity =
              "dilute, supersonic; no viscosity and conduction: to first order in the mean free path "
              "over the length on which the stream cools",
          .parameters = {restitution(),
                         {.name = "tangential-restitution",
                          .units = "1",
                          .summary = "-1 smooth, 1 perfectly rough",
                          .low = -1,
                          .high = 1},
                         {.name = "moment-of-inertia",
                          .units = "1",
                          .summary = "q of I = q m R^2",
                          .low = 1e-6,
                          .high = 1,
                          .fallback = 0.4},
                         with_fallback(
                             parameter::elapsed("initial-ratio", "1", "T_r/T_t where the stream begins"), 1),
                         supersonic(),
                         elapsed("mean-free-paths", "1", "downstream, in mean free paths of the start"),
                         dimension()},
          .evaluate = [part](const Arguments& given) {
            const CoolingStream start = cooling_from(given);
            return part(cooling_stream(start, given.at("mean-free-paths")), start.velocity);
          }};
}

Law falling_law(std::string name, std::string summary, double (*part)(const StreamState&, double)) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = "mass, momentum and energy of a steady flow; docs/theory.md",
          .units = "1",
          .validity = "ideal gas, supersonic without a shock, mirrors below and above; far downstream",
          .parameters = {supersonic(),
                         positive("potential", "1", "m g h/T: of the lid, over the temperature of the start"),
                         freedom()},
          .evaluate = [part](const Arguments& given) {
            const double velocity = given.at("speed-ratio") * most_probable_speed(1, 1);
            return part(falling_stream_end(
                            {1, 1, velocity, given.at("potential"), 1, given.at("degrees-of-freedom")}),
                        velocity);
          }};
}
}  // namespace

std::vector<Law> channel_laws() {
  const auto velocity = [](const StreamState& state, double start) { return state.velocity / start; };
  const auto translation = [](const StreamState& state, double) { return state.temperature.translation; };
  const auto rotation = [](const StreamState& state, double) { return state.temperature.rotation; };
  return {
      viscosity_law(),
      reynolds_law(),
      mach_law(),
      cooling_law("cooling-stream-velocity",
                  "velocity of a stream of inelastic particles downstream, over that of its start", velocity),
      cooling_law("cooling-stream-translation", "its translational temperature, over that of its start",
                  translation),
      cooling_law("cooling-stream-rotation",
                  "its rotational temperature, over the translational one of its start", rotation),
      falling_law("falling-stream-velocity",
                  "velocity of a stream that has come to rest on a floor, over that of its start", velocity),
      falling_law("falling-stream-temperature", "its temperature, over that of its start", translation)};
}

}  // namespace sandglass::law
