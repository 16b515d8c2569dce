#include "sim/method/dsmc/from_scene.hpp"

#include "sim/base/packing.hpp"
#include "sim/method/from_scene.hpp"
#include "sim/method/grid_from_scene.hpp"
#include "sim/physics/collision.hpp"
#include "sim/scene/method/capabilities.hpp"

#include <algorithm>

namespace sandglass::dsmc {

namespace {
const DsmcOptions& options_of(const Scene& scene) { return std::get<DsmcOptions>(scene.method.options); }

Offset offset_of(const Scene& scene) {
  const Species& species = scene.species.front();
  const double d = species.diameter, r = species.restitution;
  switch (options_of(scene).offset) {
    case sandglass::Offset::none:
      return {};
    case sandglass::Offset::consistent:
      return {d, 0};
    // The offset carries m d r |c_n| a collision after the kick, hard cores carry m d (1 + r)/2 |c_n|.
    case sandglass::Offset::corrected:
      return {d * (1 + r) / (2 * r), 0};
    case sandglass::Offset::random:
      return {d, d * options_of(scene).random_offset};
  }
  return {};
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
  return {sandglass::traits_of(scene), surfaces_of(scene), is_rough(scene)};
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
  parameters.diameter = species.diameter;
  parameters.mass = species.mass;
  parameters.restitution = species.restitution;
  parameters.cross_section = cross_section(D, largest_diameter(scene));
  parameters.kinds = kinds_of(scene);
  parameters.weight = scene.method.weight;
  parameters.offset = offset_of(scene);
  parameters.poured = static_cast<double>(added_count(scene));
  parameters.excluded_volume = excluded_volume_of(D, options);
  parameters.impact.coefficient = {options.impact_coefficient.at, options.impact_coefficient.value};
  if (options.pair_count == sandglass::PairCount::expected) parameters.pair_count = PairCount::expected;
  if (options.partners == sandglass::Partners::contact) parameters.partners = Partners::contact;
  if (options.contact_factor == ContactFactor::local)
    parameters.factor = {contact_formula(D), options.density == DensityEstimate::smoothed};
  return parameters;
}

template LatticeOfCells<2> cells_of(const Scene&, double);
template LatticeOfCells<3> cells_of(const Scene&, double);
template Parameters parameters_of<2>(const Scene&);
template Parameters parameters_of<3>(const Scene&);

}  // namespace sandglass::dsmc
