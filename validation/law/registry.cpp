#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"
#include "validation/law/catalogue.hpp"

#include <algorithm>

namespace sandglass::law {

namespace {
std::vector<Law> collect() {
  std::vector<Law> laws;
  for (auto topic :
       {equilibrium_laws,  reference_laws,     cooling_laws,  guarded_laws,        velocity_laws,
        flux_laws,         transport_laws,     few_body_laws, free_molecular_laws, sedimentation_laws,
        diffuse_wall_laws, uniform_shear_laws, heap_laws,     falling_laws,        vibrated_bed_laws,
        fluctuation_laws,  impact_laws,        rough_laws,    mixture_laws,        mixing_laws,
        channel_laws})
    for (Law& law : topic()) laws.push_back(std::move(law));
  return laws;
}
}  // namespace

const std::vector<Law>& all_laws() {
  static const std::vector<Law> laws = collect();
  return laws;
}

const Law& find_law(const std::string& name) {
  const std::vector<Law>& laws = all_laws();
  const auto found = std::find_if(laws.begin(), laws.end(), [&](const Law& law) { return law.name == name; });
  if (found != laws.end()) return *found;
  std::vector<std::string> names;
  for (const Law& law : laws) names.push_back(law.name);
  throw InputError(unknown_word("law", name, names));
}

}  // namespace sandglass::law
