#include "validation/law/few_body_bounce.hpp"

#include "sim/base/error.hpp"
#include "validation/check/families.hpp"
#include "validation/check/few_body_frames.hpp"
#include "validation/check/worst.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass {

namespace {
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The axis along which the ball falls: gravity points to its low side. -1 when there is none.
int fall_axis(const Scene& scene) {
  int axis = -1;
  for (std::size_t i = 0; i < scene.gravity.size(); ++i) {
    if (scene.gravity[i] > 0 || (scene.gravity[i] < 0 && axis >= 0)) return -1;
    if (scene.gravity[i] < 0) axis = static_cast<int>(i);
  }
  return axis;
}

Wall floor_of(const Scene& scene) {
  for (const Wall& wall : scene.walls)
    if (wall.axis == fall_axis(scene) && !wall.high) return wall;
  return {};
}

double gravity_of(const Scene& scene) {
  return -scene.gravity.at(static_cast<std::size_t>(fall_axis(scene)));
}

bool falls_on_floor(const Scene& scene) {
  if (!touches(scene) || scene.given.size() != 1 || fall_axis(scene) < 0 || is_rough(scene)) return false;
  const Wall floor = floor_of(scene);
  const double speed = floor.velocity.empty() ? 0 : floor.velocity[static_cast<std::size_t>(floor.axis)];
  return floor.surface.rule == SurfaceKind::specular && speed == 0 && scene.obstacles.empty() &&
         guard_of(scene.method).kind != CollapseGuard::contact_time;
}

bool is_bouncing(const Scene& scene) { return falls_on_floor(scene) && floor_of(scene).amplitude == 0; }
bool is_vibrated(const Scene& scene) {
  return falls_on_floor(scene) && floor_of(scene).amplitude > 0 &&
         guard_of(scene.method).kind == CollapseGuard::none;
}

law::BouncingBall ball_of(const Scene& scene) {
  const auto axis = static_cast<std::size_t>(fall_axis(scene));
  law::BouncingBall ball{gravity_of(scene), scene.given[0].position[axis] - scene.species[0].diameter / 2,
                         scene.given[0].velocity[axis], floor_of(scene).surface.restitution};
  if (guard_of(scene.method).kind == CollapseGuard::velocity_dependent)
    ball.reference_speed = guard_of(scene.method).reference_speed;
  return ball;
}

struct Seen {
  double height, velocity;
};

Seen seen_in(const Subject& subject, const Frame& frame) {
  const BallPhase ball = ball_in(frame, 0, subject.dimension());
  const int axis = fall_axis(subject.scene());
  return {ball.position[axis] - subject.species().diameter / 2, ball.velocity[axis]};
}

Figure height_figure(const Subject& subject, const law::BouncingBall& ball) {
  Figure figure{"Height of the ball", {"time", "time", false}, {"height", "length", false}, {}, {}};
  Figure::Points points{"run", {}, {}, {}, {}};
  for (const Frame& frame : subject.record().trajectory) {
    points.x.push_back(frame.time);
    points.y.push_back(seen_in(subject, frame).height);
    points.error.push_back(0);
    points.expected.push_back(law::bouncing_ball(ball, frame.time).height);
  }
  Figure::Line line{"flights", {}, {}};
  for (int i = 0; i <= 400; ++i) {
    line.x.push_back(points.x.back() * i / 400);
    line.y.push_back(law::bouncing_ball(ball, line.x.back()).height);
  }
  figure.points.push_back(std::move(points));
  if (ball.restitution < 1)
    figure.lines.push_back(std::move(line));  // a thousand equal flights would hide all
  return figure;
}

/// A bounce rounds its time to epsilon times the time, which is that times gravity in speed; restitution shrinks it.
Evidence bouncing_ball(const Subject& subject, const law::Arguments&) {
  const law::BouncingBall ball = ball_of(subject.scene());
  const double speed = law::bounce_speed(ball, 1), height = speed * speed / (2 * ball.gravity);
  Evidence evidence;
  for (const Frame& frame : frames_with_ids(subject)) {
    const law::BounceState expected = law::bouncing_ball(ball, frame.time);
    const Seen seen = seen_in(subject, frame);
    keep_worst(evidence.value, std::abs(seen.height - expected.height) / height);
    keep_worst(evidence.value, std::abs(seen.velocity - expected.velocity) / speed);
    evidence.budget.systematic =
        16 * epsilon * (1 + expected.bounces) * (1 + ball.gravity * frame.time / speed);
  }
  evidence.budget.reason = "rounding of the time of each bounce";
  evidence.figures.push_back(height_figure(subject, ball));
  return evidence;
}

Evidence bounces(const Subject& subject, const law::Arguments&) {
  const law::BouncingBall ball = ball_of(subject.scene());
  Evidence evidence;
  evidence.value =
      subject.record().replicas.front().counters.at("particle-moves");  // no other event moves it
  evidence.expected = law::bouncing_ball(ball, frames_with_ids(subject).back().time).bounces;
  evidence.budget.reason = "whole numbers";
  return evidence;
}

Figure orbit_figure(const std::vector<double>& time, const std::vector<double>& distance, double contraction,
                    double frequency) {
  Figure figure{
      "Distance from the orbit", {"time", "time", false}, {"relative deviation", "1", true}, {}, {}};
  Figure::Points points{"run", {}, {}, {}, {}};
  Figure::Line line{"largest eigenvalue", {}, {}};
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (distance[i] <= 0) continue;
    points.x.push_back(time[i]);
    points.y.push_back(distance[i]);
    points.error.push_back(0);
    const double expected = distance.front() * std::pow(contraction, frequency * time[i]);
    if (expected < epsilon) continue;
    line.x.push_back(time[i]);
    line.y.push_back(expected);
  }
  figure.points.push_back(std::move(points));
  if (contraction < 1) figure.lines.push_back(std::move(line));
  return figure;
}

