#include "sim/base/packing.hpp"
#include "sim/scene/method/family.hpp"
#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"
#include "sim/scene/words.hpp"

#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr double most_in_a_step = 1e6;

std::string side_of(const Inflow& inflow) {
  return word_of(wall_side_words(), std::pair{inflow.axis, inflow.high});
}

/// The rules of one inflow.
class InflowRules {
 public:
  InflowRules(const Scene& scene, std::size_t index, Diagnostics& diagnostics)
      : scene_(scene),
        inflow_(scene.inflows[index]),
        path_(item_path("inflow", index)),
        diagnostics_(diagnostics) {}

  void check() {
    bool good = check_side();
    good &= check_velocity();
    good &= check_bounds(diagnostics_, key("number-density"), inflow_.number_density, positive());
    good &= check_bounds(diagnostics_, key("temperature"), inflow_.temperature, at_least(0));
    check_bounds(diagnostics_, key("spin-temperature"), inflow_.spin_temperature, at_least(0));
    if (!good) return;
    check_packing();
    check_rate();
    if (inflow_.entry == InflowEntry::dispenser) check_dispenser();
  }

 private:
  std::string key(const char* name) const { return path_ + '.' + name; }

  bool check_side() {
    return check_open_side(scene_, inflow_.axis, inflow_.high, key("side"), "a stream comes in by",
                           diagnostics_) &&
           check_walls_beside();
  }

  /// Particles enter anywhere on the side: no wall may slide over it.
  bool check_walls_beside() {
    for (const Wall& wall : scene_.walls) {
      const auto axis = static_cast<std::size_t>(wall.axis);
      const bool moves = wall.amplitude != 0 || (axis < wall.velocity.size() && wall.velocity[axis] != 0);
      if (!moves || wall.axis == inflow_.axis) continue;
      diagnostics_.report(key("side"),
                          fmt::format("the wall '{}' moves over the side where the stream comes in; let it "
                                      "stand, or move it along itself",
                                      word_of(wall_side_words(), std::pair{wall.axis, wall.high})));
      return false;
    }
    return true;
  }

  bool check_velocity() {
    return inflow_.velocity.empty() ||
           check_vector(diagnostics_, key("velocity"), inflow_.velocity, scene_.domain.dimension, speed());
  }

  /// All that streams in by the same side.
  void check_packing() {
    double fraction = 0;
    for (const Inflow& other : scene_.inflows)
      if (other.axis == inflow_.axis && other.high == inflow_.high)
        fraction +=
            other.number_density * particle_volume(scene_.species[other.species], scene_.domain.dimension);
    const int dimension = scene_.domain.dimension;
    const bool local = has_contact_factor(scene_) && !has_full_cells(scene_);
    const double most = local ? random_close_packing(dimension) : close_packing(dimension);
    if (fraction < most) return;
    diagnostics_.report(key("number-density"),
                        fmt::format("what comes in by '{}' has the {} {:.4g}, at or above {}close packing "
                                    "({}); lower {}",
                                    side_of(inflow_), fraction_key(dimension), fraction,
                                    local ? "random " : "", most, shown(key("number-density"))));
  }

  void check_rate() {
    const double rate = inflow_rate(scene_, inflow_);
    const bool rests = inflow_.entry == InflowEntry::dispenser;  // a piston may stand still
    if (!(rate > 0) && !rests)
      return diagnostics_.report(
          key("velocity"),
          fmt::format("nothing comes in by '{}': at temperature {} no particle moves against this stream; "
                      "point 'velocity' into the box or raise 'temperature'",
                      side_of(inflow_), inflow_.temperature));
    const double step = scene_.method.time_step.fixed.value_or(0);
    if (rate * step <= most_in_a_step && std::isfinite(rate)) return;
    diagnostics_.report(key("number-density"),
                        fmt::format("{:.4g} particles come in by '{}' in one step; at most {} are allowed: "
                                    "shorten 'method.time-step' or raise 'method.weight'",
                                    rate * step, side_of(inflow_), most_in_a_step));
  }

