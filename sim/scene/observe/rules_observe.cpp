#include "sim/base/spelling.hpp"
#include "sim/scene/method/family.hpp"
#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"
#include "sim/scene/words.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr std::size_t most_observers = 1000;  // far more than there are kinds and axes
constexpr double most_bins = 1e6;
constexpr double most_field_bins = 1e8;

bool check_axis(const Observe& observe, int dimension, const std::string& path, Diagnostics& diagnostics) {
  if (observe.axis >= 0 && observe.axis < dimension) return true;
  diagnostics.report(path + ".axis",
                     fmt::format("{} must be {}", shown(path + ".axis"),
                                 dimension == 2 ? "'x' or 'y' in 2 dimensions" : "'x', 'y' or 'z'"));
  return false;
}

/// Walls turn particles back within a step, and the seam of a periodic domain would be crossed twice.
void check_plane(const Observe& observe, const Domain& domain, const std::string& path,
                 Diagnostics& diagnostics) {
  const auto axis = static_cast<std::size_t>(observe.axis);
  if (diagnostics.clean("domain.sides") && domain.sides[axis][0] != Side::periodic)
    diagnostics.report(path + ".axis", "the observer 'crossings' needs a plane normal to a periodic axis; " +
                                           axis_words()[axis].first + " has walls");
  if (!diagnostics.clean(path + ".position")) return;
  const double edge = domain.size[axis];
  if (observe.position > 0 && observe.position < edge) return;
  diagnostics.report(path + ".position",
                     fmt::format("{} is {}, outside the domain; allowed: above 0 and below {}",
                                 shown(path + ".position"), observe.position, edge));
}

void check_bins(const Observe& observe, const std::string& path, Diagnostics& diagnostics) {
  check_bounds(diagnostics, path + ".bins", static_cast<double>(observe.bins), between(1, most_bins));
  if (!observe.range) return;
  const auto [low, high] = *observe.range;
  const bool both = check_bounds(diagnostics, path + ".range", low, finite()) &&
                    check_bounds(diagnostics, path + ".range", high, finite());
  if (both && !(low < high))
    diagnostics.report(path + ".range",
                       fmt::format("{} goes from {} to {}; the first must be below the second",
                                   shown(path + ".range"), low, high));
}

void check_grid(const Observe& observe, int dimension, const std::string& path, Diagnostics& diagnostics) {
  if (!diagnostics.clean(path + ".grid")) return;
  check_length(diagnostics, path + ".grid", observe.grid.size(), dimension);
  double total = 1;
  for (std::size_t axis = 0; axis < observe.grid.size(); ++axis) {
    const double bins = static_cast<double>(observe.grid[axis]);
    check_bounds(diagnostics, item_path(path + ".grid", axis), bins, between(1, most_bins));
    total *= bins;
  }
  if (total > most_field_bins && diagnostics.clean(path + ".grid"))
    diagnostics.report(path + ".grid", fmt::format("{} has {} bins; at most {} are allowed",
                                                   shown(path + ".grid"), total, most_field_bins));
}

/// Distances are those of nearest images: beyond half an edge some pairs would be missed.
void check_distances(const Observe& observe, const Domain& domain, const std::string& path,
                     Diagnostics& diagnostics) {
  if (!observe.range || !diagnostics.clean(path + ".range")) return;
  const auto [low, high] = *observe.range;
  const double most = *std::min_element(domain.size.begin(), domain.size.end()) / 2;
  if (low >= 0 && high <= most) return;
  diagnostics.report(path + ".range",
                     fmt::format("{} goes from {} to {}; distances are allowed from 0 to half the shortest "
                                 "edge, {}",
                                 shown(path + ".range"), low, high, most));
}

/// The height is a coordinate, and a periodic axis has no lowest point.
void check_free_surface(const Observe& observe, const Domain& domain, const std::string& path,
                        Diagnostics& diagnostics) {
  const auto axis = static_cast<std::size_t>(observe.axis);
  const std::string name = axis_words()[axis].first;
  if (diagnostics.clean("domain.sides") && domain.sides[axis][0] == Side::periodic)
    diagnostics.report(path + ".axis",
                       fmt::format("the observer 'free-surface' needs the height along an axis that is not "
                                   "periodic, and {} is; give 'axis', against gravity",
                                   name));
  if (!diagnostics.clean(path + ".grid") || observe.grid[axis] == 1) return;
  diagnostics.report(path + ".grid",
                     fmt::format("{} has {} bins along {}, the axis of the height; give 1 there",
                                 shown(path + ".grid"), observe.grid[axis], name));
}

