#pragma once

#include "sim/scene/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sandglass {

/// Not those of run, observers and output, nor names.
bool reaches_method(const std::string& key);

/// Keys of a scene that reach a method, as it is written: "species.restitution", the same for all tables of a list.
std::vector<std::string> method_keys(const Scene& scene);

/// A scene in which a key is wired wrongly: how, and the scene that the method then sees.
struct Miswired {
  std::string how;  ///< "5% more"
  Scene scene;
};

/// All numbers of the key 5% larger, or smaller where a scene cannot have that; nothing where it holds no number but zero or
/// neither can be.
std::optional<Miswired> scaled_key(const Scene& scene, const std::string& key);

/// The key left out; nothing where the scene needs it or is the same without.
std::optional<Miswired> dropped_key(const Scene& scene, const std::string& key);

/// Whether the scene is the same without the key.
bool is_default(const Scene& scene, const std::string& key);

}  // namespace sandglass
