#pragma once

#include "sim/method/event_driven/parameters.hpp"
#include "sim/method/planted_fault.hpp"

namespace sandglass::event_driven {

/// The same change for disks and for spheres.
struct FaultChange {
  void (*disks)(Parameters<2>&);
  void (*spheres)(Parameters<3>&);
  template <class Change>
  FaultChange(Change change) : disks(change), spheres(change) {}  // NOLINT: a lambda in the table is one
  void operator()(Parameters<2>& parameters) const { disks(parameters); }
  void operator()(Parameters<3>& parameters) const { spheres(parameters); }
};

const std::vector<FaultEntry<FaultChange>>& planted_faults();

}  // namespace sandglass::event_driven
