#include "sim/scene/method/capabilities.hpp"
#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"
#include "sim/scene/words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr double most_poured = 1e11;  // as many as a scene may hold
constexpr double most_in_a_step = 1e6;

/// The rules of one source.
class SourceRules {
 public:
  SourceRules(const Scene& scene, std::size_t index, Diagnostics& diagnostics)
      : scene_(scene),
        source_(scene.sources[index]),
        path_(item_path("source", index)),
        diagnostics_(diagnostics) {}

  void check() {
    check_pace();
    check_velocity();
    if (!check_height() || !check_region()) return;
    for (std::size_t i = 0; i < axes_.size(); ++i) check_inside(i);
    if (!source_.height && diagnostics_.clean("obstacle")) check_obstacles();
  }

 private:
  std::string key(const char* name) const { return path_ + '.' + name; }

  void check_pace() {
    if (source_.count && diagnostics_.clean(key("count")))
      check_bounds(diagnostics_, key("count"), static_cast<double>(*source_.count), between(1, most_poured));
    if (!diagnostics_.clean(key("rate")) ||
        !check_bounds(diagnostics_, key("rate"), source_.rate, positive()))
      return;
    const std::optional<double>& step = scene_.method.time_step.fixed;
    if (!step || !diagnostics_.clean("method") || source_.rate * *step <= most_in_a_step) return;
    diagnostics_.report(
        key("rate"), fmt::format("{} pours {} particles in one step of {}; at most {} are allowed: lower the "
                                 "rate or 'method.time-step'",
                                 shown(key("rate")), source_.rate * *step, *step, most_in_a_step));
  }

  void check_velocity() {
    if (!source_.velocity.empty())
      check_vector(diagnostics_, key("velocity"), source_.velocity, scene_.domain.dimension, speed());
  }

  /// That the surface of what it pours keeps from walls and obstacles.
  double margin() const {
    return capabilities(scene_).contacts && diagnostics_.clean("species")
               ? scene_.species.front().diameter / 2
               : 0;
  }

  /// Above a pile: there must be an up and something that piles up.
  bool check_height() {
    if (!source_.height) return true;
    const std::string path = key("height");
    if (!diagnostics_.clean(path) || !diagnostics_.clean("forces")) return false;
    const bool hard = capabilities(scene_).contacts && diagnostics_.clean("species");
    if (!check_bounds(diagnostics_, path, *source_.height,
                      hard ? at_least(largest_diameter(scene_)) : positive()))
      return false;
    const std::optional<std::size_t> down = gravity_axis(scene_);
    if (!down || scene_.domain.sides[*down][0] == Side::periodic) {
      diagnostics_.report(path,
                          shown(path) +
                              " is counted above the pile: it needs gravity along one axis, which is not "
                              "periodic; give 'centre' one coordinate for each axis instead");
      return false;
    }
    if (!diagnostics_.clean(key("velocity")) || !diagnostics_.clean("species")) return true;
    if (pouring_speed(scene_, source_) < 0) {
      diagnostics_.report(
          key("velocity"),
          shown(key("velocity")) +
              " points against gravity; from a 'height' above the pile particles are poured down or at rest");
      return false;
    }
    check_crowding(std::fabs(scene_.gravity[*down]));
    return true;
  }

  /// A particle that has not fallen out of the way counts as the pile, and the source would climb on what it pours.
  void check_crowding(double pull) {
    const double missing = falling_speed(scene_, source_) - pouring_speed(scene_, source_);
    if (!(missing > 0)) return;
    // Particles come at the ends of steps: two may stand nearer to each other by one.
    const double clearing = missing / pull + scene_.method.time_step.fixed.value_or(0);
    if (source_.rate * clearing <= 1 || !diagnostics_.clean(key("rate"))) return;
    diagnostics_.report(key("rate"),
                        fmt::format("{} pours {:.4g} particles while one falls out of the way: its "
                                    "speed must pass that of a fall through a "
                                    "diameter, which takes {:.4g} with a step; lower the rate to {:.4g}, or "
                                    "give a 'velocity' of {:.4g} along gravity",
                                    shown(key("rate")), source_.rate * clearing, clearing, 1 / clearing,
                                    falling_speed(scene_, source_)));
  }

  /// As many components as the region has axes.
  bool check_region() {
    for (std::size_t axis = 0; axis < scene_.domain.size.size(); ++axis)
      if (!source_.height || axis != *gravity_axis(scene_)) axes_.push_back(axis);
    return check_components("centre", source_.centre, finite()) &&
           (source_.width.empty() || check_components("width", source_.width, at_least(0)));
  }

