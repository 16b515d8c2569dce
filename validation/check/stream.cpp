#include "sim/base/error.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/stream_field.hpp"
#include "validation/check/worst.hpp"
#include "validation/law/transport.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

// Streams that come in by an inflow and leave into a vacuum: nobody is lost, what comes in goes out, and the stream is what
// its laws say.

namespace sandglass {

namespace {
/// Simulated particles at a sample of `fields`.
double particles_at(const Subject& subject, std::size_t replica, std::size_t sample) {
  const Series& fields = subject.series(replica, "fields");
  const auto width = static_cast<std::size_t>(subject.dimension()) + 2;
  const std::size_t bins = fields.quantity.size() / width;
  double density = 0;
  for (std::size_t bin = 0; bin < bins; ++bin) density += fields.value[(sample * bins + bin) * width];
  return density * volume(subject.scene().domain) / static_cast<double>(bins) / subject.scene().method.weight;
}

/// Of those there at the start, let in, poured and gone: who should be there at the end.
double expected_at_end(const Subject& subject, std::size_t replica) {
  const auto& counters = subject.record().replicas[replica].counters;
  const auto count = [&](const char* name) { return counters.contains(name) ? counters.at(name) : 0; };
  return static_cast<double>(particle_count(subject.scene())) + count("particles-entered") +
         count("particles-poured") - count("particles-left") - count("particles-waiting");
}

Evidence particle_balance(const Subject& subject, const law::Arguments&) {
  Evidence evidence;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const std::size_t last = subject.series(replica, "fields").samples() - 1;
    const double found = particles_at(subject, replica, last);
    keep_worst(evidence.value, std::abs(found - expected_at_end(subject, replica)));
    evidence.budget.systematic = std::max(evidence.budget.systematic, 1e-9 * found);
  }
  evidence.budget.reason = "rounding of densities";
  return evidence;
}

bool exchanges(const Scene& scene) { return !scene.inflows.empty() && has_open_side(scene.domain); }

/// Growth of the number of particles after the settle time, over what has come in since.
Evidence stream_steady(const Subject& subject, const law::Arguments& numbers) {
  std::vector<double> growth;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const std::vector<double>& time = subject.series(replica, "fields").time;
    const auto first =
        static_cast<std::size_t>(std::ranges::lower_bound(time, numbers.at("settle-time")) - time.begin());
    if (first + 1 >= time.size())
      throw InputError("no two samples of 'fields' after 'settle-time': run longer");
    double rate = 0;
    for (const Inflow& inflow : subject.scene().inflows) rate += inflow_rate(subject.scene(), inflow);
    growth.push_back(
        (particles_at(subject, replica, time.size() - 1) - particles_at(subject, replica, first)) /
        (rate * (time.back() - time[first])));
  }
  return from_mean(mean_of_independent(growth), 0);
}

Figure profile_figure(const StreamField& field, bool with_law) {
  Figure figure{"Along the stream",
                {"distance from the inflow", "length", false},
                {"over the value that comes in", "1", false},
                {},
                {}};
  const auto add = [&](const char* name, double (*value)(const StreamField::State&),
                       double (*law)(const law::StreamState&, const law::CoolingStream&)) {
    Figure::Points points{name, {}, {}, {}, {}};
    Figure::Line line{std::string("law: ") + name, {}, {}};
    const law::CoolingStream start = cooling_stream_of(field.subject());
    for (std::size_t column = 0; column < field.columns(); ++column) {
      const Mean mean = over_replicas(field, [&](StreamField::Some replicas) {
        return value(field.mean(replicas, field.column(column)));
      });
      const double x = field.place(column);
      const double expected = with_law ? law(law::cooling_stream(start, x), start) : 1;
      points.x.push_back(x);
      points.y.push_back(mean.value);
      points.error.push_back(mean.standard_error);
      points.expected.push_back(expected);
      line.x.push_back(x);
      line.y.push_back(expected);
    }
    figure.points.push_back(std::move(points));
    figure.lines.push_back(std::move(line));
  };
  add(
      "velocity", [](const StreamField::State& s) { return s.velocity; },
      [](const law::StreamState& s, const law::CoolingStream& from) { return s.velocity / from.velocity; });
  add(
      "translational temperature", [](const StreamField::State& s) { return s.translation; },
      [](const law::StreamState& s, const law::CoolingStream& from) {
        return s.temperature.translation / from.temperature.translation;
      });
  if (field.spins())
    add(
        "rotational temperature", [](const StreamField::State& s) { return s.rotation; },
        [](const law::StreamState& s, const law::CoolingStream& from) {
          return s.temperature.rotation / from.temperature.rotation;
        });
  return figure;
}

