#include "sim/method/dsmc/from_scene.hpp"

#include "sim/base/packing.hpp"
#include "sim/method/from_scene.hpp"
#include "sim/method/grid_from_scene.hpp"
#include "sim/physics/collision.hpp"
#include "sim/scene/method/capabilities.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::dsmc {

namespace {
const DsmcOptions& options_of(const Scene& scene) { return std::get<DsmcOptions>(scene.method.options); }

/// Of the first species; of several, that of a particle of mean area or volume.
double mean_diameter(const Scene& scene) {
  if (scene.species.size() == 1) return scene.species.front().diameter;
  const int dimension = scene.domain.dimension;
  double count = 0, sum = 0;
  for (const Species& species : scene.species) {
    const auto particles = static_cast<double>(particle_count(scene, species));
    count += particles;
    sum += particles * std::pow(species.diameter, dimension);
  }
  return std::pow(sum / count, 1.0 / dimension);
}

Offset offset_of(const Scene& scene) {
  const double d = mean_diameter(scene);
  return {offset_along(scene, d, scene.species.front().restitution), d * random_offset(scene)};
}

/// Kinds::offsets: partners of different width are displaced by their mean diameter.
std::vector<double> offsets_of_pairs(const Scene& scene, const std::vector<Surface>& surfaces) {
  const double unit = offset_along(scene, mean_diameter(scene), scene.species.front().restitution);
  if (unit == 0) return {};
  std::vector<double> all;
  for (const Species& one : scene.species)
    for (const Species& two : scene.species)
      all.push_back(
          offset_along(scene, (one.diameter + two.diameter) / 2, surfaces[all.size()].normal.value) / unit);
  return all;
}

PairCount pair_count_of(const DsmcOptions& options) {
  switch (options.pair_count) {
    case sandglass::PairCount::counted:
      return PairCount::counted;
    case sandglass::PairCount::expected:
      return PairCount::expected;
    case sandglass::PairCount::time_counter:
      return PairCount::time_counter;
  }
  return PairCount::counted;
}

ExcludedVolume excluded_volume_of(int dimension, const DsmcOptions& options) {
  ExcludedVolume volume;
  if (options.excluded_volume == sandglass::ExcludedVolume::none) return volume;
  volume.densest = options.densest_fraction.value_or(random_close_packing(dimension));
  volume.offset_in_full_cells = options.offset_in_full_cells;
  if (options.entry == Entry::free) return volume;
  volume.entry = {options.entry_curve.at, options.entry_curve.value};
  // Below freezing every place of the fluid can be reached.
  if (volume.entry.empty())
    volume.entry = {{std::min(freezing_fraction(dimension), 0.85 * volume.densest), volume.densest}, {1, 0}};
  return volume;
}

Kinds kinds_of(const Scene& scene) {
  if (scene.species.size() < 2 && !is_rough(scene)) return {};
  const std::vector<Surface> surfaces = surfaces_of(scene);
  return {sandglass::traits_of(scene), surfaces, is_rough(scene), offsets_of_pairs(scene, surfaces)};
}
}  // namespace

template <int D>
LatticeOfCells<D> cells_of(const Scene& scene, double particles_per_cell) {
  const DsmcOptions& options = options_of(scene);
  const bool chosen = !options.cells.empty() || options.cell_size;
  const Grid<D> grid = grid_of_cells<D>(
      scene,
      chosen ? cells_along(scene)
             : cells_of_edge(scene, std::max(edge_for(scene, particles_per_cell), least_cell_edge(scene))));
  std::array<bool, D> periodic;
  for (std::size_t axis = 0; axis < D; ++axis) periodic[axis] = scene.domain.sides[axis][0] == Side::periodic;
  if (options.lattice == CellLattice::shifted) return LatticeOfCells<D>::shifted(grid, periodic);
  if constexpr (D == 2)
    if (options.lattice == CellLattice::diagonal) return LatticeOfCells<D>::diagonal(grid, periodic);
  return grid;
}

template <int D>
Parameters parameters_of(const Scene& scene) {
  const Species& species = scene.species.front();
  const DsmcOptions& options = options_of(scene);
  Parameters parameters;
  parameters.diameter = mean_diameter(scene);
  parameters.mass = species.mass;
  parameters.restitution = species.restitution;
  parameters.cross_section = cross_section(D, largest_diameter(scene));
  parameters.kinds = kinds_of(scene);
  parameters.weight = scene.method.weight;
  parameters.offset = offset_of(scene);
  parameters.poured = static_cast<double>(added_count(scene));
  parameters.excluded_volume = excluded_volume_of(D, options);
  parameters.impact.coefficient = {options.impact_coefficient.at, options.impact_coefficient.value};
  parameters.pair_count = pair_count_of(options);
  if (options.partners == sandglass::Partners::contact) parameters.partners = Partners::contact;
  if (options.contact_factor == ContactFactor::local)
    parameters.factor = {contact_formula(D), options.density == DensityEstimate::smoothed, D,
                         static_cast<std::uint32_t>(options.density_window.value_or(0))};
  return parameters;
}

template LatticeOfCells<2> cells_of(const Scene&, double);
template LatticeOfCells<3> cells_of(const Scene&, double);
template Parameters parameters_of<2>(const Scene&);
template Parameters parameters_of<3>(const Scene&);

}  // namespace sandglass::dsmc
