#pragma once

#include "sim/observe/plane.hpp"
#include "sim/observe/tally.hpp"
#include "sim/space/particle_store.hpp"

#include <span>
#include <vector>

namespace sandglass {

/// What an observer sees of a simulation at the end of a step.
template <int D>
struct View {
  std::span<const Phase<D>> particles;     ///< sorted by cell
  std::span<const std::uint32_t> offsets;  ///< first particle of each cell, and the end
  Vector<D> box = Vector<D>::Zero();
  double mass = 1;
  double weight = 1;  ///< real particles per simulated one
  std::uint64_t step = 0;
  double time = 0;
  const Tally* tally = nullptr;
  std::vector<Plane>* planes = nullptr;
};

}  // namespace sandglass
