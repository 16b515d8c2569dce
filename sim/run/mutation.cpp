#include "sim/run/mutation.hpp"

#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"

#include <algorithm>

namespace sandglass {

namespace {

/// A planted fault as a change of what the methods are told.
struct Plant {
  MutationInfo info;
  void (*dsmc)(dsmc::Parameters&, int dimension);
  void (*reservoir)(reservoir::Faults&);
};

void nothing(dsmc::Parameters&, int) {}
void nothing(reservoir::Faults&) {}

using P = dsmc::Parameters&;
using R = reservoir::Faults&;

const std::vector<Plant>& plants() {
  static const std::vector<Plant> all = {
      {{"cross-section-plus-5-percent", "cross-section 5% too large"},
       [](P p, int) { p.cross_section *= 1.05; },
       nothing},
      {{"restitution-plus-2-percent", "restitution 2% too large, at most 1"},
       [](P p, int) { p.restitution = std::min(1.0, 1.02 * p.restitution); },
       nothing},
      {{"restitution-minus-2-percent", "restitution 2% too small"},
       [](P p, int) { p.restitution *= 0.98; },
       nothing},
      {{"acceptance-inverted", "pairs refused that should collide and the other way round"},
       [](P p, int) { p.faults.acceptance_inverted = true; },
       nothing},
      {{"fraction-truncated", "fractional candidate dropped"},
       [](P p, int) { p.faults.fraction_truncated = true; },
       nothing},
      {{"bound-halved", "bound on relative speeds half of what it must be"},
       [](P p, int) { p.faults.bound = 0.5; },
       nothing},
      {{"momentum-leak", "second partner's kick a millionth short"},
       [](P p, int) { p.faults.momentum_leak = 1e-6; },
       nothing},
      {{"impact-parameter-central", "impact parameters 10% too small"},
       [](P p, int) { p.faults.impact = 0.9; },
       nothing},
      {{"offset-dropped", "no displacement after collisions"}, [](P p, int) { p.offset = {}; }, nothing},
      {{"offset-doubled", "displacement after collisions twice as long"},
       [](P p, int) { p.offset.consistent *= 2; },
       nothing},
      {{"contact-factor-dropped", "contact factor left out"},
       [](P p, int) { p.factor.formula = nullptr; },
       nothing},
      {{"contact-factor-of-other-dimension", "contact factor of spheres for disks and of disks for spheres"},
       [](P p, int dimension) { p.factor.formula = contact_formula(dimension == 2 ? 3 : 2); },
       nothing},
      {{"density-from-cell-count", "contact factor from the cell's own count"},
       [](P p, int) { p.factor.smoothed = false; },
       nothing},
      {{"crossing-velocity-maxwellian",
        "crossing velocities from the Maxwellian instead of the flux distribution"},
       nothing,
       [](R r) { r.maxwellian = true; }},
      {{"flux-rate-net", "crossings at the net rate in both directions"},
       nothing,
       [](R r) { r.net_rate = true; }},
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

}  // namespace sandglass
