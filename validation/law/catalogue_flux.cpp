#include "validation/law/catalogue.hpp"
#include "validation/law/flux.hpp"
#include "validation/law/parameters.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kValidity = "a drifting Maxwellian on both sides of the plane, any density";

Stream stream_from(const Arguments& arguments) {
  Stream stream;
  stream.mass = arguments.at("mass");
  stream.temperature = arguments.at("temperature");
  stream.velocity = arguments.at("stream-velocity");
  if (const auto density = arguments.find("number-density"); density != arguments.end())
    stream.number_density = density->second;
  return stream;
}

std::vector<Parameter> stream_parameters() {
  return {any_real("stream-velocity", "length/time", "mean velocity normal to the plane"), temperature(),
          mass()};
}

Law rate_law(std::string name, std::string summary, std::string source, double (*rate)(const Stream&)) {
  std::vector<Parameter> parameters = stream_parameters();
  parameters.push_back(positive("number-density", "length^-dimension", "particles per area or volume"));
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = std::move(source),
          .units = "length^(1-dimension) time^-1",
          .validity = kValidity,
          .parameters = std::move(parameters),
          .evaluate = [rate](const Arguments& arguments) { return rate(stream_from(arguments)); }};
}

Law mean_law(std::string name, std::string summary, double (*mean)(const Stream&)) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = "first moment of Baryshev 2003, eq. 3.28 and 3.29; docs/theory.md",
          .units = "length/time",
          .validity = kValidity,
          .parameters = stream_parameters(),
          .evaluate = [mean](const Arguments& arguments) { return mean(stream_from(arguments)); }};
}

Law velocity_law(std::string name, std::string summary, std::string source, std::string units,
                 double (*result)(const Stream&, double)) {
  std::vector<Parameter> parameters = stream_parameters();
  parameters.push_back(
      any_real("velocity", "length/time", "velocity of the crossing particle, normal to the plane"));
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = std::move(source),
          .units = std::move(units),
          .validity = kValidity,
          .parameters = std::move(parameters),
          .evaluate = [result](const Arguments& arguments) {
            return result(stream_from(arguments), arguments.at("velocity"));
          }};
}

std::vector<Law> distribution_laws() {
  return {
      velocity_law("flux-density-forward", "probability density of forward crossing velocities",
                   "Baryshev 2003, eq. 3.29", "time/length", flux_density_forward),
      velocity_law("flux-density-backward", "probability density of backward crossing velocities",
                   "Baryshev 2003, eq. 3.28", "time/length", flux_density_backward),
      velocity_law("flux-cumulative-forward", "probability of a forward crossing velocity below `velocity`",
                   "Baryshev 2003, eq. 3.40", "1", flux_cumulative_forward),
      velocity_law("flux-cumulative-backward", "probability of a backward crossing velocity below `velocity`",
                   "Baryshev 2003, eq. 3.47", "1", flux_cumulative_backward)};
}
}  // namespace

std::vector<Law> flux_laws() {
  std::vector<Law> laws = {
      rate_law("flux-forward", "crossings with positive velocity per area and time",
               "Baryshev 2003, eq. 3.17", flux_forward),
      rate_law("flux-backward", "crossings with negative velocity per area and time",
               "Baryshev 2003, eq. 3.15", flux_backward),
      rate_law("flux-net", "forward less backward crossings per area and time", "Baryshev 2003, eq. 3.19",
               flux_net),
      mean_law("flux-mean-forward", "mean velocity of forward crossings", flux_mean_forward),
      mean_law("flux-mean-backward", "mean velocity of backward crossings", flux_mean_backward)};
  for (Law& law : distribution_laws()) laws.push_back(std::move(law));
  return laws;
}

}  // namespace sandglass::law
