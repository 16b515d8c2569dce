#pragma once

#include <string>
#include <vector>

namespace sandglass {

/// A small wrong change of physics or numerics, planted on purpose to see whether a check catches it.
struct PlantedFault {
  std::string name;
  std::string summary;
};

/// One fault of a family, as a change of the parameters of its method.
template <class Change>
struct FaultEntry {
  PlantedFault fault;
  Change plant;
};

/// The faults of several lists.
template <class... Change>
std::vector<PlantedFault> names_of_faults(const std::vector<FaultEntry<Change>>&... lists) {
  std::vector<PlantedFault> faults;
  const auto append = [&faults](const auto& list) {
    for (const auto& entry : list) faults.push_back(entry.fault);
  };
  (append(lists), ...);
  return faults;
}

/// Changes what a method is made from, if the fault stands in this list.
template <class Change, class... Parts>
void plant(const std::vector<FaultEntry<Change>>& list, const std::string& name, Parts&&... parts) {
  for (const FaultEntry<Change>& entry : list)
    if (entry.fault.name == name) entry.plant(parts...);
}

}  // namespace sandglass