  bool check_components(const char* name, const std::vector<double>& values, const Bounds& bounds) {
    const std::string path = key(name);
    if (!diagnostics_.clean(path)) return false;
    if (values.size() != axes_.size()) {
      diagnostics_.report(path,
                          fmt::format("{} has {} component{}; it needs {}, one for each axis{}", shown(path),
                                      values.size(), values.size() == 1 ? "" : "s", axes_.size(),
                                      source_.height ? " but that of gravity, where 'height' says it" : ""));
      return false;
    }
    bool good = true;
    for (std::size_t i = 0; i < values.size(); ++i)
      good &= check_bounds(diagnostics_, item_path(path, i), values[i], bounds);
    return good;
  }

  double reach(std::size_t i) const { return source_.width.empty() ? 0 : source_.width[i] / 2; }

  /// Until it has poured all; zero where the scene does not say when that is.
  double pouring_time() const {
    double end = duration_of(scene_);
    if (source_.count) end = std::min(end, static_cast<double>(*source_.count) / source_.rate);
    return std::isfinite(end) ? end : 0;
  }

  /// How far a moving wall comes into the box while the source pours.
  double swing(std::size_t axis, bool high) const {
    for (const Wall& wall : scene_.walls) {
      if (wall.axis != static_cast<int>(axis) || wall.high != high) continue;
      const double velocity = axis < wall.velocity.size() ? wall.velocity[axis] : 0;
      return wall.amplitude + std::max(0.0, (high ? -velocity : velocity) * pouring_time());
    }
    return 0;
  }

  void check_inside(std::size_t i) {
    const std::size_t axis = axes_[i];
    const double away = scene_.domain.sides[axis][0] == Side::periodic ? 0 : margin();
    const double low = swing(axis, false) + away, high = scene_.domain.size[axis] - swing(axis, true) - away;
    if (source_.centre[i] - reach(i) >= low && source_.centre[i] + reach(i) <= high) return;
    diagnostics_.report(
        item_path(key("centre"), i),
        fmt::format(
            "the source reaches from {} to {} along {}, out of the domain or into a wall; allowed: {} to {}",
            source_.centre[i] - reach(i), source_.centre[i] + reach(i), axis_words()[axis].first, low, high));
  }

  void check_obstacles() {
    for (const Obstacle& obstacle : scene_.obstacles) {
      double square = 0;
      for (std::size_t axis = 0; axis < std::min(axes_.size(), obstacle.centre.size()); ++axis) {
        const double gap = std::fabs(obstacle.centre[axis] - source_.centre[axis]) - reach(axis);
        square += std::max(0.0, gap) * std::max(0.0, gap);
      }
      const double reach = obstacle.radius + margin();
      if (square >= reach * reach) continue;
      diagnostics_.report(key("centre"), "the source reaches into an obstacle of radius " +
                                             fmt::format("{}", obstacle.radius) +
                                             "; move 'source.centre' or narrow 'source.width'");
      return;
    }
  }

  const Scene& scene_;
  const Source& source_;
  std::string path_;
  Diagnostics& diagnostics_;
  std::vector<std::size_t> axes_;  ///< of the region
};

/// Two sources would take each other's particles for the pile.
void check_heights(const Scene& scene, Diagnostics& diagnostics) {
  const auto above_pile = [](const Source& source) { return source.height.has_value(); };
  const auto first = std::find_if(scene.sources.begin(), scene.sources.end(), above_pile);
  if (first == scene.sources.end()) return;
  const auto second = std::find_if(first + 1, scene.sources.end(), above_pile);
  if (second == scene.sources.end()) return;
  diagnostics.report(
      item_path("source", static_cast<std::size_t>(second - scene.sources.begin())) + ".height",
      "one source may stand above the pile, and this is the second; give its 'centre' one coordinate for "
      "each axis");
}

}  // namespace

void check_sources(const Scene& scene, Diagnostics& diagnostics) {
  check_heights(scene, diagnostics);
  for (std::size_t i = 0; i < scene.sources.size(); ++i) SourceRules(scene, i, diagnostics).check();
}

void check_step_of_empty_box(const Scene& scene, Diagnostics& diagnostics) {
  if (particle_count(scene) > 0 || (scene.sources.empty() && scene.inflows.empty()) ||
      scene.method.time_step.fixed)
    return;
  diagnostics.report(
      "method.time-step",
      fmt::format("'method.time-step' follows from the {} of the particles, and this scene starts without "
                  "one: give it as a time",
                  scene.method.time_step.cell_fraction ? "speeds" : "collisions"));
}

}  // namespace sandglass
