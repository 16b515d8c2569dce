#include "sim/scene/observe/observers.hpp"

#include <algorithm>

namespace sandglass {

namespace {
template <class Entry>
std::vector<std::string> names(const std::vector<Entry>& entries) {
  std::vector<std::string> list;
  for (const Entry& entry : entries) list.push_back(entry.name);
  return list;
}

template <class Entry>
std::vector<NamedSummary> summaries(const std::vector<Entry>& entries) {
  return {entries.begin(), entries.end()};
}

template <class Entry>
const Entry* find(const std::vector<Entry>& entries, const std::string& name) {
  const auto match = [&name](const Entry& entry) { return entry.name == name; };
  const auto found = std::find_if(entries.begin(), entries.end(), match);
  return found == entries.end() ? nullptr : &*found;
}
}  // namespace

const std::vector<ObserverKind>& observer_kinds() {
  static const std::vector<ObserverKind> list = {
      {{"energy", "kinetic energy of all real particles"}, {}},
      {{"temperature", "granular temperature along each axis and their mean"}, {}},
      {{"momentum", "total momentum, and the sum of the magnitudes of all momenta"}, {}},
      {{"moments", "even velocity moments to order 8, relative to the second"}, {}},
      {{"velocity-histogram", "histogram of one velocity component over all particles"},
       {"axis", "range", "bins"}},
      {{"collisions", "collisions and candidates since time zero"}, {}},
      {{"cloning", "what crosses between regions, what its copies gain, and the variance that this adds"},
       {},
       ObserverSetting::regions},
      {{"pressure", "kinetic and collisional pressure"}, {}},
      {{"crossings", "normal velocities of the particles that cross a plane, and how many each way"},
       {"axis", "position", "range", "bins"},
       ObserverSetting::plane},
      {{"fields", "number density, mean velocity and granular temperature on a grid of bins"}, {"grid"}},
      {{"energy-flux", "flux of the kinetic energy that particles carry, on a grid of bins"}, {"grid"}},
      {{"species-density", "number density of each species on a grid of bins"}, {"grid"}},
      {{"shear-mode", "amplitude of the velocity along x as a sine of y"}, {}},
      {{"rotational-energy", "rotational energy of all particles, and their rotational granular temperature"},
       {},
       ObserverSetting::spins},
      {{"spin-temperature", "rotational granular temperature on a grid of bins"},
       {"grid"},
       ObserverSetting::spins},
      {{"species", "granular temperature of each species, and collisions by pair of species"},
       {},
       ObserverSetting::mixture},
      {{"impact-parameter",
        "histogram of the impact parameter of the collisions, in units of the contact distance"},
       {"bins"},
       ObserverSetting::contacts},
      {{"overlap", "deepest overlap met so far at a collision, in diameters"}, {}, ObserverSetting::contacts},
      {{"pair-correlation", "pair correlation g(r) over the distance of two particles"},
       {"range", "bins"},
       ObserverSetting::periodic},
      {{"pair-velocity", "correlation of the velocities of two particles over their distance"},
       {"range", "bins"},
       ObserverSetting::periodic},
      {{"structure-factor", "structure factor S(k) over the magnitude of the wave vector"},
       {"grid", "bins"},
       ObserverSetting::periodic},
      {{"centre-of-mass", "position of the centre of mass along each axis that is not periodic"},
       {},
       ObserverSetting::bounded},
      {{"wall-force",
        "force of the particles on each wall, power that each wall gives them, heat that it takes"},
       {},
       ObserverSetting::bounded},
      {{"free-surface",
        "largest coordinate along an axis over each bin of the others: the surface of a heap"},
       {"axis", "grid"}},
      {{"kinetic-stress", "kinetic part of the pressure tensor on a grid of bins"}, {"grid"}},
      {{"two-fluids",
        "density on a grid of bins and mean place of the first species and of all others, and their mixing "
        "index"},
       {"grid"}}};
  return list;
}

std::vector<std::string> observer_names() { return names(observer_kinds()); }
std::vector<NamedSummary> observer_summaries() { return summaries(observer_kinds()); }

const ObserverKind* find_observer(const std::string& name) { return find(observer_kinds(), name); }

bool observer_uses(const std::string& what, const std::string& key) {
  const ObserverKind* kind = find_observer(what);
  return kind && std::count(kind->keys.begin(), kind->keys.end(), key) > 0;
}

bool observes_distances(const std::string& what) {
  return what == "pair-correlation" || what == "pair-velocity";
}

}  // namespace sandglass
