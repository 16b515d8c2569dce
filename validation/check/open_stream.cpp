#include "validation/check/families.hpp"
#include "validation/check/stream_field.hpp"
#include "validation/check/worst.hpp"

#include <fmt/format.h>

// Streams whose far side sends back what the gas beyond it would: they stay what comes in, all along.

namespace sandglass {

namespace {
using Value = double StreamField::State::*;

Figure profile_of(const StreamField& field, const char* name, Value value) {
  Figure figure{"Along the stream",
                {"distance from the inflow", "length", false},
                {fmt::format("{} over that of the stream", name), "1", false},
                {},
                {}};
  Figure::Points points{name, {}, {}, {}, {}};
  Figure::Line line{"the stream", {}, {}};
  for (std::size_t column = 0; column < field.columns(); ++column) {
    const Mean mean = over_replicas(
        field, [&](StreamField::Some replicas) { return field.mean(replicas, field.column(column)).*value; });
    points.x.push_back(field.place(column));
    points.y.push_back(mean.value);
    points.error.push_back(mean.standard_error);
    points.expected.push_back(1);
    line.x.push_back(field.place(column));
    line.y.push_back(1);
  }
  figure.points.push_back(std::move(points));
  figure.lines.push_back(std::move(line));
  return figure;
}

/// In the bins between two places, over what the inflow says; the worst.
Evidence held(const Subject& subject, const law::Arguments& numbers, const char* name, Value value) {
  const StreamField field(subject, numbers.at("settle-time"));
  WorstRatio worst;
  for (std::size_t column = 0; column < field.columns(); ++column) {
    const StreamField::Part part = field.column(column);
    if (part.x_low < numbers.at("from") - 1e-9 || part.x_high > numbers.at("to") + 1e-9) continue;
    worst.offer(
        over_replicas(field, [&](StreamField::Some replicas) { return field.mean(replicas, part).*value; }),
        fmt::format("{:.3g}", field.place(column)));
  }
  Evidence evidence = worst.evidence();
  evidence.summary = fmt::format("{} in each bin over that of the stream; worst at {}", name, worst.label());
  evidence.figures.push_back(profile_of(field, name, value));
  return evidence;
}

Evidence stream_density(const Subject& subject, const law::Arguments& numbers) {
  return held(subject, numbers, "density", &StreamField::State::density);
}
Evidence stream_velocity(const Subject& subject, const law::Arguments& numbers) {
  return held(subject, numbers, "velocity", &StreamField::State::velocity);
}
Evidence stream_temperature(const Subject& subject, const law::Arguments& numbers) {
  return held(subject, numbers, "temperature", &StreamField::State::translation);
}

bool is_held_stream(const Scene& scene) {
  return is_free_stream(scene) && scene.species.front().restitution == 1 && !scene.outflows.empty();
}

std::vector<law::Parameter> numbers() {
  const auto place = [](const char* name, double fallback) {
    return law::Parameter{.name = name,
                          .units = "1",
                          .summary = "part of the length that is compared",
                          .low = 0,
                          .high = 1,
                          .fallback = fallback};
  };
  return {
      {"settle-time", "time", "samples before it are left out", 0, 1e12}, place("from", 0), place("to", 1)};
}
}  // namespace

std::vector<CheckInfo> open_stream_checks() {
  const auto check = [](const char* name, const char* summary, auto measure) {
    return CheckInfo{name, summary, "", {"fields"}, true, numbers(), is_held_stream, measure};
  };
  return {check("stream-density", "number density along a stream, over that of its inflow", stream_density),
          check("stream-velocity", "velocity along a stream, over that of its inflow", stream_velocity),
          check("stream-temperature", "granular temperature along a stream, over that of its inflow",
                stream_temperature)};
}

}  // namespace sandglass
