#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"

#include <algorithm>
#include <cmath>

// A gas at rest in a periodic box has no preferred direction, and cells that collide as a whole no preferred colour: what
// the order of work leaves behind would show here.

namespace sandglass {

namespace {
bool is_at_rest(const Scene& scene) {
  return is_uniform(scene) && !scene.initial.shear_wave &&
         std::ranges::all_of(scene.initial.velocity, [](double component) { return component == 0; });
}

/// A plane in which a mirror leaves the cells where they are: at the edge of a cell or in its middle.
bool has_plane_of_mirror(const Scene& scene) {
  const std::vector<double> cells = cells_along(scene);
  return std::ranges::any_of(scene.observe, [&](const Observe& observe) {
    if (observe.what != "crossings") return false;
    const auto axis = static_cast<std::size_t>(observe.axis);
    const double place = cells.empty() ? 0 : 2 * cells[axis] * observe.position / scene.domain.size[axis];
    return std::abs(place - std::round(place)) < 1e-6;
  });
}

Evidence passage_balance(const Subject& subject, const law::Arguments&) {
  std::vector<double> shares;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const auto passed = [&](const std::string& way) {
      const std::vector<double> count = subject.column(replica, "crossing-count", way);
      return count.back() - count.front();
    };
    const double up = passed("up"), down = passed("down");
    if (up + down == 0)
      throw InputError("nobody has passed the plane of 'crossings': run longer, or move it");
    shares.push_back((up - down) / (up + down));
  }
  Evidence evidence = from_mean(mean_of_independent(shares), 0);
  evidence.summary =
      "passages of a plane upwards less those downwards, over all; 0, since a mirror changes nothing";
  return evidence;
}

bool is_even(std::uint64_t cells) { return cells % 2 == 0; }

/// The bins of `fields` are the cells, and alternate in colour all around.
bool shows_colours(const Scene& scene) {
  const std::vector<double> cells = cells_along(scene);
  return is_at_rest(scene) && !cells.empty() &&
         std::ranges::any_of(scene.observe, [&](const Observe& observe) {
           return observe.what == "fields" && std::ranges::all_of(observe.grid, is_even) &&
                  std::ranges::equal(observe.grid, cells, [](std::uint64_t bins, double edge) {
                    return static_cast<double>(bins) == edge;
                  });
         });
}

/// Per bin of `fields`, 1 and -1 by turns along each axis; the last axis runs fastest.
std::vector<double> colours(const std::vector<std::size_t>& shape, std::size_t axes) {
  std::vector<double> signs{1};
  for (std::size_t axis = 0; axis < axes; ++axis) {
    std::vector<double> finer;
    for (const double sign : signs)
      for (std::size_t place = 0; place < shape[axis]; ++place)
        finer.push_back(place % 2 == 0 ? sign : -sign);
    signs = std::move(finer);
  }
  return signs;
}

/// Particles in cells of one colour less those of the other, over all, mean over the samples of a replica.
double colour_difference(const Series& fields, std::size_t axes) {
  const std::vector<double> signs = colours(fields.quantity.shape, axes);
  const std::size_t width = axes + 2;
  double difference = 0, all = 0;
  for (std::size_t i = 0; i < fields.value.size(); i += width) {
    difference += signs[i / width % signs.size()] * fields.value[i];
    all += fields.value[i];
  }
  return difference / all;
}

Evidence colour_balance(const Subject& subject, const law::Arguments&) {
  std::vector<double> differences;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    differences.push_back(
        colour_difference(subject.series(replica, "fields"), static_cast<std::size_t>(subject.dimension())));
  Evidence evidence = from_mean(mean_of_independent(differences), 0);
  evidence.summary =
      "particles in cells of one colour of the checkerboard less those of the other, over all; 0, since a "
      "shift by a cell changes nothing";
  return evidence;
}
}  // namespace

std::vector<CheckInfo> symmetry_checks() {
  return {
      {"passage-balance",
       "passages of a plane at an edge of cells, or in their middle, in a gas at rest: as many either way",
       "",
       {"crossing-count"},
       false,
       {},
       [](const Scene& scene) { return is_at_rest(scene) && has_plane_of_mirror(scene); },
       passage_balance},
      {"colour-balance",
       "particles in the cells of either colour of the checkerboard: as many",
       "",
       {"fields"},
       false,
       {},
       shows_colours,
       colour_balance}};
}

}  // namespace sandglass
