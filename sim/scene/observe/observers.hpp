#pragma once

#include <string>
#include <vector>

namespace sandglass {

struct NamedSummary {
  std::string name;
  std::string summary;
};

/// What an observer needs of the rest of the scene.
enum class ObserverSetting {
  particles,  ///< particles in a box
  contacts,   ///< a method whose particles touch
  spins,      ///< particles whose spin changes
  periodic,   ///< a domain that is periodic along every axis
  bounded,    ///< an axis that is not periodic
  mixture,    ///< several species
  regions,    ///< regions of other weights
  plane,      ///< no particles in a box, only those that pass a plane
};

/// What can be observed, and the keys of [[observe]] beside `what` and `every` that it uses.
struct ObserverKind : NamedSummary {
  std::vector<std::string> keys;
  ObserverSetting needs = ObserverSetting::particles;
};

const std::vector<ObserverKind>& observer_kinds();
std::vector<std::string> observer_names();
std::vector<NamedSummary> observer_summaries();

/// The observer of that name, or nullptr.
const ObserverKind* find_observer(const std::string& name);
/// Whether the observer `what` uses the key; false for an unknown observer.
bool observer_uses(const std::string& what, const std::string& key);
/// Whether its range is one of distances between two particles.
bool observes_distances(const std::string& what);

}  // namespace sandglass
