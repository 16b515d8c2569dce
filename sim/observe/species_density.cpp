#include "sim/observe/species_density.hpp"

#include "sim/observe/population.hpp"

namespace sandglass {

template <int D>
Quantity SpeciesDensity<D>::quantity() const {
  std::vector<std::size_t> shape = bins_.extents;
  shape.push_back(species_);
  return {"species-density", "length^-D", "per bin: number density of each species", shape, {}, {}, ""};
}

template <int D>
std::vector<double> SpeciesDensity<D>::measure(const View<D>& view) {
  return with_population(view, [&](const auto& all) {
    std::vector<double> density(bins_.size() * species_);
    for (std::uint32_t i = 0; i < view.particles.size(); ++i)
      density[bins_.bin_of(view.particles[i].position, view.box) * species_ + all.index(i)] += all.weight(i);
    const double unit = all.weight.unit * static_cast<double>(bins_.size()) / view.box.prod();
    for (double& value : density) value *= unit;
    return density;
  });
}

template class SpeciesDensity<2>;
template class SpeciesDensity<3>;

}  // namespace sandglass
