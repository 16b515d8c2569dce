#pragma once

#include "sim/scene/scene.hpp"
#include "validation/suite/case.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sandglass {

/// One run of the matrix: a scene and the checks that its record will face. Keeps pointers into the case.
struct Task {
  const Case* subject = nullptr;
  std::string variant, point;
  Scene scene;
  std::vector<const CheckUse*> checks;
};

/// Every run of a case in a tier; of one variant only when `variant` is not empty. Throws InputError for a
/// scene that cannot be, placed in case.toml or scene.toml.
std::vector<Task> expand(const Case& subject, const std::string& tier, const std::string& variant);

/// The scene of one point and variant in a tier, with one more override on top.
Scene scene_of(const Case& subject, const std::string& tier, const std::string& variant,
               const std::string& point, const Override& on_top);

/// A seed that differs for each `name` and each `seed`; below 2^63, as TOML needs.
std::uint64_t derived_seed(std::uint64_t seed, const std::string& name);

}  // namespace sandglass