/// What the observer needs of the rest of the scene.
void check_setting(const ObserverKind& kind, const Scene& scene, const std::string& path,
                   Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& need) {
    diagnostics.report(path + ".what", fmt::format("the observer '{}' needs {}", kind.name, need));
  };
  if (diagnostics.clean("method.preset")) {
    const auto contacts = [](const Capabilities& can) { return can.contacts; };
    const auto particles = [](const Capabilities& can) { return can.particles; };
    if (kind.needs == ObserverSetting::contacts && !contacts(capabilities(scene)))
      refuse("particles that touch: the method " + presets_that(contacts));
    else if (kind.needs != ObserverSetting::plane && !particles(capabilities(scene)))
      refuse("particles in a box: the method " + presets_that(particles));
  }
  if (kind.needs == ObserverSetting::spins && diagnostics.clean("species") && diagnostics.clean("wall") &&
      diagnostics.clean("obstacle") && !is_rough(scene))
    refuse("rough contacts: give 'tangential-restitution' above -1 to a species, wall or obstacle");
  if (kind.needs == ObserverSetting::mixture && diagnostics.clean("species") && scene.species.size() < 2)
    refuse("several species: give a second table [[species]]");
  if (kind.needs == ObserverSetting::regions && diagnostics.clean("region") && scene.regions.empty())
    refuse("regions of other weights: give a table [[region]]");
  const auto walled = [](const auto& sides) { return sides[0] != Side::periodic; };
  if (!diagnostics.clean("domain.sides")) return;
  const bool bounded = std::any_of(scene.domain.sides.begin(), scene.domain.sides.end(), walled);
  if (kind.needs == ObserverSetting::periodic && bounded)
    refuse("a domain that is periodic along every axis");
  if (kind.needs == ObserverSetting::bounded && !bounded)
    refuse("an axis that is not periodic; see [domain.sides]");
}

void check_shear_mode(const Domain& domain, const std::string& path, Diagnostics& diagnostics) {
  if (!diagnostics.clean("domain.sides")) return;
  if (domain.sides[0][0] == Side::periodic && domain.sides[1][0] == Side::periodic) return;
  diagnostics.report(path + ".what",
                     "the observer 'shear-mode' needs a domain that is periodic along x and y");
}

void check_observer(const Observe& observe, const Scene& scene, const std::string& path,
                    Diagnostics& diagnostics) {
  const Domain& domain = scene.domain;
  const ObserverKind* kind = find_observer(observe.what);
  if (!kind)
    return diagnostics.report(path + ".what", unknown_word("observer", observe.what, observer_names()));
  const auto uses = [&observe](const char* key) { return observer_uses(observe.what, key); };
  const bool axis_known = !uses("axis") || check_axis(observe, domain.dimension, path, diagnostics);
  if (uses("position") && axis_known) check_plane(observe, domain, path, diagnostics);
  if (uses("bins")) check_bins(observe, path, diagnostics);
  if (uses("grid")) check_grid(observe, domain.dimension, path, diagnostics);
  if (observe.what == "free-surface" && axis_known) check_free_surface(observe, domain, path, diagnostics);
  if (observes_distances(observe.what)) check_distances(observe, domain, path, diagnostics);
  check_setting(*kind, scene, path, diagnostics);
  if (observe.what == "shear-mode") check_shear_mode(domain, path, diagnostics);
}

/// Samples are named after their observer, a velocity histogram after its axis as well.
bool same_name(const Observe& a, const Observe& b) {
  return a.what == b.what && (a.what != "velocity-histogram" || a.axis == b.axis);
}
}  // namespace

void check_observers(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.observe.size() > most_observers)
    return diagnostics.report("observe", fmt::format("{} observers are given; at most {} are allowed",
                                                     scene.observe.size(), most_observers));
  for (std::size_t i = 0; i < scene.observe.size(); ++i) {
    const std::string path = item_path("observe", i);
    if (!diagnostics.clean(path + ".what")) continue;
    check_observer(scene.observe[i], scene, path, diagnostics);
    for (std::size_t j = 0; j < i; ++j)
      if (same_name(scene.observe[i], scene.observe[j])) {
        diagnostics.report(
            path, fmt::format("the observer '{}' is given twice; keep one: samples are named after it",
                              scene.observe[i].what));
        break;
      }
  }
}

}  // namespace sandglass
