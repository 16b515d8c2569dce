#pragma once

#include "sim/scene/scene.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sandglass {

/// The words of a scene file for each value of an enumeration: one table for reader and writer.
template <class Value>
using Words = std::vector<std::pair<std::string, Value>>;

const Words<int>& axis_words();  ///< "x", "y", "z"
const Words<Side>& side_words();
const Words<ContactFactor>& contact_factor_words();
const Words<DensityEstimate>& density_words();
const Words<Offset>& offset_words();
const Words<CollapseGuard>& guard_words();
const Words<std::optional<Positions>>& positions_words();  ///< none: "given"
const Words<SurfaceKind>& surface_kind_words();
const Words<std::pair<int, bool>>& wall_side_words();  ///< "x-low": axis, high

template <class Value>
std::string word_of(const Words<Value>& words, Value value) {
  const auto match = [value](const auto& word) { return word.second == value; };
  const auto found = std::find_if(words.begin(), words.end(), match);
  return found == words.end() ? "" : found->first;
}

template <class Value>
std::vector<std::string> names_of(const Words<Value>& words) {
  std::vector<std::string> names;
  for (const auto& word : words) names.push_back(word.first);
  return names;
}

}  // namespace sandglass
