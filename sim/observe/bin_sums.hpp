#pragma once

#include <cstdint>

namespace sandglass {

/// What the particles in one bin of a grid add up to, whatever else an observer wants of them.
struct BinSums {
  std::uint32_t particles = 0;
  double count = 0;   ///< of real particles
  double mass = 0;    ///< theirs
  double shared = 0;  ///< sum of weight squared times mass: what Population::freedom takes off

  /// Particle i of a Population.
  template <class All>
  void add(const All& all, std::uint32_t i) {
    ++particles;
    count += all.weight(i);
    mass += all.real_mass(i);
    shared += all.weight(i) * all.real_mass(i);
  }
};

}  // namespace sandglass
