#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

// What each method family lets a scene choose, as plain values: one struct a family, so that a key of another family
// cannot even be stored.

namespace sandglass {

/// local: Henderson (2D) or Carnahan-Starling (3D) contact value of the local density.
enum class ContactFactor { none, local };
enum class DensityEstimate { smoothed, cell };
enum class Offset { none, consistent, corrected, random };
/// What candidates come from: the pairs that a cell holds, or those that chance would put there. time_counter: pairs of a
/// cell collide until its clock has passed the step (Bird 1976).
enum class PairCount { counted, expected, time_counter };

/// cells: none takes in more than the densest packing, and full ones collide as a whole (HSMC, Mueller 2001).
enum class ExcludedVolume { none, cells };
/// Into a cell that is not full. free: always; falling: less likely the fuller it is.
enum class Entry { free, falling };

/// Of the collision cells. shifted: displaced at random every step; diagonal: squares that stand on a corner.
enum class CellLattice { fixed, shifted, diagonal };
/// Where the partner of a collision is looked for: in the same cell, or a diameter away (ESMC, Montanero & Santos 1996).
enum class Partners { cell, contact };

/// Numbers at rising places, straight lines in between; also one number for all places.
struct Curve {
  std::vector<double> at, value;
  bool operator==(const Curve&) const = default;
};

/// uniform: molecular chaos; fitted: p(b) = a/(1 - c b^2) with b in diameters (Mueller 2001, 3.18).
enum class ImpactDistribution { uniform, fitted };

/// Direct simulation Monte Carlo and its dense-gas variants.
struct DsmcOptions {
  ContactFactor contact_factor = ContactFactor::none;
  DensityEstimate density = DensityEstimate::smoothed;
  std::optional<std::uint64_t> density_window;  ///< cells across; none: enough at the mean density of the box
  Offset offset = Offset::none;
  PairCount pair_count = PairCount::counted;
  double random_offset = 0;  ///< cuba: length of the extra zero-mean offset, in diameters
  ExcludedVolume excluded_volume = ExcludedVolume::none;
  std::optional<double> densest_fraction;  ///< of a full cell; none: random close packing
  Entry entry = Entry::free;
  Curve entry_curve;  ///< probability over fraction; empty: from one at freezing to zero in a full cell
  bool offset_in_full_cells = false;
  CellLattice lattice = CellLattice::fixed;
  Partners partners = Partners::cell;
  ImpactDistribution impact = ImpactDistribution::uniform;
  Curve impact_coefficient;          ///< c over collisions per particle
  std::vector<std::uint64_t> cells;  ///< cells per axis; empty: chosen from cell_size
  std::optional<double> cell_size;   ///< wanted edge; the nearest whole number of cells is taken
  bool operator==(const DsmcOptions&) const = default;
};

/// What keeps a run of exact collisions from infinitely many of them in finite time (inelastic collapse).
/// contact_time: a collision is elastic when the previous one of a partner was less than `contact_time` ago
/// (TC model; Luding & McNamara 1998). velocity_dependent: r(v) = 1 - (1 - r) (v/v0)^(3/4) below
/// v0 = `reference_speed`, v the normal relative speed (Bizon et al. 1998).
enum class CollapseGuard { none, contact_time, velocity_dependent };

/// A collapse guard and its number; the other number is 0.
struct Guard {
  CollapseGuard kind = CollapseGuard::none;
  double contact_time = 0;
  double reference_speed = 0;
  bool operator==(const Guard&) const = default;
};

/// Exact hard disks and spheres.
struct EventDrivenOptions {
  Guard guard;
  bool operator==(const EventDrivenOptions&) const = default;
};

/// An ideal-gas stream through a plane.
struct ReservoirOptions {
  bool operator==(const ReservoirOptions&) const = default;
};

/// Free flight: nothing to choose.
struct CollisionlessOptions {
  bool operator==(const CollisionlessOptions&) const = default;
};

/// Particles that repel each other and support each other against gravity (Greenspan 1972).
struct MixingOptions {
  double repulsion_coefficient = 1;           ///< alpha
  double softening_length = 0;                ///< xi
  std::uint64_t repulsion_exponent = 2;       ///< p
  std::uint64_t core_exponent = 0;            ///< beta, below a diameter
  std::optional<double> cutoff;               ///< none: every pair repels
  std::vector<std::uint64_t> support_blocks;  ///< along x and y; empty: gravity in full
  double wall_speed_factor = 1;               ///< omega
  double smallest_length = 1e-3;              ///< EPS of the listing
  bool operator==(const MixingOptions&) const = default;
};

/// In the order of method_families().
using MethodOptions =
    std::variant<DsmcOptions, EventDrivenOptions, ReservoirOptions, CollisionlessOptions, MixingOptions>;

}  // namespace sandglass
