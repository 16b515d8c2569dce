#include "validation/law/few_body.hpp"

#include "sim/base/error.hpp"
#include "validation/check/families.hpp"
#include "validation/check/few_body_frames.hpp"
#include "validation/check/inertia.hpp"
#include "validation/check/worst.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass {

namespace {
constexpr double epsilon = std::numeric_limits<double>::epsilon();

std::vector<law::Ball> balls_of(const Scene& scene) {
  std::vector<law::Ball> balls;
  for (const GivenParticle& particle : scene.given) {
    const Species& species = scene.species.at(particle.species);
    const double radius = species.diameter / 2;
    law::Ball ball{species.mass,
                   radius,
                   inertia_of(species, scene.domain.dimension) * species.mass * radius * radius,
                   in_space(particle.position),
                   in_space(particle.velocity),
                   spin_in_space(particle.spin)};
    balls.push_back(ball);
  }
  return balls;
}

law::TouchOf touch_of(const Scene& scene) {
  return [&scene](std::size_t i, std::size_t j) {
    const Species& a = scene.species.at(scene.given[i].species);
    const Species& b = scene.species.at(scene.given[j].species);
    law::Touch touch{(a.restitution + b.restitution) / 2,
                     (a.tangential_restitution + b.tangential_restitution) / 2};
    if (a.friction && b.friction) touch.friction = (*a.friction + *b.friction) / 2;
    return touch;
  };
}

/// Units of deviations.
struct Scales {
  double length = 0, speed = 0, spin = 0, diameter = HUGE_VAL;
};

Scales scales_of(const Scene& scene) {
  Scales scales;
  scales.length = *std::max_element(scene.domain.size.begin(), scene.domain.size.end());
  for (const law::Ball& ball : balls_of(scene)) {
    scales.speed = std::max(scales.speed, ball.velocity.norm() + ball.radius * ball.spin.norm());
    scales.diameter = std::min(scales.diameter, 2 * ball.radius);
  }
  scales.spin = 2 * scales.speed / scales.diameter;
  return scales;
}

/// The law knows no images: the balls must stay closer together than the box less a diameter.
void require_room(const Scene& scene, const std::vector<law::Ball>& balls) {
  for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis)
    for (const law::Ball& a : balls)
      for (const law::Ball& b : balls)
        if (std::abs(a.position[static_cast<int>(axis)] - b.position[static_cast<int>(axis)]) >
            scene.domain.size[axis] - a.radius - b.radius)
          throw InputError("the balls come near their own images: enlarge 'domain.size' or end earlier");
}

double deviation(const Scene& scene, const Frame& frame, const std::vector<law::Ball>& expected,
                 const Scales& scales) {
  double worst = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const BallPhase seen = ball_in(frame, i, scene.domain.dimension);
    Vector<3> apart = seen.position - expected[i].position;
    for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis) {
      double& component = apart[static_cast<int>(axis)];
      component -= scene.domain.size[axis] * std::round(component / scene.domain.size[axis]);
    }
    const double parts[] = {apart.norm() / scales.length,
                            (seen.velocity - expected[i].velocity).norm() / scales.speed,
                            seen.spin ? (*seen.spin - expected[i].spin).norm() / scales.spin : 0};
    for (const double part : parts) keep_worst(worst, part);
  }
  return worst;
}

/// Each collision rounds a place to epsilon times the box, which is that over a diameter in the direction of the normal;
/// what it makes wrong grows as the law says, and with the flight afterwards.
double rounding_bound(const Scales& scales, const law::FewBodyResult& result, double duration) {
  return 16 * epsilon * (1 + static_cast<double>(result.collisions)) * result.amplification * scales.length /
         scales.diameter * (1 + scales.speed * duration / scales.length);
}

Figure paths(const Subject& subject, const std::vector<std::vector<law::Ball>>& expected) {
  Figure figure{"Paths along x", {"time", "time", false}, {"position", "length", false}, {}, {}};
  for (std::size_t i = 0; i < subject.scene().given.size(); ++i) {
    Figure::Points points{"ball " + std::to_string(i + 1), {}, {}, {}, {}};
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const Frame& frame = subject.record().trajectory[k];
      points.x.push_back(frame.time);
      points.y.push_back(ball_in(frame, i, subject.dimension()).position[0]);
      points.error.push_back(0);
      points.expected.push_back(expected[k][i].position[0]);
    }
    figure.points.push_back(std::move(points));
  }
  return figure;
}

Evidence few_body_state(const Subject& subject, const law::Arguments&) {
  const Scene& scene = subject.scene();
  const Scales scales = scales_of(scene);
  Evidence evidence;
  std::vector<std::vector<law::Ball>> all;
  for (const Frame& frame : frames_with_ids(subject)) {
    const law::FewBodyResult result = law::few_body(balls_of(scene), touch_of(scene), frame.time);
    require_room(scene, result.balls);
    keep_worst(evidence.value, deviation(scene, frame, result.balls, scales));
    evidence.budget.systematic = rounding_bound(scales, result, frame.time);
    all.push_back(result.balls);
  }
  evidence.budget.reason = "rounding, grown by the defocusing of each collision";
  evidence.figures.push_back(paths(subject, all));
  return evidence;
}

}  // namespace

bool is_few_bodies(const Scene& scene) {
  const auto periodic = [](const std::array<Side, 2>& sides) { return sides[0] == Side::periodic; };
  const auto none = [](double component) { return component == 0; };
  return touches(scene) && !scene.given.empty() && scene.given.size() <= 20 &&
         guard_of(scene.method).kind == CollapseGuard::none && scene.obstacles.empty() &&
         std::ranges::all_of(scene.domain.sides, periodic) && std::ranges::all_of(scene.gravity, none);
}

std::vector<CheckInfo> few_body_checks() {
  return {
      {"few-body-state",
       "largest deviation of places, velocities and spins from collision after collision, in units of box "
       "and speed",
       "",
       {},
       false,
       {},
       is_few_bodies,
       few_body_state}};
}

}  // namespace sandglass
