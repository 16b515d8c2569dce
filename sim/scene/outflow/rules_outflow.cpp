#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"
#include "sim/scene/words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
/// The rules of one outflow.
class OutflowRules {
 public:
  OutflowRules(const Scene& scene, std::size_t index, Diagnostics& diagnostics)
      : scene_(scene),
        outflow_(scene.outflows[index]),
        index_(index),
        path_(item_path("outflow", index)),
        diagnostics_(diagnostics) {}

  void check() {
    bool good = check_open_side(scene_, outflow_.axis, outflow_.high, key("side"), "a stream goes out by",
                                diagnostics_);
    good &= check_velocity();
    check_bounds(diagnostics_, key("temperature"), outflow_.temperature, positive());
    if (!good) return;
    check_alone();
    check_direction();
    if (outflow_.filter) check_filter();
  }

 private:
  std::string key(const char* name) const { return path_ + '.' + name; }
  std::string side() const { return word_of(wall_side_words(), std::pair{outflow_.axis, outflow_.high}); }
  void report(const char* name, const std::string& message) {
    if (diagnostics_.clean(key(name))) diagnostics_.report(key(name), message);
  }
  template <class Other>
  bool shares_side(const Other& other) const {
    return other.axis == outflow_.axis && other.high == outflow_.high;
  }

  bool check_velocity() {
    return outflow_.velocity.empty() ||
           check_vector(diagnostics_, key("velocity"), outflow_.velocity, scene_.domain.dimension, speed());
  }

  /// What comes back is counted once.
  void check_alone() {
    for (std::size_t i = 0; i < index_; ++i)
      if (shares_side(scene_.outflows[i]))
        report("side", fmt::format("two tables [[outflow]] name '{}'; keep one", side()));
    if (std::ranges::any_of(scene_.inflows, [&](const Inflow& inflow) { return shares_side(inflow); }))
      report("side", fmt::format("an [[inflow]] comes in by '{}' too, and both would send back what moves "
                                 "against the stream; keep one of them",
                                 side()));
  }

  double outward(std::size_t axis) const { return outflow_.velocity.empty() ? 0 : outflow_.velocity[axis]; }

  void check_direction() {
    const double along = outward(static_cast<std::size_t>(outflow_.axis)) * (outflow_.high ? 1 : -1);
    if (along >= 0) return;
    report("velocity", fmt::format("the stream comes in by '{}' at a speed of {}; an [[outflow]] is for one "
                                   "that leaves: use [[inflow]], or turn 'velocity' round",
                                   side(), -along));
  }

  void check_filter() {
    const auto axis = static_cast<std::size_t>(outflow_.axis);
    const double least = largest_diameter(scene_), most = scene_.domain.size[axis] / 2;
    const double depth = *outflow_.filter;
    if (scene_.domain.dimension != 2)
      return report("filter", "'outflow.filter' is for disks, in 2 dimensions");
    if (!(depth >= least && depth <= most))
      report("filter",
             fmt::format("'outflow.filter' is {}; allowed: from a diameter to half the box, {} to {}", depth,
                         least, most));
    if (scene_.species.size() > 1)
      report("filter", "'outflow.filter' takes one species; leave one, or remove 'filter'");
    if (!scene_.gravity.empty())
      report("filter",
             "heavy particles behind a filter move with the stream and cannot fall: remove "
             "'forces.gravity' or 'filter'");
    for (std::size_t other = 0; other < scene_.domain.size.size(); ++other)
      if (other != axis && outward(other) != 0)
        report("velocity",
               "heavy particles behind a filter move along the axis of the side: give 'velocity' no "
               "other component, or remove 'filter'");
    if (!scene_.sources.empty())
      report("filter", "particles of a [[source]] could appear behind the filter: remove it, or 'filter'");
    for (const Inflow& inflow : scene_.inflows)
      if (inflow.axis != outflow_.axis)
        report("filter",
               fmt::format("particles that come in by '{}' could appear behind the filter; remove that "
                           "[[inflow]], or 'filter'",
                           word_of(wall_side_words(), std::pair{inflow.axis, inflow.high})));
    for (std::size_t i = 0; i < index_; ++i)
      if (scene_.outflows[i].filter) report("filter", "one filter is allowed, and this is the second");
    check_pistons();
    check_obstacles(axis, depth);
  }

  /// Who is heavy leaves no faster than the stream: a faster piston would press the particles into each other.
  void check_pistons() {
    const auto axis = static_cast<std::size_t>(outflow_.axis);
    for (const Inflow& inflow : scene_.inflows) {
      if (inflow.entry != InflowEntry::dispenser || inflow.axis != outflow_.axis || inflow.velocity.empty())
        continue;
      const double pushed = std::fabs(inflow.velocity[axis]), leaves = std::fabs(outward(axis));
      if (leaves < pushed * (1 - 1e-9))
        report("velocity",
               fmt::format("a dispenser pushes the stream in at a speed of {}, and behind the filter it "
                           "leaves at {}: make 'outflow.velocity' as fast",
                           pushed, leaves));
    }
  }

  void check_obstacles(std::size_t axis, double depth) {
    for (const Obstacle& obstacle : scene_.obstacles) {
      const double away =
          outflow_.high ? scene_.domain.size[axis] - obstacle.centre[axis] : obstacle.centre[axis];
      if (away - obstacle.radius < depth + largest_diameter(scene_))
        report("filter",
               fmt::format("an obstacle of radius {} stands {} from '{}', in or at the filter; heavy "
                           "particles do not turn aside: move it or lower 'filter'",
                           obstacle.radius, away - obstacle.radius, side()));
    }
  }

  const Scene& scene_;
  const Outflow& outflow_;
  std::size_t index_;
  std::string path_;
  Diagnostics& diagnostics_;
};
}  // namespace

bool check_open_side(const Scene& scene, int axis, bool high, const std::string& path, const char* stream,
                     Diagnostics& diagnostics) {
  if (!check_side(scene.domain, axis, high, path, diagnostics)) return false;
  const Side side = scene.domain.sides[static_cast<std::size_t>(axis)][high ? 1 : 0];
  if (side == Side::open) return true;
  diagnostics.report(path, fmt::format("{} is '{}', which is {}; {} an open side: [domain.sides] "
                                       "{} = \"open\", or a list with \"open\" for this side",
                                       shown(path), word_of(wall_side_words(), std::pair{axis, high}),
                                       side == Side::periodic ? "periodic" : "a wall", stream,
                                       axis_words()[static_cast<std::size_t>(axis)].first));
  return false;
}

void check_outflows(const Scene& scene, Diagnostics& diagnostics) {
  if (!diagnostics.clean("method")) return;
  for (std::size_t i = 0; i < scene.outflows.size(); ++i) OutflowRules(scene, i, diagnostics).check();
}

}  // namespace sandglass
