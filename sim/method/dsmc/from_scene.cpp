#include "sim/method/dsmc/from_scene.hpp"

#include "sim/base/error.hpp"
#include "sim/method/from_scene.hpp"
#include "sim/physics/collision.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass::dsmc {

namespace {
const DsmcOptions& options_of(const Scene& scene) { return std::get<DsmcOptions>(scene.method.options); }

double wanted_edge(const Scene& scene, double particles_per_cell) {
  const double particles = static_cast<double>(std::max<std::uint64_t>(particle_count(scene), 1));
  return options_of(scene).cell_size.value_or(
      std::pow(volume(scene.domain) * particles_per_cell / particles, 1.0 / scene.domain.dimension));
}

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
}  // namespace

template <int D>
Grid<D> grid_of(const Scene& scene, double particles_per_cell) {
  const std::vector<std::uint64_t>& given = options_of(scene).cells;
  const double edge = wanted_edge(scene, particles_per_cell);
  std::array<std::uint32_t, D> cells;
  double total = 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const double wanted = given.empty() ? std::max(1.0, std::round(scene.domain.size[axis] / edge))
                                        : static_cast<double>(given[axis]);
    total *= wanted;
    if (total > 2e9)
      throw InputError(fmt::format(
          "the scene asks for more than {:.3g} cells; raise 'method.cell-size' or lower 'method.cells'",
          total));
    cells[axis] = static_cast<std::uint32_t>(wanted);
  }
  return Grid<D>(vector_of<D>(scene.domain.size), cells);
}

template <int D>
Parameters parameters_of(const Scene& scene) {
  const Species& species = scene.species.front();
  const DsmcOptions& options = options_of(scene);
  Parameters parameters;
  parameters.diameter = species.diameter;
  parameters.mass = species.mass;
  parameters.restitution = species.restitution;
  parameters.cross_section = cross_section(D, species.diameter);
  parameters.weight = scene.method.weight;
  parameters.offset = offset_of(scene);
  if (options.pair_count == sandglass::PairCount::expected) parameters.pair_count = PairCount::expected;
  if (options.contact_factor == ContactFactor::local)
    parameters.factor = {contact_formula(D), options.density == DensityEstimate::smoothed};
  return parameters;
}

template Grid<2> grid_of(const Scene&, double);
template Grid<3> grid_of(const Scene&, double);
template Parameters parameters_of<2>(const Scene&);
template Parameters parameters_of<3>(const Scene&);

}  // namespace sandglass::dsmc
