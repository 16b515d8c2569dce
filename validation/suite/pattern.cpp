#include "validation/suite/pattern.hpp"

#include <algorithm>
#include <string_view>

namespace sandglass {

namespace {
bool matches_from(std::string_view pattern, std::string_view word) {
  if (pattern.empty()) return word.empty();
  if (pattern.front() == '*')
    return matches_from(pattern.substr(1), word) || (!word.empty() && matches_from(pattern, word.substr(1)));
  if (word.empty() || (pattern.front() != '?' && pattern.front() != word.front())) return false;
  return matches_from(pattern.substr(1), word.substr(1));
}

bool excludes(const std::string& pattern) { return pattern.starts_with('!'); }
}  // namespace

bool matches(const std::string& pattern, const std::string& word) { return matches_from(pattern, word); }

std::string wanted_part(const std::string& pattern) {
  return excludes(pattern) ? pattern.substr(1) : pattern;
}

bool speaks_of(const std::string& pattern, const Choice& choice) {
  const std::string plain = wanted_part(pattern);
  return matches(plain, choice.name) ||
         std::ranges::any_of(choice.tags, [&](const std::string& tag) { return matches(plain, tag); });
}

bool chosen(const std::vector<std::string>& patterns, const Choice& choice) {
  bool wanted = std::ranges::all_of(patterns, excludes);
  for (const std::string& pattern : patterns) {
    if (!speaks_of(pattern, choice)) continue;
    if (excludes(pattern)) return false;
    wanted = true;
  }
  return wanted;
}

std::vector<std::string> choose(const std::vector<std::string>& patterns,
                                const std::vector<Choice>& choices) {
  std::vector<std::string> names;
  for (const Choice& choice : choices)
    if (chosen(patterns, choice)) names.push_back(choice.name);
  return names;
}

std::vector<std::string> words_of(const std::vector<Choice>& choices) {
  std::vector<std::string> words;
  const auto add = [&words](const std::string& word) {
    if (std::ranges::find(words, word) == words.end()) words.push_back(word);
  };
  for (const Choice& choice : choices) add(choice.name);
  for (const Choice& choice : choices) std::ranges::for_each(choice.tags, add);
  return words;
}

}  // namespace sandglass
