#include "sim/method/dsmc/species_table.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::dsmc {

namespace {
/// Proportional to (d_1 + d_2)/2 in 2D and to its square in 3D.
double section(int dimension, double width_1, double width_2) {
  return std::pow((width_1 + width_2) / 2, dimension - 1);
}
}  // namespace

template <int D>
SpeciesTable<D>::SpeciesTable(const Parameters& parameters) : species_(parameters.kinds.species.size()) {
  const std::vector<SpeciesTraits>& species = parameters.kinds.species;
  const double widest = std::ranges::max(species, {}, &SpeciesTraits::diameter).diameter;
  for (const SpeciesTraits& kind : species) widths_.push_back(kind.diameter / widest);
  for (std::size_t a = 0; a < species_; ++a)
    for (std::size_t b = 0; b < species_; ++b) {
      const double mass_1 = species[a].mass, mass_2 = species[b].mass;
      const double twice_reduced =
          parameters.faults.first_reduced_mass ? species.front().mass : 2 / (1 / mass_1 + 1 / mass_2);
      pairs_.push_back({section(D, widths_[a], widths_[b]),
                        parameters.kinds.surfaces[a * species_ + b].normal.value, twice_reduced / mass_1,
                        twice_reduced / mass_2, twice_reduced,
                        parameters.kinds.offsets.empty() ? 1 : parameters.kinds.offsets[a * species_ + b]});
    }
}

template <int D>
double SpeciesTable<D>::largest(const std::uint8_t* species, std::uint32_t count) const {
  double widest = 0, second = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double width = widths_[species[i]];
    second = std::max(second, std::min(width, widest));
    widest = std::max(width, widest);
  }
  return section(D, widest, second);
}

template <int D>
double SpeciesTable<D>::largest(std::uint8_t species) const {
  return section(D, widths_[species], 1);
}

template class SpeciesTable<2>;
template class SpeciesTable<3>;

}  // namespace sandglass::dsmc
