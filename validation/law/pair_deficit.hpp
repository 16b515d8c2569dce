#pragma once

#include "validation/law/gas.hpp"
#include "validation/law/virial.hpp"

namespace sandglass::law {

/// How a Monte Carlo method whose collisions push particles apart counts its pairs.
struct PairCells {
  double particles = 1;  ///< mean number in a cell
  double edge = 1;       ///< of a cell [length]; the geometric mean of its edges
  double window = 1;     ///< cells across the window that the contact value is read from
  double cells = 1e12;   ///< in the periodic box
};

/// Part of the collisions that an elastic gas at rest lacks because counts scatter less than by chance [1]:
/// D_cc/N_c + (2 D_cw nu g'/g + D_ww nu^2 g''/(2g))/N_w, with D the part of the Poisson covariances of cell and window counts
/// that is missing. The pairs of a cell lack the first term; a window that takes its scatter for that of chance the second.
/// The value is the middle of two limits and the bound reaches to both: all waves damped as the longest, D = 1 - S(0), and
/// the linear fluid of cells with momentum carried over a diameter, which knows no pairs that part by the offset itself.
/// Derivation and runs: docs/theory.md.
Bounded pair_deficit(const Gas& gas, const PairCells& cells);

}  // namespace sandglass::law
