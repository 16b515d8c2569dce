#include "sim/method/event_driven/planted_faults.hpp"

#include <algorithm>
#include <limits>

namespace sandglass::event_driven {

namespace {
/// Factor on the normal restitution of every pair.
template <class P>
void scale_restitution(P& parameters, double factor) {
  for (Surface& surface : parameters.surfaces)
    surface.normal.value = std::min(1.0, factor * surface.normal.value);
}
}  // namespace

const std::vector<FaultEntry<FaultChange>>& planted_faults() {
  static const std::vector<FaultEntry<FaultChange>> all = {
      {{"restitution-plus-2-percent", "restitution 2% too large, at most 1"},
       [](auto& p) { scale_restitution(p, 1.02); }},
      {{"restitution-minus-2-percent", "restitution 2% too small"},
       [](auto& p) { scale_restitution(p, 0.98); }},
      {{"restitution-forgotten", "every collision elastic"},
       [](auto& p) {
         for (Surface& surface : p.surfaces) surface.normal.value = 1;
       }},
      {{"restitution-plus-20-percent", "restitution 20% too large, at most 1"},
       [](auto& p) { scale_restitution(p, 1.2); }},
      {{"momentum-leak", "second partner's kick a millionth short"},
       [](auto& p) { p.faults.momentum_leak = 1e-6; }},
      {{"diameter-plus-2-percent", "hard particles 2% too large"},
       [](auto& p) {
         for (SpeciesTraits& kind : p.species) kind.diameter *= 1.02;
       }},
      {{"stale-partners", "a predicted contact is carried out whatever its partner did meanwhile"},
       [](auto& p) { p.faults.stale_partner = true; }},
      {{"blind-crossings", "who enters a cell does not see who is ahead"},
       [](auto& p) { p.faults.blind_crossing = true; }},
      {{"newcomers-lost", "one in twenty of those who come in by an inflow is lost"},
       [](auto& p) { p.faults.lost_newcomers = true; }},
      {{"outflows-draw-maxwellian",
        "normal velocities of those whom outflows turn back are Maxwell's instead of its flux"},
       [](auto& p) { p.faults.maxwellian_backflow = true; }},
      {{"piston-stays-out", "the piston of a dispenser does not jump back"},
       [](auto& p) { p.faults.staying_piston = true; }},
      {{"guard-dropped", "no collapse guard"},
       [](auto& p) {
         p.contact_time = 0;
         for (Surface& surface : p.surfaces) surface.normal.reference_speed = 0;
       }},
      {{"contact-time-minus-20-percent", "contact time of the collapse guard 20% too short"},
       [](auto& p) { p.contact_time *= 0.8; }},
      {{"friction-dropped", "rough contacts always stick"},
       [](auto& p) {
         for (Surface& surface : p.surfaces) surface.friction = std::numeric_limits<double>::infinity();
       }},
      {{"tangential-restitution-flipped", "tangential restitution with the wrong sign"},
       [](auto& p) {
         for (Surface& surface : p.surfaces) surface.tangential = -surface.tangential;
       }},
  };
  return all;
}

}  // namespace sandglass::event_driven