/// What moves upstream through the exit, and nobody sends: its share of the temperature is the largest. With a = U/s the part
/// of <(v - U)^2> below v = 0 is a f(a) + 1 - F(a), one of three axes.
double lack_of_return(const Subject& subject) {
  const Inflow& inflow = subject.scene().inflows.front();
  const double a = inflow.velocity[0] / std::sqrt(inflow.temperature / subject.species().mass);
  return a * std::exp(-a * a / 2) / std::sqrt(2 * std::numbers::pi) / 3 +
         std::erfc(a / std::numbers::sqrt2) / 2;
}

Evidence uniform_stream(const Subject& subject, const law::Arguments& numbers) {
  const StreamField field(subject, numbers.at("settle-time"));
  WorstRatio worst;
  for (std::size_t column = 0; column < field.columns(); ++column) {
    const auto offer = [&](const char* name, double StreamField::State::*value) {
      worst.offer(over_replicas(field,
                                [&](StreamField::Some replicas) {
                                  return field.mean(replicas, field.column(column)).*value;
                                }),
                  fmt::format("{} at {:.3g}", name, field.place(column)));
    };
    offer("density", &StreamField::State::density);
    offer("velocity", &StreamField::State::velocity);
    offer("translational temperature", &StreamField::State::translation);
    if (field.spins()) offer("rotational temperature", &StreamField::State::rotation);
  }
  Evidence evidence = worst.evidence();
  evidence.summary =
      "density, velocity and temperatures in each bin over those that come in; worst: " + worst.label();
  evidence.budget.systematic = lack_of_return(subject);
  evidence.budget.reason = "the vacuum beyond the exit sends nobody back";
  evidence.figures.push_back(profile_figure(field, false));
  return evidence;
}

/// Heat that conduction carries and stress that viscosity adds, over the enthalpy flux and the pressure, where the stream
/// comes in and cools fastest: what the law leaves out. Coefficients of smooth elastic spheres.
double gradient_terms(const law::CoolingStream& stream, const law::Gas& gas) {
  const double dx = 1e-4 * stream.mean_free_path;
  const law::StreamState next = law::cooling_stream(stream, dx);
  const double density = law::number_density(gas), t = stream.temperature.translation;
  const double heat = law::boltzmann_conductivity(gas, law::SonineOrder::first) *
                      std::abs(next.temperature.translation - t) / dx;
  const double stress = 4.0 / 3 * law::boltzmann_shear_viscosity(gas, law::SonineOrder::first) *
                        std::abs(next.velocity - stream.velocity) / dx;
  return heat / (2.5 * density * stream.velocity * t) + stress / (density * t);
}

law::Gas inflow_gas(const Subject& subject) {
  const Inflow& inflow = subject.scene().inflows.front();
  law::Gas gas = subject.gas(inflow.temperature);
  gas.fraction = inflow.number_density * law::particle_volume(gas);
  return gas;
}

/// Of the temperature; of the velocity it is T/(m u^2) times that, as m u + T/u stays what it is.
double cooling_error(const Subject& subject) {
  constexpr double kMeanField = 0.05;  // docs/theory.md: velocities and spins are not independent
  return gradient_terms(cooling_stream_of(subject), inflow_gas(subject)) + kMeanField;
}

StreamField::Part exit_of(const law::Arguments& numbers) { return {numbers.at("from"), numbers.at("to")}; }

