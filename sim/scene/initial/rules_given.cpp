#include "sim/scene/method/capabilities.hpp"
#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"
#include "sim/scene/words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr std::size_t most_given = 10000;  // a scene file is no place for more
/// Particles that touch, like the balls of a cradle, may overlap by rounding: this share of the contact
/// distance.
constexpr double rounding = 1e-9;

void check_spin(const Scene& scene, const GivenParticle& particle, const std::string& path,
                Diagnostics& diagnostics) {
  if (particle.spin.empty() || !diagnostics.clean(path + ".spin")) return;
  const std::size_t wanted = scene.domain.dimension == 2 ? 1 : 3;
  if (particle.spin.size() != wanted)
    diagnostics.report(
        path + ".spin",
        fmt::format("{} has {} components; the spin of a sphere has 3, that of a disk is a number",
                    shown(path + ".spin"), particle.spin.size()));
  for (std::size_t i = 0; i < particle.spin.size(); ++i)
    check_bounds(diagnostics, particle.spin.size() == 1 ? path + ".spin" : item_path(path + ".spin", i),
                 particle.spin[i], finite());
}

/// Hard particles touch a wall with their surface, the particles of other methods with their centre.
void check_inside(const Scene& scene, const GivenParticle& particle, const std::string& path,
                  Diagnostics& diagnostics) {
  const double radius = scene.species[particle.species].diameter / 2;
  for (std::size_t axis = 0; axis < particle.position.size(); ++axis) {
    const bool walled = scene.domain.sides[axis][0] != Side::periodic;
    const double away = walled && capabilities(scene).contacts ? radius : 0;
    const double value = particle.position[axis], high = scene.domain.size[axis] - away;
    const double slack = rounding * away;
    if (value >= away - slack && (walled ? value <= high + slack : value < high)) continue;
    diagnostics.report(
        item_path(path + ".position", axis),
        fmt::format("{} is {} along {}, {}; allowed: {} to {}", shown(path + ".position"), value,
                    axis_words()[axis].first,
                    away > 0 ? "so that the particle overlaps a wall" : "outside the domain", away, high));
  }
}

double distance(const Domain& domain, const std::vector<double>& a, const std::vector<double>& b) {
  double square = 0;
  for (std::size_t axis = 0; axis < a.size(); ++axis) {
    double step = a[axis] - b[axis];
    if (domain.sides[axis][0] == Side::periodic)
      step -= domain.size[axis] * std::round(step / domain.size[axis]);
    square += step * step;
  }
  return std::sqrt(square);
}

/// A given particle, without a radius where particles have no surface, or an obstacle.
struct Ball {
  const std::vector<double>* centre;
  double radius;
};

/// The given particles, then the obstacles, also in ascending order of x: what touches a ball is near it there.
class Balls {
 public:
  explicit Balls(const Scene& scene) : domain_(scene.domain) {
    const bool hard = capabilities(scene).contacts;
    for (const GivenParticle& particle : scene.given)
      all_.push_back({&particle.position, hard ? scene.species[particle.species].diameter / 2 : 0});
    for (const Obstacle& obstacle : scene.obstacles) all_.push_back({&obstacle.centre, obstacle.radius});
    for (std::size_t i = 0; i < all_.size(); ++i) {
      by_x_.emplace_back(x(i), i);
      largest_ = std::max(largest_, all_[i].radius);
    }
    std::ranges::sort(by_x_);
  }

  const Ball& operator[](std::size_t index) const { return all_[index]; }

  /// In ascending order, each once: those that are no farther along x than the ball and the largest can touch.
  std::vector<std::size_t> near(std::size_t index) const {
    const double edge = domain_.sides[0][0] == Side::periodic ? domain_.size[0] : HUGE_VAL;
    const double reach = all_[index].radius + largest_, here = x(index);
    std::vector<std::size_t> found;
    for (const double centre : {here - edge, here, here + edge}) {
      const auto first = std::ranges::lower_bound(by_x_, std::pair(centre - reach, std::size_t{0}));
      for (auto ball = first; ball != by_x_.end() && ball->first <= centre + reach; ++ball)
        found.push_back(ball->second);
    }
    std::ranges::sort(found);
    found.erase(std::ranges::unique(found).begin(), found.end());
    return found;
  }

 private:
  double x(std::size_t index) const { return all_[index].centre->front(); }

  const Domain& domain_;
  std::vector<Ball> all_;
  std::vector<std::pair<double, std::size_t>> by_x_;
  double largest_ = 0;
};

void check_contact(const Scene& scene, const Balls& balls, std::size_t index, std::size_t other,
                   Diagnostics& diagnostics) {
  const double least = balls[index].radius + balls[other].radius;
  const double apart = distance(scene.domain, *balls[index].centre, *balls[other].centre);
  if (apart >= least * (1 - rounding)) return;
  const std::size_t particles = scene.given.size();
  const bool obstacle = other >= particles;
  diagnostics.report(
      item_path("particle", index) + ".position",
      fmt::format("particle {} overlaps {} {} (counted from 1): their centres are {:.6g} apart, at "
                  "least {:.6g} is needed",
                  index + 1, obstacle ? "obstacle" : "particle", (obstacle ? other - particles : other) + 1,
                  apart, least));
}

void check_contacts(const Scene& scene, Diagnostics& diagnostics) {
  const Balls balls(scene);
  for (std::size_t i = 0; i < scene.given.size(); ++i)
    for (const std::size_t j : balls.near(i))
      if (j < i || j >= scene.given.size()) check_contact(scene, balls, i, j, diagnostics);
}

bool check_particle(const Scene& scene, std::size_t index, Diagnostics& diagnostics) {
  const GivenParticle& particle = scene.given[index];
  const std::string path = item_path("particle", index);
  const int dimension = scene.domain.dimension;
  const bool placed = check_vector(diagnostics, path + ".position", particle.position, dimension, finite());
  check_vector(diagnostics, path + ".velocity", particle.velocity, dimension, finite());
  check_spin(scene, particle, path, diagnostics);
  const bool known = particle.species < scene.species.size();
  if (!known && diagnostics.clean("species"))
    diagnostics.report(path + ".species", shown(path + ".species") + " names no species of the scene");
  if (placed && known && diagnostics.clean("species")) check_inside(scene, particle, path, diagnostics);
  return known && diagnostics.clean(path);
}

/// A scene from a text keeps these defaults; one made in code may not.
void check_unused(const Initial& initial, Diagnostics& diagnostics) {
  Initial plain;
  plain.velocity_rounding = initial.velocity_rounding;
  if (initial != plain && diagnostics.clean("initial"))
    diagnostics.report("initial",
                       "'initial' says how to draw particles that are given one by one; leave it as "
                       "it is by default");
}
}  // namespace

void check_given(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.given.empty()) return;
  check_unused(scene.initial, diagnostics);
  if (scene.given.size() > most_given)
    return diagnostics.report("particle", fmt::format("{} particles are given; at most {} are allowed",
                                                      scene.given.size(), most_given));
  bool good = diagnostics.clean("species") && diagnostics.clean("obstacle");
  for (std::size_t i = 0; i < scene.given.size(); ++i) good &= check_particle(scene, i, diagnostics);
  if (good) check_contacts(scene, diagnostics);
}

}  // namespace sandglass
