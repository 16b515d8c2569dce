#include "validation/law/guarded.hpp"

#include "sim/base/error.hpp"
#include "validation/check/families.hpp"
#include "validation/law/sonine.hpp"

#include <cmath>

// Energy lost per collision under the TC model, over each interval between samples, divided by what the share of the
// guard at the run's own collision rate predicts. The rate is counted, so no contact value enters.

namespace sandglass {

namespace {
struct Interval {
  double loss;   ///< ln(E before / E after) per collision of a particle
  double cover;  ///< collisions of a particle within the contact time
};

struct Window {
  double from, to;  ///< in collisions per particle
};

std::vector<Interval> intervals(const Subject& subject, std::size_t replica, const Window& window) {
  const Series& series = subject.series(replica, "energy");
  const std::vector<double> tau = subject.collisions_per_particle(replica, series);
  const std::vector<double> energy = subject.column(replica, "energy", "");
  std::vector<Interval> found;
  for (std::size_t i = 1; i < tau.size(); ++i) {
    if (tau[i - 1] < window.from || tau[i] > window.to) continue;
    const double collisions = tau[i] - tau[i - 1];
    found.push_back(
        {std::log(energy[i - 1] / energy[i]) / collisions,
         collisions / (series.time[i] - series.time[i - 1]) * guard_of(subject.scene().method).contact_time});
  }
  if (found.empty())
    throw InputError(
        "no two samples lie between 'settle-collisions' and 'last-collisions': sample more often, or widen "
        "them");
  return found;
}

/// Loss per collision without a guard.
double unguarded_loss(const Subject& subject) {
  const double r = subject.species().restitution;
  const double a2 = law::sonine_a2(subject.dimension(), r);
  return (1 - r * r) / subject.dimension() * law::sonine_cooling_factor(a2) /
         law::sonine_collision_factor(a2);
}

law::Bounded share_of(const Subject& subject, double cover) {
  return law::guarded_share_of_contacts(subject.gas(1), cover);
}

Figure share_figure(const Subject& subject, const std::vector<Interval>& run, double unguarded) {
  Figure figure{"Share of the energy loss that the guard leaves",
                {"collisions within the contact time", "1", false},
                {"share", "1", false},
                {},
                {}};
  Figure::Points points{"first replica", {}, {}, {}, {}};
  for (const Interval& interval : run) {
    points.x.push_back(interval.cover);
    points.y.push_back(interval.loss / unguarded);
    points.error.push_back(0);
    points.expected.push_back(share_of(subject, interval.cover).value);
  }
  figure.lines.push_back({"theory", points.x, points.expected});
  figure.points.push_back(std::move(points));
  return figure;
}

Evidence guarded_cooling(const Subject& subject, const law::Arguments& numbers) {
  const Window window{numbers.at("settle-collisions"), numbers.at("last-collisions")};
  const double unguarded = unguarded_loss(subject);
  std::vector<std::vector<double>> ratios;
  double error = 0, count = 0;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    ratios.emplace_back();
    for (const Interval& interval : intervals(subject, replica, window)) {
      const law::Bounded share = share_of(subject, interval.cover);
      ratios.back().push_back(interval.loss / unguarded / share.value);
      error += share.bound / share.value;
      ++count;
    }
  }
  const Mean ratio = pooled(ratios);
  const double a2 = law::sonine_a2(subject.dimension(), subject.species().restitution);
  const double aligned = numbers.at("aligned-share") / 2;
  Evidence evidence = from_mean(ratio, 1 - aligned);
  evidence.budget.systematic = error / count + aligned + std::abs(a2) / 4 + 2 / subject.particles();
  evidence.budget.reason =
      "fit of the share to contacts; half of the energy of velocities that line up; Sonine order; 2/N";
  evidence.figures.push_back(share_figure(subject, intervals(subject, 0, window), unguarded));
  return evidence;
}
}  // namespace

std::vector<CheckInfo> guarded_checks() {
  return {
      {"guarded-cooling",
       "energy lost per collision under the TC model over what its share of elastic collisions leaves",
       "guarded-share",
       {"energy", "collisions"},
       true,
       {{"settle-collisions", "1", "collisions per particle left out at the start", 0, 1e9, 2.0},
        {"last-collisions", "1", "collisions per particle at which the gas is no longer homogeneous", 0, 1e9,
         1e9},
        {"aligned-share", "1",
         "energy of velocities that have lined up by then, which is not heat: half of it is expected, half "
         "allowed",
         0, 1, 0.0}},
       is_guarded,
       guarded_cooling}};
}

}  // namespace sandglass
