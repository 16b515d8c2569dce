#pragma once

#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"

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

template <class Change>
std::vector<PlantedFault> names_of_faults(const std::vector<FaultEntry<Change>>& entries) {
  std::vector<PlantedFault> faults;
  for (const FaultEntry<Change>& entry : entries) faults.push_back(entry.fault);
  return faults;
}

/// The change behind a name; null for the empty name, the honest program. Throws InputError for a fault that the
/// family does not know.
template <class Change>
const Change* find_fault(const std::vector<FaultEntry<Change>>& entries, const std::string& family,
                         const std::string& name) {
  if (name.empty()) return nullptr;
  std::vector<std::string> names;
  for (const FaultEntry<Change>& entry : entries) {
    if (entry.fault.name == name) return &entry.plant;
    names.push_back(entry.fault.name);
  }
  throw InputError(unknown_word("planted fault of the family '" + family + "'", name, names));
}

}  // namespace sandglass