/// The phase of the floor is rounded to 2 pi epsilon times the number of periods at each bounce; the orbit forgets it
/// after 1/(1 - contraction) bounces, and so it forgets its start.
Evidence period_one_orbit(const Subject& subject, const law::Arguments& numbers) {
  const Wall floor = floor_of(subject.scene());
  const law::VibratedBall ball{gravity_of(subject.scene()), floor.amplitude, floor.frequency,
                               floor.surface.restitution};
  const double speed = ball.gravity / ball.frequency / 2, height = speed / ball.frequency / 4;
  const double settled = numbers.at("settle-periods") / ball.frequency;
  Evidence evidence;
  std::vector<double> time, distance;
  for (const Frame& frame : frames_with_ids(subject)) {
    const law::BounceState expected = law::period_one_orbit(ball, frame.time);
    const Seen seen = seen_in(subject, frame);
    time.push_back(frame.time);
    distance.push_back(std::max(std::abs(seen.height - expected.height) / height,
                                std::abs(seen.velocity - expected.velocity) / speed));
    if (frame.time >= settled) keep_worst(evidence.value, distance.back());
  }
  const double periods = 1 + time.back() * ball.frequency, contraction = law::orbit_contraction(ball);
  const double memory = std::min(periods, contraction < 1 ? 1 / (1 - contraction) : periods);
  if (time.back() < settled) throw InputError("the run ends before 'settle-periods': make it longer");
  evidence.budget.systematic = 100 * epsilon * periods * memory +
                               (settled > 0 ? 10 * std::pow(contraction, settled * ball.frequency) : 0);
  evidence.budget.reason = "rounding of the phase, and what is left of the start";
  evidence.figures.push_back(orbit_figure(time, distance, contraction, ball.frequency));
  return evidence;
}
}  // namespace

std::vector<CheckInfo> bounce_checks() {
  const law::Parameter settle{"settle-periods", "1", "periods of the floor left out at the start", 0, 1e9};
  return {{"bouncing-ball",
           "largest deviation of height and speed from flight after flight, relative to the first",
           "bouncing-ball-time",
           {},
           false,
           {},
           is_bouncing,
           bouncing_ball},
          {"bounces",
           "number of bounces of a ball on the floor",
           "bouncing-ball-time",
           {},
           false,
           {},
           is_bouncing,
           bounces},
          {"period-one-orbit",
           "largest deviation of a ball on a vibrating floor from one bounce a period",
           "vibrated-ball-phase",
           {},
           false,
           {settle},
           is_vibrated,
           period_one_orbit}};
}

}  // namespace sandglass
