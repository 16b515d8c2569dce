#include "validation/check/families.hpp"
#include "validation/check/stream_field.hpp"
#include "validation/check/worst.hpp"
#include "validation/law/sedimentation.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

// A stream that falls to the floor of a channel between mirrors (Kawasaki 1986, section 5.3): what it comes to far
// downstream, and the swing on the way there.

namespace sandglass {

namespace {
using Some = StreamField::Some;
using Part = StreamField::Part;

Part downstream(const law::Arguments& numbers) { return {numbers.at("from"), numbers.at("to")}; }

/// Of the temperature, by what moves upstream in the stream at rest: it would have come from beyond the exit, and a share
/// exp(-x/lambda) of it still flies freely a distance x before that.
double lack_of_return(const Subject& subject, const law::StreamState& end, double from_exit) {
  const double a = end.velocity / std::sqrt(end.temperature.translation / subject.species().mass);
  const double at_exit =
      a * std::exp(-a * a / 2) / std::sqrt(2 * std::numbers::pi) / 3 + std::erfc(a / std::numbers::sqrt2) / 2;
  return at_exit * std::exp(-from_exit / inflow_mean_free_path(subject));
}

double systematic(const Subject& subject, const law::Arguments& numbers) {
  return lack_of_return(subject, law::falling_stream_end(falling_stream_of(subject)),
                        (1 - numbers.at("to")) * subject.scene().domain.size[0]);
}

Figure height_figure(const StreamField& field) {
  Figure figure{"Mean height along the channel",
                {"distance from the inflow", "length", false},
                {"mean height of the particles", "length", false},
                {},
                {}};
  const law::FallingStream stream = falling_stream_of(field.subject());
  const double rest = law::mean_column_height(
      {stream.mass, law::falling_stream_end(stream).temperature.translation, stream.gravity, stream.height});
  Figure::Points points{"measured", {}, {}, {}, {}};
  for (std::size_t column = 0; column < field.columns(); ++column) {
    const Mean mean = over_replicas(
        field, [&](Some replicas) { return field.mean(replicas, field.column(column)).height; });
    points.x.push_back(field.place(column));
    points.y.push_back(mean.value);
    points.error.push_back(mean.standard_error);
  }
  figure.lines.push_back({"at rest, by the law", {0, field.subject().scene().domain.size[0]}, {rest, rest}});
  figure.points.push_back(std::move(points));
  return figure;
}

Evidence at_rest(const Subject& subject, const law::Arguments& numbers,
                 const std::function<double(const StreamField::State&)>& measured, double expected) {
  const StreamField field(subject, numbers.at("settle-time"));
  Evidence evidence = from_mean(
      over_replicas(field,
                    [&](Some replicas) { return measured(field.mean(replicas, downstream(numbers))); }),
      expected);
  evidence.budget.systematic = systematic(subject, numbers) * expected;
  evidence.budget.reason = "the vacuum beyond the exit sends nobody back";
  evidence.figures.push_back(height_figure(field));
  return evidence;
}

Evidence rest_temperature(const Subject& subject, const law::Arguments& numbers) {
  const law::FallingStream stream = falling_stream_of(subject);
  return at_rest(
      subject, numbers, [](const StreamField::State& s) { return s.temperature(); },
      law::falling_stream_end(stream).temperature.translation / stream.temperature);
}

Evidence rest_velocity(const Subject& subject, const law::Arguments& numbers) {
  const law::FallingStream stream = falling_stream_of(subject);
  return at_rest(
      subject, numbers, [](const StreamField::State& s) { return s.velocity; },
      law::falling_stream_end(stream).velocity / stream.velocity);
}

/// Density at each height over the barometric one, whose mean is what the inflow brings at the end's velocity.
Evidence rest_profile(const Subject& subject, const law::Arguments& numbers) {
  const StreamField field(subject, numbers.at("settle-time"));
  const law::FallingStream stream = falling_stream_of(subject);
  const law::StreamState end = law::falling_stream_end(stream);
  const law::Column column{stream.mass, end.temperature.translation, stream.gravity, stream.height};
  const double bins = static_cast<double>(field.rows()), thick = stream.height / bins;
  WorstRatio worst;
  for (std::size_t row = 0; row < field.rows(); ++row) {
    const double low = static_cast<double>(row) * thick;
    const double expected =
        stream.velocity / end.velocity * bins *
        (law::barometric_fraction(column, low + thick) - law::barometric_fraction(column, low));
    Part part = downstream(numbers);
    part.row = row;
    worst.offer(
        over_replicas(field, [&](Some replicas) { return field.mean(replicas, part).density / expected; }),
        fmt::format("height {:.3g}", low + thick / 2));
  }
  Evidence evidence = worst.evidence();
  evidence.summary = "density at each height far downstream over the barometric one; worst: " + worst.label();
  evidence.budget.systematic = systematic(subject, numbers);
  evidence.budget.reason = "the vacuum beyond the exit sends nobody back";
  return evidence;
}

std::vector<double> heights(const StreamField& field, Some replicas) {
  std::vector<double> heights;
  for (std::size_t column = 0; column < field.columns(); ++column)
    heights.push_back(field.mean(replicas, field.column(column)).height);
  return heights;
}

/// Of the lowest mean height before the exit's last tenth: the vertex of the parabola through it and its neighbours.
std::size_t lowest(const std::vector<double>& heights) {
  std::size_t best = 1;
  for (std::size_t i = 1; i + 1 < heights.size() * 9 / 10; ++i)
    if (heights[i] < heights[best]) best = i;
  return best;
}

double vertex(const StreamField& field, const std::vector<double>& heights, std::size_t i) {
  const double low = heights[i - 1], middle = heights[i], high = heights[i + 1];
  const double curvature = low - 2 * middle + high;
  const double shift = curvature > 0 ? (low - high) / (2 * curvature) : 0;
  return field.place(i) + shift * (field.place(1) - field.place(0));
}

double overshoot_place(const StreamField& field, Some replicas) {
  const std::vector<double> height = heights(field, replicas);
  return vertex(field, height, lowest(height));
}

/// Where the mean height is back at that of rest: straight between the columns.
double recovery_place(const StreamField& field, Some replicas) {
  const law::FallingStream stream = falling_stream_of(field.subject());
  const double rest = law::mean_column_height(
      {stream.mass, law::falling_stream_end(stream).temperature.translation, stream.gravity, stream.height});
  const std::vector<double> height = heights(field, replicas);
  for (std::size_t i = lowest(height); i + 1 < height.size(); ++i)
    if (height[i + 1] >= rest)
      return field.place(i) +
             (rest - height[i]) / (height[i + 1] - height[i]) * (field.place(1) - field.place(0));
  return std::nan("");
}

Evidence place_between(const Subject& subject, const law::Arguments& numbers,
                       double (*place)(const StreamField&, Some)) {
  const StreamField field(subject, numbers.at("settle-time"));
  Evidence evidence = from_mean(over_replicas(field, [&](Some replicas) { return place(field, replicas); }),
                                numbers.at("low"));
  evidence.kind = Expectation::between;
  evidence.upper = numbers.at("high");
  evidence.units = "length";
  evidence.figures.push_back(height_figure(field));
  return evidence;
}

law::Parameter settle_time() { return {"settle-time", "time", "samples before it are left out", 0, 1e12}; }

CheckInfo rest_check(std::string name, std::string summary, std::string law,
                     Evidence (*evaluate)(const Subject&, const law::Arguments&)) {
  const auto part = [](const char* key, const char* text) {
    return law::Parameter{.name = key, .units = "1", .summary = text, .low = 0, .high = 1};
  };
  return {std::move(name),
          std::move(summary),
          std::move(law),
          {"fields", "spin-temperature"},
          true,
          {settle_time(), part("from", "part of the length after which the stream is at rest"),
           part("to", "part of the length up to which it is looked at")},
          is_falling_stream,
          evaluate,
          true};
}

CheckInfo place_check(std::string name, std::string summary, double (*place)(const StreamField&, Some)) {
  return {std::move(name),
          std::move(summary),
          "",
          {"fields"},
          false,
          {settle_time(),
           {"low", "length", "nearest place that the words of the source allow", 0, 1e12},
           {"high", "length", "farthest place that they allow", 0, 1e12}},
          is_falling_stream,
          [place](const Subject& subject, const law::Arguments& numbers) {
            return place_between(subject, numbers, place);
          },
          true};
}
}  // namespace

std::vector<CheckInfo> falling_stream_checks() {
  return {
      rest_check("falling-stream-temperature",
                 "temperature of a stream that has come to rest on a floor, over that of its inflow",
                 "falling-stream-temperature", rest_temperature),
      rest_check("falling-stream-velocity", "its velocity there, over that of its inflow",
                 "falling-stream-velocity", rest_velocity),
      rest_check("falling-stream-profile", "density at each height there, over the barometric one",
                 "sedimentation-density", rest_profile),
      place_check("falling-stream-overshoot", "where the stream is lowest", overshoot_place),
      place_check("falling-stream-recovery", "where it is back at the height of its end", recovery_place)};
}

}  // namespace sandglass
