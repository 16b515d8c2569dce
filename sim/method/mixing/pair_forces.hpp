#pragma once

#include "sim/base/vector.hpp"
#include "sim/method/mixing/repulsion.hpp"
#include "sim/space/grid.hpp"
#include "sim/space/phase.hpp"

#include <span>
#include <vector>

namespace sandglass::mixing {

/// The particles of a step, sorted into the cells of a grid.
struct Crowd {
  std::span<const Phase<2>> particles;
  std::span<const std::uint32_t> offsets;  ///< first particle of each cell, and the end
  std::span<const double> masses;
};

/// Repulsion of all pairs that are nearer than the cutoff: those of a cell and of cells that touch it, each once. The cells
/// must be as wide as the cutoff, or be a single one.
class PairForces {
 public:
  PairForces(const Repulsion& repulsion, const Grid<2>& grid);
  /// Adds to the accelerations; the number of pairs within reach.
  std::uint64_t add(const Crowd& crowd, std::span<Vector<2>> accelerations) const;

 private:
  Repulsion repulsion_;
  std::uint32_t columns_, rows_;
};

}  // namespace sandglass::mixing
