#include "sim/scene/method/capabilities.hpp"
#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sandglass {

namespace {
void check_shear_wave(const Scene& scene, Diagnostics& diagnostics) {
  const std::string path = "initial.shear-wave";
  check_bounds(diagnostics, path + ".amplitude", scene.initial.shear_wave->amplitude, finite());
  check_bounds(diagnostics, path + ".periods", scene.initial.shear_wave->periods, between(1, 1000));
  if (!diagnostics.clean(path) || !diagnostics.clean("domain.sides")) return;
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (scene.domain.sides[axis][0] != Side::periodic)
      return diagnostics.report(path, shown(path) + " needs a domain that is periodic along x and y");
}
/// A gas at rest has a floor to rest on, along one axis.
void check_barometric(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.initial.positions != Positions::barometric || !diagnostics.clean("forces")) return;
  const auto acts = [](double component) { return component != 0; };
  const auto down = std::find_if(scene.gravity.begin(), scene.gravity.end(), acts);
  if (std::count_if(scene.gravity.begin(), scene.gravity.end(), acts) != 1)
    return diagnostics.report(
        "initial.positions",
        "positions = \"barometric\" needs gravity along one axis: [forces] gravity = [0, -1]");
  const auto axis = static_cast<std::size_t>(down - scene.gravity.begin());
  if (!diagnostics.clean("domain.sides") || axis >= scene.domain.sides.size()) return;
  if (scene.domain.sides[axis] != std::array{Side::specular, Side::specular})
    diagnostics.report(
        "initial.positions",
        "positions = \"barometric\" needs walls at both ends of the axis of gravity; use \"random\"");
}

/// What counts in collisions knows the rate of a gas with a temperature.
void check_uniform_velocity(const Scene& scene, Diagnostics& diagnostics) {
  const std::string path = "initial.uniform-velocity";
  if (!scene.initial.uniform_velocity) return;
  check_bounds(diagnostics, path, *scene.initial.uniform_velocity, at_least(0));
  if (capabilities(scene).collisions && diagnostics.clean(path))
    diagnostics.report(path, shown(path) + " cannot be used with the method '" + scene.method.preset +
                                 "', whose particles collide: give 'temperature'");
}

/// Lattices know no obstacles, unless particles have a surface to keep off them.
void check_lattice(const Scene& scene, Diagnostics& diagnostics) {
  const bool layered = scene.initial.positions == Positions::layers;
  if (!(layered || scene.initial.positions == Positions::lattice) || scene.obstacles.empty() ||
      capabilities(scene).contacts || !scene.given.empty())
    return;
  diagnostics.report("initial.positions", std::string("positions = \"") + (layered ? "layers" : "lattice") +
                                              "\" would put particles inside the obstacles; use \"random\"");
}
}  // namespace

void check_initial(const Scene& scene, Diagnostics& diagnostics) {
  const Initial& initial = scene.initial;
  check_bounds(diagnostics, "initial.temperature", initial.temperature, positive());
  check_bounds(diagnostics, "initial.spin-temperature", initial.spin_temperature, at_least(0));
  check_bounds(diagnostics, "initial.equilibrate-collisions-per-particle", initial.equilibrate_collisions,
               at_least(0));
  if (!initial.velocity.empty())
    check_vector(diagnostics, "initial.velocity", initial.velocity, scene.domain.dimension, speed());
  if (initial.shear_wave) check_shear_wave(scene, diagnostics);
  check_uniform_velocity(scene, diagnostics);
  check_bounds(diagnostics, "initial.velocity-rounding", initial.velocity_rounding, at_least(0));
  if (!diagnostics.clean("initial.positions")) return;
  check_barometric(scene, diagnostics);
  check_lattice(scene, diagnostics);
}

/// Random insertion jams at an area fraction of 0.547 and a volume fraction of 0.38 (random sequential
/// addition); the bounds stay well below, where it still ends in short time.
void check_overlap(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.initial.positions != Positions::random_without_overlap || scene.species.empty()) return;
  const std::string path = "initial.positions";
  const double highest = scene.domain.dimension == 2 ? 0.5 : 0.3;
  const double value = fraction(scene);
  if (value > highest)
    diagnostics.report(
        path, fmt::format("random insertion without overlap reaches a fraction of {} at most; this scene "
                          "has {:.4g}: use positions = \"lattice\"",
                          highest, value));
  if (scene.method.weight != 1)
    diagnostics.report(
        path,
        "\"random-without-overlap\" needs method.weight = 1: a simulated particle that stands for "
        "many has no size to overlap with");
}

}  // namespace sandglass
