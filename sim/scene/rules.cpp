#include "sim/scene/rules.hpp"

#include "sim/scene/text/bounds.hpp"

#include <algorithm>
#include <vector>

namespace sandglass {

namespace {
struct Rule {
  std::vector<std::string> rests_on;  ///< paths that must be free of errors for the rule to make sense
  void (*check)(const Scene&, Diagnostics&);
};

const std::vector<Rule>& all_rules() {
  static const std::vector<Rule> rules = {
      {{}, check_run},
      {{"domain.dimension"}, check_domain},
      {{}, check_species},
      {{}, check_method},
      {{"run.duration", "method.time-step"}, check_steps},
      {{"domain"}, check_walls},
      {{"domain"}, check_obstacles},
      {{"method.preset"}, check_family},
      {{"method.preset"}, check_capabilities},
      {{"domain", "method.preset"}, check_given},
      {{"species", "wall", "obstacle"}, check_spins},
      {{"domain", "species", "method", "particle"}, check_packing},
      {{"domain.dimension", "forces"}, check_gravity},
      {{"domain", "source"}, check_sources},
      {{"domain", "species", "obstacle", "inflow"}, check_inflows},
      {{"domain", "species", "obstacle", "outflow"}, check_outflows},
      {{"domain", "species", "method", "source"}, check_regions},
      {{"domain", "species", "method"}, check_step_of_empty_box},
      {{"domain.dimension"}, check_initial},
      {{"domain", "species", "method", "initial.positions"}, check_overlap},
      {{"domain.dimension", "domain.size"}, check_observers},
  };
  return rules;
}
}  // namespace

void check_rules(const Scene& scene, Diagnostics& diagnostics) {
  for (const Rule& rule : all_rules()) {
    const auto clean = [&diagnostics](const std::string& path) { return diagnostics.clean(path); };
    if (std::all_of(rule.rests_on.begin(), rule.rests_on.end(), clean)) rule.check(scene, diagnostics);
  }
}

void validate(const Scene& scene) {
  Diagnostics diagnostics;
  check_rules(scene, diagnostics);
  diagnostics.raise();
}

std::string fraction_key(int dimension) { return dimension == 2 ? "area-fraction" : "volume-fraction"; }

}  // namespace sandglass
