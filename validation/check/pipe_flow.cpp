#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/pipe.hpp"
#include "validation/check/worst.hpp"
#include "validation/law/falling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// Steady flow: what walls give against what gravity takes. A particle that hybrid Monte Carlo refuses a move feels no
// gravity in that step (Mueller 2001, 2.3.2), so the weight that acts is that of the others.

namespace sandglass {

namespace {
/// Part of all moves that gravity acted on: exact for a fixed time step.
double moved_share(const Subject& subject, std::size_t replica) {
  const auto& counters = subject.record().replicas[replica].counters;
  const auto refused = counters.find("moves-refused");
  return refused == counters.end() ? 1 : 1 - refused->second / counters.at("particle-moves");
}

bool has_exact_weight(const Scene& scene) {
  return is_falling_pipe(scene) && (touches(scene) || scene.method.time_step.fixed.has_value());
}

/// Along gravity, so that it is positive.
double weight_of(const Subject& subject) {
  const Scene& scene = subject.scene();
  const double gravity = scene.gravity[static_cast<std::size_t>(pipe_axis(scene))];
  return law::steady_wall_friction(
      {subject.particles() * scene.method.weight, subject.species().mass, std::abs(gravity), 0, 0});
}

/// Force of the particles on all walls along gravity, at each sample.
std::vector<double> wall_friction(const Subject& subject, std::size_t replica) {
  const Series& series = subject.series(replica, "wall-force");
  const auto dimension = static_cast<std::size_t>(subject.dimension());
  const auto along = static_cast<std::size_t>(pipe_axis(subject.scene()));
  const std::size_t width = series.quantity.size();
  std::vector<double> friction(series.samples(), 0.0);
  for (std::size_t t = 0; t < friction.size(); ++t)
    for (std::size_t i = along; i < width; i += dimension)
      friction[t] += series.value[t * width + i] * sign_of_gravity(subject.scene());
  return friction;
}

/// Momentum along gravity that the walls took up to the last sample and that the particles gained.
double momentum_given(const Subject& subject, std::size_t replica) {
  const Series& force = subject.series(replica, "wall-force");
  const std::vector<double> friction = wall_friction(subject, replica);
  double taken = 0, before = 0;
  for (std::size_t t = 0; t < friction.size(); ++t) {
    taken += friction[t] * (force.time[t] - before);
    before = force.time[t];
  }
  const auto along = static_cast<std::size_t>(pipe_axis(subject.scene()));
  const Series& momentum = subject.series(replica, "momentum");
  const std::size_t width = momentum.quantity.size();
  return taken + sign_of_gravity(subject.scene()) *
                     (momentum.value[momentum.value.size() - width + along] - momentum.value[along]);
}

/// Every move of a particle rounds its momentum once and the walls' sum once: half an epsilon of a magnitude of the
/// speed over the momentum that gravity gives in a step, and at worst all on one side.
double rounding(const Subject& subject) {
  const auto& momenta = subject.series(0, "momentum-scale").value;
  const double largest = *std::max_element(momenta.begin(), momenta.end());
  const auto& counters = subject.record().replicas.front().counters;
  const double time = subject.series(0, "momentum").time.back();
  const double operations = counters.at("steps") + 8 * counters.at("collisions") / subject.particles();
  return std::numeric_limits<double>::epsilon() * (operations + subject.particles()) * largest /
         (weight_of(subject) * time);
}

Evidence pipe_momentum(const Subject& subject, const law::Arguments&) {
  double worst = 0;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const double weight =
        weight_of(subject) * moved_share(subject, replica) * subject.series(replica, "momentum").time.back();
    keep_worst(worst, std::abs(momentum_given(subject, replica) / weight - 1));
  }
  Evidence evidence;
  evidence.value = worst;
  evidence.budget.systematic = rounding(subject);
  evidence.budget.reason = "rounding of moves, collisions and sums";
  return evidence;
}

Evidence steady_friction(const Subject& subject, const law::Arguments& numbers) {
  std::vector<std::vector<double>> samples;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const std::vector<double>& time = subject.series(replica, "wall-force").time;
    std::vector<double> friction = wall_friction(subject, replica);
    const auto settled = std::upper_bound(time.begin(), time.end(), numbers.at("settle-time")) - time.begin();
    friction.erase(friction.begin(), friction.begin() + settled);
    if (friction.size() < 2)
      throw InputError("fewer than 2 samples of 'wall-force' after 'settle-time': run longer, or lower it");
    for (double& value : friction) value /= weight_of(subject) * moved_share(subject, replica);
    samples.push_back(std::move(friction));
  }
  return from_mean(pooled(samples), 1);
}

}  // namespace

std::vector<CheckInfo> pipe_flow_checks() {
  CheckInfo balance{"pipe-momentum",
                    "momentum that gravity gives the moving particles of a pipe, less what walls took and "
                    "particles kept, over itself",
                    "steady-wall-friction",
                    {"momentum", "momentum-scale", "wall-force"},
                    false,
                    {},
                    has_exact_weight,
                    pipe_momentum};
  CheckInfo steady{"pipe-friction",
                   "friction of the walls of a pipe over the weight of the particles that moved",
                   "steady-wall-friction",
                   {"wall-force"},
                   true,
                   {law::Parameter{"settle-time", "time", "samples before it are left out", 0, 1e12}},
                   has_exact_weight,
                   steady_friction};
  return {std::move(balance), std::move(steady)};
}

}  // namespace sandglass
