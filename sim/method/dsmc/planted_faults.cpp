#include "sim/method/dsmc/planted_faults.hpp"

#include <algorithm>
#include <limits>

namespace sandglass::dsmc {

namespace {
using P = Parameters&;

/// Of every pair, at most 1.
void scale_restitution(P parameters, double factor) {
  parameters.restitution = std::min(1.0, factor * parameters.restitution);
  for (Surface& surface : parameters.kinds.surfaces)
    surface.normal.value = std::min(1.0, factor * surface.normal.value);
}
}  // namespace

const std::vector<FaultEntry<FaultChange>>& planted_faults() {
  static const std::vector<FaultEntry<FaultChange>> all = {
      {{"cross-section-plus-5-percent", "cross-section 5% too large"},
       [](P p, int) { p.cross_section *= 1.05; }},
      {{"restitution-plus-2-percent", "restitution 2% too large, at most 1"},
       [](P p, int) { scale_restitution(p, 1.02); }},
      {{"restitution-minus-2-percent", "restitution 2% too small"},
       [](P p, int) { scale_restitution(p, 0.98); }},
      {{"restitution-forgotten", "every collision elastic"},
       [](P p, int) {
         p.restitution = 1;
         for (Surface& surface : p.kinds.surfaces) surface.normal.value = 1;
       }},
      {{"restitution-plus-20-percent", "restitution 20% too large, at most 1"},
       [](P p, int) { scale_restitution(p, 1.2); }},
      {{"acceptance-inverted", "pairs refused that should collide and the other way round"},
       [](P p, int) { p.faults.acceptance_inverted = true; }},
      {{"fraction-truncated", "fractional candidate dropped"},
       [](P p, int) { p.faults.fraction_truncated = true; }},
      {{"bound-halved", "bound on relative speeds half of what it must be"},
       [](P p, int) { p.faults.bound = 0.5; }},
      {{"momentum-leak", "second partner's kick a millionth short"},
       [](P p, int) { p.faults.momentum_leak = 1e-6; }},
      {{"impact-parameter-central", "impact parameters 10% too small"},
       [](P p, int) { p.faults.impact = 0.9; }},
      {{"time-of-other-pair", "a collision sets the clock of its cell forward by the time of another pair"},
       [](P p, int) { p.faults.time_of_other_pair = true; }},
      {{"clocks-forgotten", "clocks of the cells start every step anew"},
       [](P p, int) { p.faults.clocks_forgotten = true; }},
      {{"spins-reversed", "collisions change spins the wrong way round"},
       [](P p, int) { p.faults.spins_reversed = true; }},
      {{"tangential-restitution-flipped", "tangential restitution with the wrong sign"},
       [](P p, int) {
         for (Surface& surface : p.kinds.surfaces) surface.tangential = -surface.tangential;
       }},
      {{"friction-dropped", "rough contacts always stick"},
       [](P p, int) {
         for (Surface& surface : p.kinds.surfaces) surface.friction = std::numeric_limits<double>::infinity();
       }},
      {{"reduced-mass-of-first-species", "every pair has the reduced mass of the first species"},
       [](P p, int) { p.faults.first_reduced_mass = true; }},
      {{"cross-section-of-larger-species", "every pair has the cross-section of the largest species"},
       [](P p, int) {
         const double largest =
             p.kinds.any() ? std::ranges::max(p.kinds.species, {}, &SpeciesTraits::diameter).diameter : 0;
         for (SpeciesTraits& kind : p.kinds.species) kind.diameter = largest;
       }},
      {{"offset-dropped", "no displacement after collisions"}, [](P p, int) { p.offset = {}; }},
      {{"offset-doubled", "displacement after collisions twice as long"},
       [](P p, int) { p.offset.consistent *= 2; }},
      {{"random-offset-halved", "random displacement after collisions half as long"},
       [](P p, int) { p.offset.random /= 2; }},
      {{"contact-factor-dropped", "contact factor left out"}, [](P p, int) { p.factor.formula = nullptr; }},
      {{"contact-factor-of-other-dimension", "contact factor of spheres for disks and of disks for spheres"},
       [](P p, int dimension) {
         p.factor.dimension = dimension == 2 ? 3 : 2;
         p.factor.formula = contact_formula(p.factor.dimension);
       }},
      {{"contact-value-of-larger-species", "every pair has the contact factor of the largest species"},
       [](P p, int) { p.faults.contact_of_largest = true; }},
      {{"density-from-cell-count", "contact factor from the cell's own count"},
       [](P p, int) { p.factor.smoothed = false; }},
      {{"expected-pairs-doubled", "twice the pairs that chance puts into a cell"},
       [](P p, int) { p.faults.expected_pairs = 2; }},
      {{"fast-pairs-forgotten", "expected pairs take those missing for average ones"},
       [](P p, int) { p.faults.speeds_forgotten = true; }},
      {{"partners-at-half-the-distance", "partners looked for half a diameter away"},
       [](P p, int) { p.faults.reach = 0.5; }},
      {{"contact-value-of-own-cell", "contact factor of a particle's own cell instead of the midpoint's"},
       [](P p, int) { p.faults.contact_place = 0; }},
      {{"cells-never-full", "full cells not marked"}, [](P p, int) { p.excluded_volume.densest *= 1e6; }},
      {{"densest-plus-10-percent", "cells take in 10% more than the densest packing"},
       [](P p, int) { p.excluded_volume.densest *= 1.1; }},
      {{"cell-heat-kept", "energy that collisions of cells take is not given back"},
       [](P p, int) { p.faults.heat_share = 0; }},
      {{"cell-colours-fixed", "checkerboard of full cells does not swap"},
       [](P p, int) { p.faults.colours_fixed = true; }},
      {{"entry-probability-ignored", "every cell that is not full lets in whoever comes"},
       [](P p, int) { p.excluded_volume.entry = {}; }},
      {{"room-updated", "room of cells updated as particles arrive"},
       [](P p, int) { p.faults.room_updated = true; }},
      {{"clones-keep-weight", "copies in a region of lower weight keep the weight of the particle"},
       [](P p, int) { p.cloning.clones_keep_weight = true; }},
      {{"survivors-keep-weight",
        "who stays in a region of higher weight, where others are removed, keeps its weight"},
       [](P p, int) { p.cloning.survivors_keep_weight = true; }},
      {{"impact-coefficient-ignored", "impact parameters uniform whatever was fitted"},
       [](P p, int) { p.impact.coefficient = {}; }},
  };
  return all;
}

}  // namespace sandglass::dsmc
