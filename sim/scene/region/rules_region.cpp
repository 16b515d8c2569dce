#include "sim/scene/method/capabilities.hpp"
#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"
#include "sim/scene/words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr double most_particles = 1e11;  // as many as a scene may hold
constexpr double largest_ratio = 1e6;    // of a weight to that of the method
/// In cells: what decimal numbers of borders and edges leave.
constexpr double rounding = 1e-6;

bool overlap(const std::vector<double>& low, const std::vector<double>& high, const Region& region) {
  for (std::size_t axis = 0; axis < low.size(); ++axis)
    if (!(low[axis] < region.high[axis] && region.low[axis] < high[axis])) return false;
  return true;
}

/// The rules of one region.
class RegionRules {
 public:
  RegionRules(const Scene& scene, std::size_t index, const std::vector<double>& cells,
              Diagnostics& diagnostics)
      : scene_(scene),
        region_(scene.regions[index]),
        index_(index),
        cells_(cells),
        path_(item_path("region", index)),
        diagnostics_(diagnostics) {}

  bool check() {
    check_weight();
    const int dimension = scene_.domain.dimension;
    const bool low = check_vector(diagnostics_, key("low"), region_.low, dimension, finite());
    const bool high = check_vector(diagnostics_, key("high"), region_.high, dimension, finite());
    if (!low || !high) return false;
    bool good = true;
    for (std::size_t axis = 0; axis < region_.low.size(); ++axis) good &= check_axis(axis);
    return good && check_others();
  }

 private:
  std::string key(const char* name) const { return path_ + '.' + name; }

  void check_weight() {
    const double plain = scene_.method.weight;
    if (!diagnostics_.clean(key("weight")) ||
        !check_bounds(diagnostics_, key("weight"), region_.weight, moderate()))
      return;
    if (region_.weight <= plain * largest_ratio && region_.weight >= plain / largest_ratio) return;
    diagnostics_.report(key("weight"),
                        fmt::format("{} is {}; allowed: a millionth of 'method.weight', {}, to a million "
                                    "times as much",
                                    shown(key("weight")), region_.weight, plain));
  }

  bool check_axis(std::size_t axis) {
    const double size = scene_.domain.size[axis], low = region_.low[axis], high = region_.high[axis];
    const std::string& name = axis_words()[axis].first;
    if (!(low < high) || low < 0 || high > size) {
      diagnostics_.report(key("high"), fmt::format("the region reaches from {} to {} along {}; allowed: from "
                                                   "a lower to a higher place within 0 to {}",
                                                   low, high, name, size));
      return false;
    }
    return cells_.empty() || (check_border(axis, low, "low") && check_border(axis, high, "high"));
  }

  /// Every cell belongs to one region.
  bool check_border(std::size_t axis, double border, const char* name) {
    const double edge = scene_.domain.size[axis] / cells_[axis], place = border / edge;
    if (std::abs(place - std::round(place)) <= rounding) return true;
    diagnostics_.report(
        item_path(key(name), axis),
        fmt::format("{} cuts cells of {:.6g} along {} at {:.6g}; put it on an edge, {:.6g} or {:.6g}, or "
                    "choose 'method.cells' with an edge there",
                    shown(key(name)), edge, axis_words()[axis].first, border, edge * std::floor(place),
                    edge * std::ceil(place)));
    return false;
  }

  bool check_others() {
    for (std::size_t other = 0; other < index_; ++other) {
      const Region& before = scene_.regions[other];
      if (before.low.size() != region_.low.size() || before.high.size() != region_.high.size()) continue;
      if (!overlap(region_.low, region_.high, before)) continue;
      diagnostics_.report(path_, fmt::format("this [[region]] overlaps the one before it of weight {}: a "
                                             "particle has one weight; move one of them",
                                             before.weight));
      return false;
    }
    return true;
  }

