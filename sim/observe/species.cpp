#include "sim/observe/species.hpp"

#include "sim/observe/sums.hpp"

namespace sandglass {

template <int D>
Quantity SpeciesTemperature<D>::quantity() const {
  return {"species-temperature",
          "mass length^2 time^-2",
          "granular temperature of each species",
          {species_.size()},
          species_,
          {},
          ""};
}

/// From <w m C^2> = w T (1 - w m / M) of each particle, as Population::freedom has it for all.
template <int D>
std::vector<double> SpeciesTemperature<D>::measure(const View<D>& view) {
  return with_population(view, [&](const auto& all) {
    const Vector<D> mean = mean_velocity(view, all);
    const auto sums = sum_particles_by_kind<2>(
        view, species_.size(), [&](std::uint32_t i) { return all.index(i); },
        [&](const Phase<D>& particle, std::uint32_t i) {
          return std::array{all.real_mass(i) * (particle.velocity - mean).squaredNorm() / D,
                            all.weight(i) * (1 - all.real_mass(i) / all.total_mass)};
        });
    std::vector<double> values;
    for (const auto& [squares, freedom] : sums)
      values.push_back(freedom > 0 ? all.mass_unit() * squares / freedom : 0);
    return values;
  });
}

template <int D>
Quantity SpeciesCollisions<D>::quantity() const {
  std::vector<std::string> pairs;
  for (std::size_t a = 0; a < species_.size(); ++a)
    for (std::size_t b = a; b < species_.size(); ++b) pairs.push_back(species_[a] + ':' + species_[b]);
  const std::size_t count = pairs.size();
  return {"species-collisions",
          "1",
          "collisions of simulated particles by pair of species since time zero",
          {count},
          std::move(pairs),
          {},
          ""};
}

template <int D>
std::vector<double> SpeciesCollisions<D>::measure(const View<D>& view) {
  const std::size_t species = species_.size();
  const auto& counted = view.tally->by_species;
  std::vector<double> values;
  for (std::size_t a = 0; a < species; ++a)
    for (std::size_t b = a; b < species; ++b)
      values.push_back(
          static_cast<double>(counted.at(a * species + b) + (a == b ? 0 : counted.at(b * species + a))));
  return values;
}

template class SpeciesTemperature<2>;
template class SpeciesTemperature<3>;
template class SpeciesCollisions<2>;
template class SpeciesCollisions<3>;

}  // namespace sandglass
