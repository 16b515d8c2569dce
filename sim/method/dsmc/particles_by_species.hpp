#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace sandglass::dsmc {

/// Places of the particles of each cell, by species.
class ParticlesBySpecies {
 public:
  /// `offsets` as of ParticleStore, `species` of each particle.
  void update(std::span<const std::uint32_t> offsets, const std::uint8_t* species, std::size_t kinds);
  std::span<const std::uint32_t> places(std::uint32_t cell, std::uint8_t kind) const {
    const std::uint32_t* first = &first_[cell * kinds_ + kind];
    return {places_.data() + first[0], first[1] - first[0]};
  }
  std::uint32_t count(std::uint32_t cell, std::uint8_t kind) const {
    return static_cast<std::uint32_t>(places(cell, kind).size());
  }
  std::size_t bytes() const { return (first_.capacity() + places_.capacity()) * sizeof(std::uint32_t); }

 private:
  std::size_t kinds_ = 0;
  std::vector<std::uint32_t> first_;  ///< of each cell and species, and the end
  std::vector<std::uint32_t> places_;
};

}  // namespace sandglass::dsmc