  const Scene& scene_;
  const Region& region_;
  std::size_t index_;
  const std::vector<double>& cells_;
  std::string path_;
  Diagnostics& diagnostics_;
};

/// A source pours particles of one weight.
void check_source(const Scene& scene, std::size_t index, Diagnostics& diagnostics) {
  const Source& source = scene.sources[index];
  const std::string path = item_path("source", index);
  if (source.height)
    return diagnostics.report(path + ".height",
                              "'source.height' cannot be used with a [[region]]: the source would rise from "
                              "one into the next; give 'centre' one coordinate for each axis");
  std::vector<double> low = source.centre, high = source.centre;
  for (std::size_t axis = 0; axis < source.width.size(); ++axis) {
    low[axis] -= source.width[axis] / 2;
    high[axis] += source.width[axis] / 2;
  }
  for (const Region& region : scene.regions) {
    bool inside = true, apart = false;
    for (std::size_t axis = 0; axis < low.size(); ++axis) {
      inside &= region.low[axis] <= low[axis] && high[axis] <= region.high[axis];
      apart |= high[axis] < region.low[axis] || region.high[axis] < low[axis];
    }
    if (inside) return;
    if (apart) continue;
    return diagnostics.report(path + ".centre",
                              "the source reaches over the border of a [[region]], and a particle has the "
                              "weight of its region; move 'source.centre' or narrow 'source.width'");
  }
}

void check_observers_of_regions(const Scene& scene, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < scene.observe.size(); ++i) {
    const std::string path = item_path("observe", i) + ".what";
    for (const char* name : {"crossings", "pair-correlation", "pair-velocity", "wall-force"})
      if (scene.observe[i].what == name && diagnostics.clean(path))
        diagnostics.report(path, fmt::format("the observer '{}' counts simulated particles, which with a "
                                             "[[region]] stand for different numbers of real ones; remove it",
                                             name));
  }
}

void check_start(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.initial.equilibrate_collisions != 0)
    diagnostics.report("initial.equilibrate-collisions-per-particle",
                       "'initial.equilibrate-collisions-per-particle' counts collisions of particles alike, "
                       "and with a [[region]] each stands for another number of real ones; remove it");
  if (scene.initial.positions == Positions::random_without_overlap && scene.given.empty())
    diagnostics.report("initial.positions",
                       "positions = \"random-without-overlap\" cannot be used with a [[region]]: a simulated "
                       "particle that stands for many has no size to overlap with; use \"random\"");
}

void check_number(const Scene& scene, Diagnostics& diagnostics) {
  const double lightest = lightest_weight(scene);
  const double most = static_cast<double>(particle_count(scene)) * (scene.method.weight / lightest);
  if (most <= most_particles) return;
  const auto at = std::ranges::find(scene.regions, lightest, &Region::weight) - scene.regions.begin();
  const std::string path = item_path("region", static_cast<std::size_t>(at)) + ".weight";
  diagnostics.report(path, fmt::format("{} is {}: if all particles went there they would be {:.3g} simulated "
                                       "ones; at most {:.3g} are allowed: raise it",
                                       shown(path), lightest, most, most_particles));
}
}  // namespace

void check_regions(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.regions.empty() || !diagnostics.clean("region") || !capabilities(scene).regions) return;
  const std::vector<double> cells = cells_along(scene);
  if (cells.empty())
    diagnostics.report("region",
                       "a [[region]] is made of whole cells; give 'method.cells' or 'method.cell-size'");
  bool good = true;
  for (std::size_t i = 0; i < scene.regions.size(); ++i)
    good &= RegionRules(scene, i, cells, diagnostics).check();
  check_observers_of_regions(scene, diagnostics);
  check_start(scene, diagnostics);
  if (!good) return;
  for (std::size_t i = 0; i < scene.sources.size(); ++i) check_source(scene, i, diagnostics);
  if (diagnostics.clean("region")) check_number(scene, diagnostics);
}

}  // namespace sandglass
