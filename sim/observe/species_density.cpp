#include "sim/observe/species_density.hpp"

#include "sim/observe/bin_counts.hpp"

namespace sandglass {

template <int D>
Quantity SpeciesDensity<D>::quantity() const {
  std::vector<std::size_t> shape = bins_.extents;
  shape.push_back(species_);
  return {"species-density", "length^-D", "per bin: number density of each species", shape, {}, {}, ""};
}

template <int D>
std::vector<double> SpeciesDensity<D>::measure(const View<D>& view) {
  return densities_by_bin(view, bins_, species_, [](std::size_t species) { return species; });
}

template class SpeciesDensity<2>;
template class SpeciesDensity<3>;

}  // namespace sandglass
