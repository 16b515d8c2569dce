#include "sim/run/families.hpp"

#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"
#include "sim/method/collisionless/family.hpp"
#include "sim/method/dsmc/family.hpp"
#include "sim/method/event_driven/family.hpp"
#include "sim/method/mixing/family.hpp"
#include "sim/method/reservoir/family.hpp"
#include "sim/run/run.hpp"

#include <algorithm>

namespace sandglass {

const std::vector<const FamilyBuilder*>& family_builders() {
  static const std::vector<const FamilyBuilder*> all = {&dsmc::family(), &event_driven::family(),
                                                        &reservoir::family(), &collisionless::family(),
                                                        &mixing::family()};
  return all;
}

namespace {
const FamilyBuilder& family_called(const std::string& name) {
  const auto match = [&name](const FamilyBuilder* family) { return family->name == name; };
  const auto found = std::find_if(family_builders().begin(), family_builders().end(), match);
  if (found == family_builders().end()) throw InputError("no run can be built for the family '" + name + "'");
  return **found;
}
}  // namespace

const std::vector<PlantedFault>& planted_faults(const std::string& family) {
  return family_called(family).faults;
}

const std::vector<PlantedFault>& planted_faults() {
  static const std::vector<PlantedFault> all = [] {
    std::vector<PlantedFault> faults;
    for (const FamilyBuilder* family : family_builders())
      for (const PlantedFault& fault : family->faults) {
        const auto same = [&fault](const PlantedFault& other) { return other.name == fault.name; };
        if (std::none_of(faults.begin(), faults.end(), same)) faults.push_back(fault);
      }
    return faults;
  }();
  return all;
}

namespace {
/// Throws InputError for a fault that the family does not know: planting nothing would pass for a fault unseen.
const FamilyBuilder& family_for(const BuildRequest& request) {
  const FamilyBuilder& family = family_called(method_family(request.scene));
  std::vector<std::string> names{""};
  for (const PlantedFault& fault : family.faults) names.push_back(fault.name);
  if (std::find(names.begin(), names.end(), request.fault) == names.end())
    throw InputError(unknown_word("planted fault of the family '" + family.name + "'", request.fault,
                                  {names.begin() + 1, names.end()}));
  return family;
}
}  // namespace

template <>
std::unique_ptr<MethodBuilder<2>> make_builder(const BuildRequest& request) {
  return family_for(request).disks(request);
}

template <>
std::unique_ptr<MethodBuilder<3>> make_builder(const BuildRequest& request) {
  return family_for(request).spheres(request);
}

}  // namespace sandglass
