#include "sim/run/mutation.hpp"

#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"

#include <algorithm>
#include <limits>

namespace sandglass {

namespace {

/// The same change for disks and for spheres.
struct Hard {
  void (*disks)(event_driven::Parameters<2>&);
  void (*spheres)(event_driven::Parameters<3>&);
  template <class Change>
  Hard(Change change) : disks(change), spheres(change) {}  // NOLINT: a lambda in the table is one
};

/// A planted fault as a change of what the methods are told.
struct Plant {
  MutationInfo info;
  void (*dsmc)(dsmc::Parameters&, int dimension);
  void (*reservoir)(reservoir::Faults&);
  Hard hard;
};

void nothing(dsmc::Parameters&, int) {}
void nothing(reservoir::Faults&) {}
constexpr auto unchanged = [](auto&) {};

/// Factor on the normal restitution of every pair.
template <class Parameters>
void scale_restitution(Parameters& parameters, double factor) {
  for (Surface& surface : parameters.surfaces)
    surface.normal.value = std::min(1.0, factor * surface.normal.value);
}

using P = dsmc::Parameters&;
using R = reservoir::Faults&;

const std::vector<Plant>& plants() {
  static const std::vector<Plant> all = {
      {{"cross-section-plus-5-percent", "cross-section 5% too large"},
       [](P p, int) { p.cross_section *= 1.05; },
       nothing,
       unchanged},
      {{"restitution-plus-2-percent", "restitution 2% too large, at most 1"},
       [](P p, int) { p.restitution = std::min(1.0, 1.02 * p.restitution); },
       nothing,
       [](auto& p) { scale_restitution(p, 1.02); }},
      {{"restitution-minus-2-percent", "restitution 2% too small"},
       [](P p, int) { p.restitution *= 0.98; },
       nothing,
       [](auto& p) { scale_restitution(p, 0.98); }},
      {{"restitution-forgotten", "every collision elastic"},
       [](P p, int) { p.restitution = 1; },
       nothing,
       [](auto& p) {
         for (Surface& surface : p.surfaces) surface.normal.value = 1;
       }},
      {{"restitution-plus-20-percent", "restitution 20% too large, at most 1"},
       [](P p, int) { p.restitution = std::min(1.0, 1.2 * p.restitution); },
       nothing,
       [](auto& p) { scale_restitution(p, 1.2); }},
      {{"acceptance-inverted", "pairs refused that should collide and the other way round"},
       [](P p, int) { p.faults.acceptance_inverted = true; },
       nothing,
       unchanged},
      {{"fraction-truncated", "fractional candidate dropped"},
       [](P p, int) { p.faults.fraction_truncated = true; },
       nothing,
       unchanged},
      {{"bound-halved", "bound on relative speeds half of what it must be"},
       [](P p, int) { p.faults.bound = 0.5; },
       nothing,
       unchanged},
      {{"momentum-leak", "second partner's kick a millionth short"},
       [](P p, int) { p.faults.momentum_leak = 1e-6; },
       nothing,
       [](auto& p) { p.faults.momentum_leak = 1e-6; }},
      {{"impact-parameter-central", "impact parameters 10% too small"},
       [](P p, int) { p.faults.impact = 0.9; },
       nothing,
       unchanged},
      {{"offset-dropped", "no displacement after collisions"},
       [](P p, int) { p.offset = {}; },
       nothing,
       unchanged},
      {{"offset-doubled", "displacement after collisions twice as long"},
       [](P p, int) { p.offset.consistent *= 2; },
       nothing,
       unchanged},
      {{"contact-factor-dropped", "contact factor left out"},
       [](P p, int) { p.factor.formula = nullptr; },
       nothing,
       unchanged},
      {{"contact-factor-of-other-dimension", "contact factor of spheres for disks and of disks for spheres"},
       [](P p, int dimension) { p.factor.formula = contact_formula(dimension == 2 ? 3 : 2); },
       nothing,
       unchanged},
      {{"density-from-cell-count", "contact factor from the cell's own count"},
       [](P p, int) { p.factor.smoothed = false; },
       nothing,
       unchanged},
      {{"crossing-velocity-maxwellian",
        "crossing velocities from the Maxwellian instead of the flux distribution"},
       nothing,
       [](R r) { r.maxwellian = true; },
       unchanged},
      {{"flux-rate-net", "crossings at the net rate in both directions"},
       nothing,
       [](R r) { r.net_rate = true; },
       unchanged},
      {{"diameter-plus-2-percent", "hard particles 2% too large"},
       nothing,
       nothing,
       [](auto& p) {
         for (SpeciesTraits& kind : p.species) kind.diameter *= 1.02;
       }},
      {{"stale-partners", "a predicted contact is carried out whatever its partner did meanwhile"},
       nothing,
       nothing,
       [](auto& p) { p.faults.stale_partner = true; }},
      {{"blind-crossings", "who enters a cell does not see who is ahead"},
       nothing,
       nothing,
       [](auto& p) { p.faults.blind_crossing = true; }},
      {{"guard-dropped", "no collapse guard"},
       nothing,
       nothing,
       [](auto& p) {
         p.contact_time = 0;
         for (Surface& surface : p.surfaces) surface.normal.reference_speed = 0;
       }},
      {{"gravity-plus-1-percent", "gravity 1% too strong"},
       nothing,
       nothing,
       [](auto& p) { p.gravity *= 1.01; }},
      {{"wall-restitution-plus-2-percent", "restitution of walls and obstacles 2% too large, at most 1"},
       nothing,
       nothing,
       [](auto& p) { p.agent_faults.restitution = 1.02; }},
      {{"gravity-reversed", "gravity with the wrong sign"},
       nothing,
       nothing,
       [](auto& p) { p.gravity = -p.gravity; }},
      {{"obstacle-radius-plus-2-percent", "obstacles 2% too large"},
       nothing,
       nothing,
       [](auto& p) { p.agent_faults.obstacle_radius = 1.02; }},
      {{"wall-temperature-plus-20-percent", "thermal walls and obstacles at 1.2 times their temperature"},
       nothing,
       nothing,
       [](auto& p) { p.agent_faults.temperature = 1.2; }},
      {{"bounce-back-probability-ignored", "every particle bounces back"},
       nothing,
       nothing,
       [](auto& p) { p.agent_faults.probability_ignored = true; }},
      {{"wall-velocity-dropped", "walls stand still, their vibration aside"},
       nothing,
       nothing,
       [](auto& p) { p.agent_faults.velocity_dropped = true; }},
      {{"friction-dropped", "rough contacts always stick"},
       nothing,
       nothing,
       [](auto& p) {
         for (Surface& surface : p.surfaces) surface.friction = std::numeric_limits<double>::infinity();
       }},
      {{"tangential-restitution-flipped", "tangential restitution with the wrong sign"},
       nothing,
       nothing,
       [](auto& p) {
         for (Surface& surface : p.surfaces) surface.tangential = -surface.tangential;
       }},
  };
  return all;
}

const Plant* find(const Mutation& mutation) {
  if (mutation.name.empty()) return nullptr;
  std::vector<std::string> names;
  for (const Plant& plant : plants()) {
    if (plant.info.name == mutation.name) return &plant;
    names.push_back(plant.info.name);
  }
  throw InputError(unknown_word("mutation", mutation.name, names));
}

}  // namespace

const std::vector<MutationInfo>& mutations() {
  static const std::vector<MutationInfo> all = [] {
    std::vector<MutationInfo> infos;
    for (const Plant& plant : plants()) infos.push_back(plant.info);
    return infos;
  }();
  return all;
}

void plant(const Mutation& mutation, int dimension, dsmc::Parameters& parameters) {
  if (const Plant* found = find(mutation)) found->dsmc(parameters, dimension);
}

void plant(const Mutation& mutation, reservoir::Faults& faults) {
  if (const Plant* found = find(mutation)) found->reservoir(faults);
}

void plant(const Mutation& mutation, event_driven::Parameters<2>& parameters) {
  if (const Plant* found = find(mutation)) found->hard.disks(parameters);
}

void plant(const Mutation& mutation, event_driven::Parameters<3>& parameters) {
  if (const Plant* found = find(mutation)) found->hard.spheres(parameters);
}

}  // namespace sandglass
