#include "sim/scene/catalogue.hpp"

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

const std::vector<Preset>& presets() {
  static const std::vector<Preset> list = {
      {{"dsmc", "dilute gas: point-like collisions inside a cell"}, ContactFactor::none, Offset::none},
      {{"dsmc-enskog", "collision rate raised by the contact value of the local density, no offset"},
       ContactFactor::local,
       Offset::none},
      {{"cba", "consistent Boltzmann algorithm: contact value, and each partner displaced by one diameter"},
       ContactFactor::local,
       Offset::consistent},
      {{"cba-corrected",
        "cba with the displacement that gives the hard-core virial for restitution below one"},
       ContactFactor::local,
       Offset::corrected},
      {{"cuba", "cba with a further random displacement of zero mean that tunes transport"},
       ContactFactor::local,
       Offset::random},
      {{reservoir_preset,
        "no box: velocities of an ideal-gas stream through a plane, from the flux distribution"},
       ContactFactor::none,
       Offset::none},
      {{event_driven_preset, "exact event-driven hard disks and spheres"},
       ContactFactor::none,
       Offset::none}};
  return list;
}

const std::vector<ObserverKind>& observer_kinds() {
  static const std::vector<ObserverKind> list = {
      {{"energy", "kinetic energy of all real particles"}, {}},
      {{"temperature", "granular temperature along each axis and their mean"}, {}},
      {{"momentum", "total momentum, and the sum of the magnitudes of all momenta"}, {}},
      {{"moments", "even velocity moments to order 8, relative to the second"}, {}},
      {{"velocity-histogram", "histogram of one velocity component over all particles"},
       {"axis", "range", "bins"}},
      {{"collisions", "collisions and tried pairs since time zero"}, {}},
      {{"pressure", "kinetic and collisional pressure"}, {}},
      {{"crossings", "normal velocities of the particles that cross a plane, and how many each way"},
       {"axis", "position", "range", "bins"}},
      {{"fields", "number density, mean velocity and granular temperature on a grid of bins"}, {"grid"}},
      {{"shear-mode", "amplitude of the velocity along x as a sine of y"}, {}},
      {{"rotational-energy", "rotational energy of all particles, and their rotational granular temperature"},
       {},
       false,
       true},
      {{"impact-parameter",
        "histogram of the impact parameter of the collisions, in units of the contact distance"},
       {"bins"},
       true},
      {{"overlap", "deepest overlap met so far at a collision, in diameters"}, {}, true},
      {{pair_correlation, "pair correlation g(r) over the distance of two particles"},
       {"range", "bins"},
       false,
       false,
       true},
      {{"structure-factor", "structure factor S(k) over the magnitude of the wave vector"},
       {"grid", "bins"},
       false,
       false,
       true}};
  return list;
}

std::vector<std::string> preset_names() { return names(presets()); }
std::vector<std::string> observer_names() { return names(observer_kinds()); }
std::vector<NamedSummary> preset_summaries() { return summaries(presets()); }
std::vector<NamedSummary> observer_summaries() { return summaries(observer_kinds()); }

const Preset* find_preset(const std::string& name) { return find(presets(), name); }
const ObserverKind* find_observer(const std::string& name) { return find(observer_kinds(), name); }

bool observer_uses(const std::string& what, const std::string& key) {
  const ObserverKind* kind = find_observer(what);
  return kind && std::count(kind->keys.begin(), kind->keys.end(), key) > 0;
}

}  // namespace sandglass
