#include "validation/check/families.hpp"
#include "validation/check/few_body_frames.hpp"
#include "validation/law/few_body_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sandglass {

namespace {
/// Given from left to right, on one line, moving along it, with one restitution, and smooth.
bool is_row(const Scene& scene) {
  if (!is_few_bodies(scene) || is_rough(scene)) return false;
  for (std::size_t i = 0; i < scene.given.size(); ++i) {
    const GivenParticle& ball = scene.given[i];
    for (std::size_t axis = 1; axis < ball.position.size(); ++axis)
      if (ball.velocity[axis] != 0 || ball.position[axis] != scene.given[0].position[axis]) return false;
    if (i > 0 && ball.position[0] <= scene.given[i - 1].position[0]) return false;
    if (scene.species[ball.species].restitution != scene.species[0].restitution) return false;
  }
  return true;
}

law::RowResult three_of(const Scene& scene) {
  std::array<double, 3> masses{}, velocities{};
  for (std::size_t i = 0; i < 3; ++i) {
    masses[i] = scene.species[scene.given.at(i).species].mass;
    velocities[i] = scene.given[i].velocity[0];
  }
  return law::three_in_a_row(masses, scene.species.front().restitution, velocities);
}

/// Three, of which the left two collide first, and whose collisions come to an end.
bool is_three_in_a_row(const Scene& scene) {
  if (!is_row(scene) || scene.given.size() != 3) return false;
  const auto contact = [&scene](std::size_t left) {
    const GivenParticle &a = scene.given[left], &b = scene.given[left + 1];
    const double gap = b.position[0] - a.position[0] -
                       (scene.species[a.species].diameter + scene.species[b.species].diameter) / 2;
    const double approach = a.velocity[0] - b.velocity[0];
    return approach > 0 ? gap / approach : HUGE_VAL;
  };
  return contact(0) < contact(1) && std::isfinite(three_of(scene).collisions);
}

Evidence three_body_collisions(const Subject& subject, const law::Arguments&) {
  Evidence evidence;
  evidence.value = subject.record().replicas.front().counters.at("collisions");
  evidence.expected = three_of(subject.scene()).collisions;
  evidence.budget.reason = "whole numbers";
  return evidence;
}

Evidence last_speed(const Subject& subject, const law::Arguments&) {
  const Scene& scene = subject.scene();
  const std::size_t last = scene.given.size() - 1;
  const Frame& frame = frames_with_ids(subject).back();
  Evidence evidence;
  evidence.units = "length/time";
  evidence.value = ball_in(frame, last, subject.dimension()).velocity[0];
  evidence.expected =
      law::cradle_speed(static_cast<int>(last), subject.species().restitution, scene.given[0].velocity[0]);
  evidence.budget.systematic =
      16 * std::numeric_limits<double>::epsilon() * static_cast<double>(last) * evidence.expected;
  evidence.budget.reason = "rounding of one collision a ball";
  return evidence;
}

bool is_cradle(const Scene& scene) {
  if (!is_row(scene) || scene.species.size() != 1 || scene.given[0].velocity[0] <= 0) return false;
  return std::all_of(scene.given.begin() + 1, scene.given.end(),
                     [](const GivenParticle& ball) { return ball.velocity[0] == 0; });
}
}  // namespace

std::vector<CheckInfo> row_checks() {
  return {{"three-body-collisions",
           "collisions of three balls in a row against their two collision matrices",
           "three-body-collisions",
           {},
           false,
           {},
           is_three_in_a_row,
           three_body_collisions},
          {"cradle-speed",
           "speed of the last ball of a row that the first one hit",
           "cradle-speed",
           {},
           true,
           {},
           is_cradle,
           last_speed}};
}

}  // namespace sandglass
