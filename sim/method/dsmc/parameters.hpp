#pragma once

#include "sim/method/cloner.hpp"
#include "sim/method/dsmc/curve.hpp"
#include "sim/observe/view.hpp"
#include "sim/physics/contact.hpp"
#include "sim/physics/contact_value.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace sandglass::dsmc {

/// Displacement of the partners of a collision along their own momentum change.
struct Offset {
  double consistent = 0;  ///< length along the momentum change
  double random = 0;  ///< length of an extra displacement of random direction, opposite for the two partners
  bool any() const { return consistent != 0 || random != 0; }
  double length() const { return std::hypot(consistent, random); }  ///< root mean square
};

/// Contact factor from the local density. Without a formula the factor is one and nothing is computed.
struct LocalFactor {
  ContactFormula formula = nullptr;
  bool smoothed = true;  ///< from a window of cells without the pair itself; else from the cell's own count
  int dimension = 0;     ///< of the formula for a mixture
  std::uint32_t window = 0;  ///< cells across; 0: see window_cells()
};

/// What candidates come from. counted: the pairs that each cell holds. expected: as many as chance would put into cells of
/// the local density; see ExpectedPairs. time_counter: pairs collide until the clock of the cell has passed the step; see
/// TimeCounterKernel.
enum class PairCount { counted, expected, time_counter };

/// Excluded volume on the level of cells (hybrid simulation Monte Carlo, Mueller 2001). Absent where `densest` is 0.
struct ExcludedVolume {
  double densest = 0;                 ///< fraction that a cell is filled to at most
  Curve entry;                        ///< probability of a move into a cell, over its fraction; empty: one
  bool offset_in_full_cells = false;  ///< collisions in full cells displace their partners too
  bool any() const { return densest > 0; }
};

/// Distribution of impact parameters, see FittedImpact.
struct Impact {
  Curve coefficient;  ///< over collisions per particle since time zero; empty: uniform
  bool fitted() const { return !coefficient.empty(); }
};

/// Where the partner of a collision is looked for. contact: a diameter away, see ContactPartners.
enum class Partners { cell, contact };

/// Particles of several species, and those that spin. Empty: smooth ones of one species, which need no more than the numbers
/// of Parameters.
struct Kinds {
  std::vector<SpeciesTraits> species;
  std::vector<Surface> surfaces;  ///< of species a with species b at [a * species.size() + b]
  bool rough = false;             ///< particles have spin
  std::vector<double> offsets;    ///< of each such pair in units of Parameters::offset; empty: all 1
  bool any() const { return !species.empty(); }
  bool mixed() const { return species.size() > 1; }
};

/// Faults that the mutant suite plants; all at their honest values otherwise.
struct Faults {
  double bound = 1;          ///< factor on the bound of relative speeds
  double momentum_leak = 0;  ///< relative shortfall of the second partner's kick
  double impact = 1;         ///< factor on the impact parameter
  bool acceptance_inverted = false;
  bool fraction_truncated = false;  ///< drops the fractional candidate
  bool spins_reversed = false;      ///< a collision changes spins the wrong way round
  bool first_reduced_mass = false;  ///< every pair has the reduced mass of two particles of the first species
  bool time_of_other_pair = false;  ///< a collision sets the clock forward by the time of another pair
  bool clocks_forgotten = false;    ///< clocks start every step anew
  double expected_pairs = 1;        ///< factor on the pairs that PairCount::expected puts into a cell
  bool speeds_forgotten = false;    ///< PairCount::expected takes missing pairs for average ones
  double heat_share = 1;            ///< of the energy that collisions of cells take, given back
  bool colours_fixed = false;       ///< the checkerboard of full cells does not swap
  bool room_updated = false;        ///< a cell fills up as its particles arrive, in the order of work
  bool contact_of_largest = false;  ///< every pair of species has the largest contact factor of them
  double reach = 1;                 ///< factor on the distance at which Partners::contact looks
  double contact_place = 0.5;  ///< where on the line of centres Partners::contact reads the contact value
  /// Of the collision kernel within cells; the others are those of their owners.
  bool any() const {
    return bound != 1 || momentum_leak != 0 || impact != 1 || acceptance_inverted || fraction_truncated ||
           spins_reversed || first_reduced_mass || time_of_other_pair;
  }
};

/// Everything that the DSMC kernel must know about the particles. Mass and restitution are those of one species, the diameter
/// is: of several, that of a particle of mean area or volume, which estimates need.
struct Parameters {
  double diameter = 1;
  double mass = 1;
  double restitution = 1;
  double cross_section = 2;     ///< of a pair; of several species: of the widest
  double weight = 1;            ///< real particles per simulated one
  std::vector<double> weights;  ///< the same of each cell; empty: the same everywhere
  CloningFaults cloning;
  LocalFactor factor;
  PairCount pair_count = PairCount::counted;
  Partners partners = Partners::cell;
  Offset offset;
  ExcludedVolume excluded_volume;
  Impact impact;
  Kinds kinds;
  bool measure_transfer = false;
  bool count_by_species = false;  ///< Tally::by_species
  double poured =
      0;  ///< particles that sources and inflows bring in: the window of the local density is chosen for them too
  Faults faults;
};

/// Pairs of species have factors of their own, see DensePairs.
inline bool has_factors_of_species(const Parameters& parameters) {
  return parameters.kinds.mixed() &&
         (parameters.factor.formula != nullptr || parameters.pair_count == PairCount::expected);
}

}  // namespace sandglass::dsmc
