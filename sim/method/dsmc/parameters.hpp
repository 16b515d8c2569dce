#pragma once

#include "sim/physics/contact_value.hpp"

namespace sandglass::dsmc {

/// Displacement of the partners of a collision along their own momentum change.
struct Offset {
  double consistent = 0;  ///< length along the momentum change
  double random = 0;  ///< length of an extra displacement of random direction, opposite for the two partners
  bool any() const { return consistent != 0 || random != 0; }
};

/// Contact factor from the local density. Without a formula the factor is one and nothing is computed.
struct LocalFactor {
  ContactFormula formula = nullptr;
  bool smoothed = true;  ///< from a window of cells without the pair itself; else from the cell's own count
};

/// Faults that the mutant suite plants; all at their honest values otherwise.
struct Faults {
  double bound = 1;          ///< factor on the bound of relative speeds
  double momentum_leak = 0;  ///< relative shortfall of the second partner's kick
  double impact = 1;         ///< factor on the impact parameter
  bool acceptance_inverted = false;
  bool fraction_truncated = false;  ///< drops the fractional candidate
  bool any() const {
    return bound != 1 || momentum_leak != 0 || impact != 1 || acceptance_inverted || fraction_truncated;
  }
};

/// Everything that the DSMC kernel must know about the particles.
struct Parameters {
  double diameter = 1;
  double mass = 1;
  double restitution = 1;
  double cross_section = 2;
  double weight = 1;  ///< real particles per simulated one
  LocalFactor factor;
  Offset offset;
  bool measure_transfer = false;
  Faults faults;
};

}  // namespace sandglass::dsmc
