#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"
#include "sim/scene/method/family.hpp"

#include <algorithm>

namespace sandglass {

// One for each alternative of MethodOptions, in a file of its own.
const MethodFamily& dsmc_family();
const MethodFamily& event_driven_family();
const MethodFamily& reservoir_family();
const MethodFamily& collisionless_family();
const MethodFamily& mixing_family();

/// In the order of the alternatives of MethodOptions.
const std::vector<const MethodFamily*>& method_families() {
  static const std::vector<const MethodFamily*> all = {
      &dsmc_family(), &event_driven_family(), &reservoir_family(), &collisionless_family(), &mixing_family()};
  return all;
}

const MethodFamily& family_of(const Method& method) { return *method_families()[method.options.index()]; }

const Capabilities& capabilities(const Scene& scene) { return family_of(scene.method).can; }

void choose(Method& method, const std::string& preset) {
  for (const MethodFamily* family : method_families())
    for (const Preset& candidate : family->presets)
      if (candidate.name == preset) {
        method.preset = preset;
        method.options = candidate.options;
        return;
      }
  throw InputError(unknown_word("preset", preset, preset_names()));
}

std::vector<NamedSummary> preset_summaries() {
  std::vector<NamedSummary> list;
  for (const MethodFamily* family : method_families())
    list.insert(list.end(), family->presets.begin(), family->presets.end());
  return list;
}

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const NamedSummary& preset : preset_summaries()) names.push_back(preset.name);
  return names;
}

std::string presets_that(bool (*able)(const Capabilities&)) {
  std::vector<std::string> names;
  for (const MethodFamily* family : method_families())
    if (able(family->can))
      for (const Preset& preset : family->presets) names.push_back(preset.name);
  return list_words(names);
}

}  // namespace sandglass
