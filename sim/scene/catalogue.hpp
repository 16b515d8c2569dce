#pragma once

#include "sim/scene/scene.hpp"

#include <string>
#include <vector>

namespace sandglass {

struct NamedSummary {
  std::string name;
  std::string summary;
};

/// A method by its name, and the choices that the name stands for.
struct Preset : NamedSummary {
  ContactFactor contact_factor;
  Offset offset;
};

/// What can be observed, and the keys of [[observe]] beside `what` and `every` that it uses.
struct ObserverKind : NamedSummary {
  std::vector<std::string> keys;
  bool event_driven_only = false;
  bool rough_only = false;     ///< needs particles whose spin changes
  bool periodic_only = false;  ///< needs a domain that is periodic along every axis
};

/// Length of the random offset, in diameters, of a scene that asks for one without saying how long.
inline constexpr double default_random_offset = 0.5;
/// The preset that draws from the flux distribution and has no particles in a box.
inline const std::string reservoir_preset = "reservoir";
/// The preset that moves hard disks and spheres from event to event.
inline const std::string event_driven_preset = "event-driven";
/// The observer whose range is one of distances.
inline const std::string pair_correlation = "pair-correlation";

const std::vector<Preset>& presets();
const std::vector<ObserverKind>& observer_kinds();
std::vector<std::string> preset_names();
std::vector<std::string> observer_names();
std::vector<NamedSummary> preset_summaries();
std::vector<NamedSummary> observer_summaries();

/// The preset of that name, or nullptr.
const Preset* find_preset(const std::string& name);
/// The observer of that name, or nullptr.
const ObserverKind* find_observer(const std::string& name);
/// Whether the observer `what` uses the key; false for an unknown observer.
bool observer_uses(const std::string& what, const std::string& key);

}  // namespace sandglass
