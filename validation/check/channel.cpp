#include "validation/check/families.hpp"
#include "validation/check/stream_field.hpp"

#include <cmath>

#include <fmt/format.h>

// A stream between two walls (Kawasaki 1986, section 5.2): the core that the walls do not reach, the layer beside them.

namespace sandglass {

namespace {
using Some = StreamField::Some;
using Part = StreamField::Part;
using State = StreamField::State;

/// The middle quarter of the height, and the twentieth beside each wall.
constexpr double kCore = 0.75, kWall = 0.1;

Part core_at_exit() { return {0.9, 1, kCore, 1}; }
Part core() { return {0.25, 0.9, kCore, 1}; }
Part wall() { return {0.25, 0.9, 0, kWall}; }

Figure::Points along(const StreamField& field, const std::string& name, double from_wall, double to_wall,
                     double (*value)(const State&)) {
  Figure::Points points{name, {}, {}, {}, {}};
  for (std::size_t column = 0; column < field.columns(); ++column) {
    const Mean mean = over_replicas(field, [&](Some replicas) {
      return value(field.mean(replicas, field.column(column, from_wall, to_wall)));
    });
    points.x.push_back(field.place(column));
    points.y.push_back(mean.value);
    points.error.push_back(mean.standard_error);
  }
  return points;
}

/// Core and wall along the channel.
Figure figure_of(const StreamField& field, const std::string& title, double (*value)(const State&)) {
  return {title,
          {"distance from the inflow", "length", false},
          {"over the value that comes in", "1", false},
          {along(field, "core", kCore, 1, value), along(field, "beside the walls", 0, kWall, value)},
          {}};
}

double density_of(const State& state) { return state.density; }
double velocity_of(const State& state) { return state.velocity; }
double temperature_of(const State& state) { return state.temperature(); }

double ratio(const StreamField& field, Some replicas, double (*value)(const State&)) {
  return value(field.mean(replicas, wall())) / value(field.mean(replicas, core()));
}

using Measure = double (*)(const StreamField&, Some);

/// A word of the source is an interval that the case gives.
CheckInfo word_check(std::string name, std::string summary, std::string law, std::string title,
                     double (*drawn)(const State&), Measure measure) {
  return {std::move(name),
          std::move(summary),
          std::move(law),
          {"fields", "spin-temperature"},
          false,
          {{"settle-time", "time", "samples before it are left out", 0, 1e12},
           {"low", "1", "least value that the words of the source allow", -1e12, 1e12},
           {"high", "1", "largest value that they allow", -1e12, 1e12}},
          is_channel,
          [=](const Subject& subject, const law::Arguments& numbers) {
            const StreamField field(subject, numbers.at("settle-time"));
            Evidence evidence =
                from_mean(over_replicas(field, [&](Some replicas) { return measure(field, replicas); }),
                          numbers.at("low"));
            evidence.kind = Expectation::between;
            evidence.upper = numbers.at("high");
            evidence.figures.push_back(figure_of(field, title, drawn));
            return evidence;
          }};
}

/// Thickness by which a wall's layer displaces the stream, integral of 1 - u/u_core over half the height.
double displacement(const StreamField& field, Some replicas, double from, double to) {
  const double core = field.mean(replicas, {from, to, kCore, 1}).velocity;
  const double mean = field.mean(replicas, {from, to}).velocity_by_place;
  return (1 - mean / core) * field.subject().scene().domain.size[1] / 2;
}

Evidence layer_thickness(const Subject& subject, const law::Arguments& numbers) {
  const StreamField field(subject, numbers.at("settle-time"));
  const double length = subject.scene().domain.size[0];
  const double from = numbers.at("from") / length, to = numbers.at("to") / length;
  Evidence evidence =
      from_mean(over_replicas(field, [&](Some replicas) { return displacement(field, replicas, from, to); }),
                numbers.at("low"));
  evidence.kind = Expectation::between;
  evidence.upper = numbers.at("high");
  evidence.units = "length";
  Figure::Points points{"thickness", {}, {}, {}, {}};
  for (std::size_t column = 0; column < field.columns(); ++column) {
    const Part part = field.column(column);
    const Mean mean = over_replicas(
        field, [&](Some replicas) { return displacement(field, replicas, part.x_low, part.x_high); });
    points.x.push_back(field.place(column));
    points.y.push_back(mean.value);
    points.error.push_back(mean.standard_error);
  }
  evidence.figures.push_back({"Layer at a wall",
                              {"distance from the inflow", "length", false},
                              {"displacement thickness", "length", false},
                              {std::move(points)},
                              {}});
  return evidence;
}
}  // namespace

std::vector<CheckInfo> channel_checks() {
  return {
      word_check("channel-core-speed", "velocity in the core at the exit, over that of the inflow",
                 "cooling-stream-velocity", "Velocity along the channel", velocity_of,
                 [](const StreamField& field, Some replicas) {
                   return field.mean(replicas, core_at_exit()).velocity;
                 }),
      word_check("channel-core-temperature", "temperature in the core at the exit, over that of the inflow",
                 "cooling-stream-translation", "Temperature along the channel", temperature_of,
                 [](const StreamField& field, Some replicas) {
                   return field.mean(replicas, core_at_exit()).temperature();
                 }),
      word_check("channel-wall-density", "density beside the walls over that of the core", "",
                 "Density along the channel", density_of,
                 [](const StreamField& field, Some replicas) { return ratio(field, replicas, density_of); }),
      {"channel-layer-thickness",
       "displacement thickness of the layer at a wall, from one place along the channel to another",
       "",
       {"fields"},
       false,
       {{"settle-time", "time", "samples before it are left out", 0, 1e12},
        {"from", "length", "where the part of the channel begins", 0, 1e12},
        {"to", "length", "where it ends", 0, 1e12},
        {"low", "length", "least thickness", -1e12, 1e12},
        {"high", "length", "largest thickness", -1e12, 1e12}},
       is_channel,
       layer_thickness}};
}

}  // namespace sandglass