double middle_of(const Subject& subject, const StreamField::Part& part) {
  return (part.x_low + part.x_high) / 2 * subject.scene().domain.size[0];
}

Evidence cooling_stream_temperature(const Subject& subject, const law::Arguments& numbers) {
  const StreamField field(subject, numbers.at("settle-time"));
  const StreamField::Part part = exit_of(numbers);
  const law::CoolingStream start = cooling_stream_of(subject);
  const law::StreamState law = law::cooling_stream(start, middle_of(subject, part));
  Evidence evidence = from_mean(
      over_replicas(field,
                    [&](StreamField::Some replicas) { return field.mean(replicas, part).temperature(); }),
      (law.temperature.translation / start.temperature.translation +
       law.temperature.rotation / start.temperature.rotation) /
          2);
  evidence.budget.systematic = cooling_error(subject) * evidence.expected;
  evidence.budget.reason = "heat conduction and viscosity; mean field";
  evidence.figures.push_back(profile_figure(field, true));
  return evidence;
}

Evidence cooling_stream_velocity(const Subject& subject, const law::Arguments& numbers) {
  const StreamField field(subject, numbers.at("settle-time"));
  const StreamField::Part part = exit_of(numbers);
  const law::CoolingStream start = cooling_stream_of(subject);
  Evidence evidence = from_mean(
      over_replicas(field, [&](StreamField::Some replicas) { return field.mean(replicas, part).velocity; }),
      law::cooling_stream(start, middle_of(subject, part)).velocity / start.velocity);
  evidence.budget.systematic =
      cooling_error(subject) * start.temperature.translation / (start.mass * start.velocity * start.velocity);
  evidence.budget.reason = "heat conduction and viscosity; mean field";
  return evidence;
}

bool is_uniform_stream(const Scene& scene) {
  const Species& species = scene.species.front();
  return is_free_stream(scene) && scene.domain.dimension == 3 && scene.outflows.empty() &&
         species.restitution == 1 && std::abs(species.tangential_restitution) == 1 &&
         (scene.inflows.front().spin_temperature == scene.inflows.front().temperature || !is_rough(scene));
}

bool is_cooling_stream(const Scene& scene) {
  return is_free_stream(scene) && scene.domain.dimension == 3 && is_rough(scene) &&
         !scene.species.front().friction && scene.inflows.front().spin_temperature > 0;
}

law::Parameter settle_time() { return {"settle-time", "time", "samples before it are left out", 0, 1e12}; }
law::Parameter share(const char* name, double fallback) {
  return {.name = name,
          .units = "1",
          .summary = "part of the length that is compared",
          .low = 0,
          .high = 1,
          .fallback = fallback};
}
}  // namespace

std::vector<CheckInfo> stream_checks() {
  return {{"particle-balance",
           "particles in the box less those at the start, let in and gone",
           "",
           {"fields"},
           false,
           {},
           exchanges,
           particle_balance},
          {"stream-steady",
           "growth of the number of particles after the settle time, over what has come in since",
           "",
           {"fields"},
           false,
           {settle_time()},
           exchanges,
           stream_steady,
           true},
          {"uniform-stream",
           "density, velocity and temperatures of an elastic stream in each bin, over those of its inflow",
           "flux-forward",
           {"fields"},
           true,
           {settle_time()},
           is_uniform_stream,
           uniform_stream},
          {"cooling-stream-temperature",
           "temperature of a stream of rough inelastic particles near its end, over that of its inflow",
           "cooling-stream-translation",
           {"fields", "spin-temperature"},
           true,
           {settle_time(), share("from", 0.8), share("to", 0.9)},
           is_cooling_stream,
           cooling_stream_temperature},
          {"cooling-stream-velocity",
           "its velocity there, over that of its inflow",
           "cooling-stream-velocity",
           {"fields"},
           true,
           {settle_time(), share("from", 0.8), share("to", 0.9)},
           is_cooling_stream,
           cooling_stream_velocity}};
}

}  // namespace sandglass
