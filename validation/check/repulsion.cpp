#include "sim/base/error.hpp"
#include "sim/scene/method/mixing.hpp"
#include "validation/check/families.hpp"
#include "validation/check/few_body_frames.hpp"
#include "validation/check/worst.hpp"
#include "validation/law/mixing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// Two and three particles of a mixing fluid, by their frames.

namespace sandglass {

namespace {
law::PairRepulsion repulsion_of(const Scene& scene) {
  const auto& options = *repulsion_in(scene);
  return {options.repulsion_coefficient,
          static_cast<double>(options.repulsion_exponent),
          static_cast<double>(options.core_exponent),
          options.softening_length,
          scene.species.front().diameter,
          options.cutoff.value_or(HUGE_VAL)};
}

bool repels(const Scene& scene, std::size_t particles) {
  return repulsion_in(scene) && repulsion_in(scene)->cutoff && scene.gravity.empty() &&
         scene.given.size() == particles;
}

double mass_of(const Scene& scene, std::size_t particle) {
  return scene.species.at(scene.given[particle].species).mass;
}

struct Encounter {
  double mass, speed, impact, closest;
  Vector<3> ahead,
      aside;  ///< unit vectors: of the relative velocity at the start, and of the impact parameter
  law::PairRepulsion repulsion;
};

Encounter encounter_of(const Scene& scene) {
  const auto difference = [](const std::vector<double>& a, const std::vector<double>& b) {
    return Vector<3>(in_space(a) - in_space(b));
  };
  const Vector<3> place = difference(scene.given[1].position, scene.given[0].position);
  const Vector<3> velocity = difference(scene.given[1].velocity, scene.given[0].velocity);
  Encounter all;
  all.repulsion = repulsion_of(scene);
  all.mass = mass_of(scene, 0) + mass_of(scene, 1);
  all.speed = velocity.norm();
  all.ahead = velocity / all.speed;
  const Vector<3> offset = place - place.dot(all.ahead) * all.ahead;
  all.impact = offset.norm();
  if (!(all.impact > 0) || !(place.norm() > all.repulsion.cutoff))
    throw InputError("the particles must start beyond the cutoff, and not head-on");
  all.aside = offset / all.impact;
  all.closest = law::turning_distance(all.repulsion, all.mass, all.speed, all.impact);
  return all;
}

/// Far away again the shadow energy of the leapfrog is the energy, so that the curvature of the force bends the orbit by
/// (omega dt)^2/8 at most (Hairer, Lubich & Wanner 2006, IX.4). Where the force jumps, at the cutoff and with a softening at
/// a diameter, the step on which it does gives up to a whole kick too much or too little, on the way in and out.
double encounter_bound(const Encounter& all, double dt) {
  const auto push = [&](double r) { return law::repulsion_acceleration(all.repulsion, all.mass, r); };
  const auto jump = [&](double r) { return std::abs(push(r * (1 - 1e-9)) - push(r)); };
  const double width = 1e-5 * all.closest;
  const double stiffness = std::abs(push(all.closest + width) - push(all.closest - width)) / (2 * width);
  const double jumps = jump(all.repulsion.cutoff * (1 - 1e-12)) + jump(all.repulsion.diameter);
  return stiffness * dt * dt / 8 + 2 * dt * (jumps + push(all.repulsion.cutoff * (1 - 1e-9))) / all.speed;
}

Evidence encounter(const Subject& subject, const law::Arguments&) {
  const Scene& scene = subject.scene();
  const Encounter all = encounter_of(scene);
  const Frame& last = frames_with_ids(subject).back();
  const BallPhase first = ball_in(last, 0, 2), second = ball_in(last, 1, 2);
  if (!((second.position - first.position).norm() > all.repulsion.cutoff))
    throw InputError("the particles are still within the cutoff: run longer");
  const double angle = law::deflection_angle(all.repulsion, all.mass, all.speed, all.impact);
  const Vector<3> expected = all.speed * (std::cos(angle) * all.ahead + std::sin(angle) * all.aside);
  Evidence evidence;
  evidence.law = "repulsion-deflection";
  evidence.value = (second.velocity - first.velocity - expected).norm() / all.speed;
  evidence.budget.systematic = encounter_bound(all, scene.method.time_step.fixed.value());
  evidence.budget.reason = "second order of the leapfrog, and a kick where the force jumps";
  return evidence;
}

/// What a small relative change of the frequency does to the place after n steps, over the amplitude.
double sensitivity(double angle, double steps) {
  const double turn = 1 - angle * angle / 2;
  return steps * angle * angle / std::sqrt(std::abs(1 - turn * turn));
}

/// The cubic part of the force, q (q + 1)/(6 a^2) of the linear one, changes the frequency by 3/8 of that times x^2
/// (Landau & Lifshitz, Mechanics, section 28); taken twice, with the largest x. The light particle pushes the heavy ones
/// out, by the share (m/M) (omega t)^2/(4 (q - 1)) of a, and the frequency falls by q/2 of that. Each step rounds the
/// place, and the velocity with it.
double cage_bound(const Scene& scene, double angle, double steps, double half, double largest) {
  const law::PairRepulsion repulsion = repulsion_of(scene);
  const double q = repulsion.exponent + repulsion.core_exponent, bend = largest / half;
  const double recoil = mass_of(scene, 0) / mass_of(scene, 1) * angle * angle * steps * steps / (4 * (q - 1));
  const double rounding =
      std::numeric_limits<double>::epsilon() * scene.given[2].position[0] * steps * steps / largest;
  return sensitivity(angle, steps) * (q * (q + 1) / 8 * bend * bend + q / 2 * recoil) + rounding;
}

Evidence cage(const Subject& subject, const law::Arguments&) {
  const Scene& scene = subject.scene();
  const double half = (scene.given[2].position[0] - scene.given[1].position[0]) / 2;
  const double centre = scene.given[1].position[0] + half;
  const double from = scene.given[0].position[0] - centre;
  const double dt = scene.method.time_step.fixed.value();
  const double angle = dt * law::cage_frequency(repulsion_of(scene), mass_of(scene, 1), half);
  Evidence evidence;
  evidence.law = "leapfrog-place";
  double largest = 0, steps = 0;
  Figure figure{
      "Place between two heavy particles", {"step", "1", false}, {"place", "length", false}, {}, {}};
  Figure::Points points{"measured", {}, {}, {}, {}};
  for (const Frame& frame : frames_with_ids(subject)) {
    steps = static_cast<double>(frame.step);
    const double place = ball_in(frame, 0, 2).position[0] - centre;
    const double expected = from * law::leapfrog_place(angle, steps);
    largest = std::max(largest, std::abs(expected));
    keep_worst(evidence.value, std::abs(place - expected));
    points.x.push_back(steps);
    points.y.push_back(place);
    points.error.push_back(0);
    points.expected.push_back(expected);
  }
  evidence.value /= largest;
  evidence.budget.systematic = cage_bound(scene, angle, steps, half, largest);
  evidence.budget.reason = "cubic part of the force, recoil of the heavy particles, rounding";
  figure.points.push_back(std::move(points));
  evidence.figures.push_back(std::move(figure));
  return evidence;
}

bool is_encounter(const Scene& scene) { return repels(scene, 2); }

/// A light particle between two heavy ones on a line along x, which do not reach each other.
bool is_cage(const Scene& scene) {
  if (!repels(scene, 3) || repulsion_in(scene)->softening_length > 0) return false;
  const double distance = scene.given[2].position[0] - scene.given[1].position[0];
  return mass_of(scene, 1) == mass_of(scene, 2) && distance >= *repulsion_in(scene)->cutoff &&
         distance / 2 < scene.species.front().diameter;
}
}  // namespace

std::vector<CheckInfo> repulsion_checks() {
  return {
      {"pair-deflection",
       "relative velocity after an encounter of two repelling particles less that of the orbit, over the "
       "speed",
       "repulsion-deflection",
       {},
       false,
       {},
       is_encounter,
       encounter},
      {"leapfrog-in-a-cage",
       "largest deviation of a light particle between two heavy ones from the leapfrog's own solution, over "
       "its amplitude",
       "leapfrog-place",
       {},
       false,
       {},
       is_cage,
       cage}};
}

}  // namespace sandglass
