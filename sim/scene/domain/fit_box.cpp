#include "sim/scene/read_sections.hpp"
#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sandglass {

namespace {
const std::string remedy =
    "give edge lengths, for example size = [10.0, 10.0], or 'count' beside a fraction in one [[species]], "
    "from "
    "which the size follows";

bool positive_number(double value) { return std::isfinite(value) && value > 0; }

/// Index of the one species that gives the size; nothing, after a report, when none or several do.
std::optional<std::size_t> find_measure(Diagnostics& diagnostics, const Scene& scene) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < scene.species.size(); ++i)
    if (scene.species[i].count && scene.species[i].fraction) found.push_back(i);
  if (found.empty()) diagnostics.report("domain.size", "missing 'domain.size': " + remedy);
  for (std::size_t i = 1; i < found.size(); ++i)
    diagnostics.report(
        item_path("species", found[i]) + '.' + fraction_key(scene.domain.dimension),
        "two species give 'count' beside a fraction, and the size of the domain can follow from one "
        "of them only; keep one");
  return found.size() == 1 ? std::optional(found.front()) : std::nullopt;
}

bool check_proportions(Diagnostics& diagnostics, const std::vector<double>& proportions, int dimension) {
  const bool right = static_cast<int>(proportions.size()) == dimension &&
                     std::all_of(proportions.begin(), proportions.end(), positive_number);
  if (!right && diagnostics.clean("domain.proportions"))
    diagnostics.report("domain.proportions",
                       "'domain.proportions' must be one number above 0 for each axis, for example [2, 1]");
  return right;
}

/// Length of an edge of proportion one.
double unit_edge(const Scene& scene, std::size_t measure, const std::vector<double>& proportions,
                 Diagnostics& diagnostics) {
  const Species& species = scene.species[measure];
  const int dimension = scene.domain.dimension;
  const std::string path = item_path("species", measure) + '.' + fraction_key(dimension);
  if (!check_bounds(diagnostics, path, *species.fraction, positive())) return 1;
  const double real = static_cast<double>(*species.count) * scene.method.weight;
  const double room = real * particle_volume(species, dimension) / *species.fraction;
  const double shape = std::accumulate(proportions.begin(), proportions.end(), 1.0, std::multiplies<>());
  return positive_number(room) ? std::pow(room / shape, 1.0 / dimension) : 1;
}
}  // namespace

void fit_box(const std::vector<double>& proportions, Scene& scene, Diagnostics& diagnostics) {
  if (!scene.domain.size.empty() || !diagnostics.clean("domain") || !diagnostics.clean("species")) return;
  if (!scene.given.empty())
    return diagnostics.report("domain.size", "missing 'domain.size': edge lengths, one for each axis");
  const int dimension = scene.domain.dimension;
  if (dimension != 2 && dimension != 3) return;
  const std::optional<std::size_t> measure = find_measure(diagnostics, scene);
  const bool shaped = check_proportions(diagnostics, proportions, dimension);
  double unit = 1;
  if (measure && shaped) unit = unit_edge(scene, *measure, proportions, diagnostics);
  // After an error too: the rules that follow shall not report its consequences.
  scene.domain.size.assign(static_cast<std::size_t>(dimension), unit);
  for (std::size_t axis = 0; shaped && axis < proportions.size(); ++axis)
    scene.domain.size[axis] *= proportions[axis];
  for (Species& species : scene.species)
    if (species.count) species.fraction.reset();
}

}  // namespace sandglass
