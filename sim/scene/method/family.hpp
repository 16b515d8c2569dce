#pragma once

#include "sim/scene/method/capabilities.hpp"
#include "sim/scene/observe/observers.hpp"
#include "sim/scene/scene.hpp"
#include "sim/scene/text/diagnostics.hpp"
#include "sim/scene/text/table.hpp"
#include "sim/scene/text/write_value.hpp"

namespace sandglass {

/// A method by its name, and the choices that the name stands for.
struct Preset : NamedSummary {
  MethodOptions options;
};

/// The keys of [method] that families have of their own, and why this family refuses those of another.
struct RefusedKeys {
  std::vector<std::string> keys;
  std::string reason;  ///< after "'method.key' "
};

/// What a family brings to the scene: its words, its keys and what it can do. What it brings to a run stands in
/// sim/method/<family>/family.cpp.
struct MethodFamily {
  std::string name;
  Capabilities can;
  std::vector<Preset> presets;
  std::vector<std::string> keys;  ///< of [method], beside those that every family takes
  std::vector<RefusedKeys> refused;
  /// Keys of other families with the one word that is true here too; records of version 0.1 name them.
  std::vector<std::pair<std::string, std::string>> neutral;
  void (*read)(Table& table, MethodOptions& options);
  void (*write)(Lines& lines, const MethodOptions& options);
  /// Rules on the values of its keys and on what they need of the rest of the scene.
  void (*check)(const Scene& scene, Diagnostics& diagnostics);
};

const std::vector<const MethodFamily*>& method_families();
const MethodFamily& family_of(const Method& method);

std::vector<std::string> preset_names();
std::vector<NamedSummary> preset_summaries();
/// Presets of the families that can do something, for messages: "'dsmc', 'cba' or 'event-driven'".
std::string presets_that(bool (*able)(const Capabilities&));

}  // namespace sandglass
