#include "sim/scene/method/capabilities.hpp"
#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"
#include "sim/scene/words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr std::size_t most_given = 10000;  // each pair is tried for overlap
/// Particles that touch, like the balls of a cradle, may overlap by rounding: this share of the contact
/// distance.
constexpr double rounding = 1e-9;

bool check_vector(const std::vector<double>& values, const std::string& path, int length,
                  Diagnostics& diagnostics) {
  if (!diagnostics.clean(path)) return false;
  bool good = check_length(diagnostics, path, values.size(), length);
  for (std::size_t axis = 0; axis < values.size(); ++axis)
    good &= check_bounds(diagnostics, item_path(path, axis), values[axis], finite());
  return good;
}

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

void check_contact(const Scene& scene, std::size_t index, const std::string& other,
                   const std::vector<double>& centre, double radius, Diagnostics& diagnostics) {
  const GivenParticle& particle = scene.given[index];
  const bool hard = capabilities(scene).contacts;
  const double least = (hard ? scene.species[particle.species].diameter / 2 : 0) + radius;
  const double apart = distance(scene.domain, particle.position, centre);
  if (apart >= least * (1 - rounding)) return;
  diagnostics.report(
      item_path("particle", index) + ".position",
      fmt::format("particle {} overlaps {} (counted from 1): their centres are {:.6g} apart, at "
                  "least {:.6g} is needed",
                  index + 1, other, apart, least));
}

void check_contacts(const Scene& scene, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < scene.given.size(); ++i) {
    for (std::size_t j = 0; j < i && capabilities(scene).contacts; ++j)
      check_contact(scene, i, fmt::format("particle {}", j + 1), scene.given[j].position,
                    scene.species[scene.given[j].species].diameter / 2, diagnostics);
    for (std::size_t j = 0; j < scene.obstacles.size(); ++j)
      check_contact(scene, i, fmt::format("obstacle {}", j + 1), scene.obstacles[j].centre,
                    scene.obstacles[j].radius, diagnostics);
  }
}

bool check_particle(const Scene& scene, std::size_t index, Diagnostics& diagnostics) {
  const GivenParticle& particle = scene.given[index];
  const std::string path = item_path("particle", index);
  const int dimension = scene.domain.dimension;
  const bool placed = check_vector(particle.position, path + ".position", dimension, diagnostics);
  check_vector(particle.velocity, path + ".velocity", dimension, diagnostics);
  check_spin(scene, particle, path, diagnostics);
  const bool known = particle.species < scene.species.size();
  if (!known && diagnostics.clean("species"))
    diagnostics.report(path + ".species", shown(path + ".species") + " names no species of the scene");
  if (placed && known && diagnostics.clean("species")) check_inside(scene, particle, path, diagnostics);
  return known && diagnostics.clean(path);
}

/// A scene from a text keeps these defaults; one made in code may not.
void check_unused(const Initial& initial, Diagnostics& diagnostics) {
  if (initial != Initial() && diagnostics.clean("initial"))
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
