#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace sandglass {

/// The words of a scene file for each value of an enumeration: one table for reader and writer.
template <class Value>
using Words = std::vector<std::pair<std::string, Value>>;

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
