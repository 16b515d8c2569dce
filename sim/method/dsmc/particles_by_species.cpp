#include "sim/method/dsmc/particles_by_species.hpp"

namespace sandglass::dsmc {

void ParticlesBySpecies::update(std::span<const std::uint32_t> offsets, const std::uint8_t* species,
                                std::size_t kinds) {
  kinds_ = kinds;
  const std::size_t cells = offsets.size() - 1;
  first_.assign(cells * kinds + 1, 0);
  places_.resize(offsets[cells]);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    std::uint32_t* first = &first_[cell * kinds];
    for (std::uint32_t i = offsets[cell]; i < offsets[cell + 1]; ++i) ++first[species[i]];
    std::uint32_t sum = offsets[cell];
    for (std::size_t kind = 0; kind < kinds; ++kind) first[kind] = sum += first[kind];
    for (std::uint32_t i = offsets[cell + 1]; i-- > offsets[cell];) places_[--first[species[i]]] = i;
  }
  first_.back() = offsets[cells];
}

}  // namespace sandglass::dsmc
