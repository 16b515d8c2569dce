#pragma once

#include <string>
#include <vector>

namespace sandglass {

struct NamedSummary {
  std::string name;
  std::string summary;
};

/// What can be observed, and the keys of [[observe]] beside `what` and `every` that it uses.
struct ObserverKind : NamedSummary {
  std::vector<std::string> keys;
  bool contacts_only = false;     ///< needs a method whose particles touch
  bool rough_only = false;        ///< needs particles whose spin changes
  bool periodic_only = false;     ///< needs a domain that is periodic along every axis
  bool counts_crossings = false;  ///< needs no particles in a box, only those that pass a plane
};

/// The observer whose range is one of distances.
inline const std::string pair_correlation = "pair-correlation";

const std::vector<ObserverKind>& observer_kinds();
std::vector<std::string> observer_names();
std::vector<NamedSummary> observer_summaries();

/// The observer of that name, or nullptr.
const ObserverKind* find_observer(const std::string& name);
/// Whether the observer `what` uses the key; false for an unknown observer.
bool observer_uses(const std::string& what, const std::string& key);

}  // namespace sandglass