  void report(const char* name, const std::string& message) {
    if (diagnostics_.clean(key(name))) diagnostics_.report(key(name), message);
  }

  /// A piston sweeps the whole side, and a layer of particles that do not overlap fits behind it.
  void check_dispenser() {
    if (!capabilities(scene_).contacts)
      return report("entry", "a dispenser makes room for particles with a surface: use the method " +
                                 presets_that([](const Capabilities& can) { return can.contacts; }) +
                                 ", or entry = \"flux\"");
    if (scene_.domain.dimension != 2)
      return report("entry", "a dispenser lays rows of disks, in 2 dimensions: use entry = \"flux\"");
    for (const Inflow& other : scene_.inflows)
      if (&other != &inflow_ && other.axis == inflow_.axis && other.high == inflow_.high)
        return report("side",
                      fmt::format("the piston of a dispenser closes '{}', and another [[inflow]] comes in "
                                  "there; keep one of them",
                                  side_of(inflow_)));
    if (!scene_.sources.empty())
      return report("entry",
                    "particles of a [[source]] could appear behind the piston of a dispenser: remove it, or "
                    "use entry = \"flux\"");
    for (const Inflow& other : scene_.inflows)
      if (other.axis != inflow_.axis)
        return report("side",
                      fmt::format("particles that come in by '{}' could be caught behind the piston at '{}'; "
                                  "keep one of the two, or use entry = \"flux\"",
                                  side_of(other), side_of(inflow_)));
    const auto axis = static_cast<std::size_t>(inflow_.axis);
    const double along = inflow_.velocity.empty() ? 0 : (inflow_.high ? -1 : 1) * inflow_.velocity[axis];
    if (along < 0)
      return report("velocity", "a piston moves into the box or stands still: turn 'velocity' round");
    check_layer(scene_.domain.size[axis], volume(scene_.domain) / scene_.domain.size[axis]);
  }

  void check_layer(double length, double side) {
    const double diameter = scene_.species[inflow_.species].diameter, count = layer_count(scene_, inflow_);
    if (count * diameter > side * (1 + 1e-12))
      return report(
          "number-density",
          fmt::format("a layer of {} particles of diameter {} does not fit a side of {}: lower "
                      "'inflow.number-density' to {:.4g}, a fraction of {:.4g}, or use a wider side",
                      count, diameter, side, std::floor(side / diameter) / (diameter * side),
                      std::floor(side / diameter) / (diameter * side) *
                          particle_volume(scene_.species[inflow_.species], 2)));
    const double stroke = count / (inflow_.number_density * side), reach = stroke + largest_diameter(scene_);
    if (length < 2 * reach)
      report("number-density",
             fmt::format("the piston moves {:.4g} into a box of {}, which has no room left for the "
                         "stream: raise 'inflow.number-density' or lengthen the box",
                         stroke, length));
    const auto axis = static_cast<std::size_t>(inflow_.axis);
    for (const Obstacle& obstacle : scene_.obstacles) {
      const double away = inflow_.high ? length - obstacle.centre[axis] : obstacle.centre[axis];
      if (away - obstacle.radius < reach)
        report(
            "side",
            fmt::format("an obstacle stands {:.4g} from '{}', and the piston with a particle in front of it "
                        "moves {:.4g} into the box; move the obstacle",
                        away - obstacle.radius, side_of(inflow_), reach));
    }
  }

  const Scene& scene_;
  const Inflow& inflow_;
  std::string path_;
  Diagnostics& diagnostics_;
};
}  // namespace

void check_inflows(const Scene& scene, Diagnostics& diagnostics) {
  if (!diagnostics.clean("method")) return;
  for (std::size_t i = 0; i < scene.inflows.size(); ++i) InflowRules(scene, i, diagnostics).check();
}

}  // namespace sandglass
