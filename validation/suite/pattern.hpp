#pragma once

#include <string>
#include <vector>

namespace sandglass {

/// Something that patterns can choose: a point or a variant, by its name or by one of its tags.
struct Choice {
  std::string name;
  std::vector<std::string> tags;
};

/// "nu-*-r-0.?": '*' stands for any characters, '?' for one.
bool matches(const std::string& pattern, const std::string& word);

/// A pattern without its '!', which takes away instead of choosing.
std::string wanted_part(const std::string& pattern);

/// The pattern, without its '!', matches the name or a tag.
bool speaks_of(const std::string& pattern, const Choice& choice);

/// One of the patterns matches and none of those that begin with '!' does. Without a pattern that chooses, all are.
bool chosen(const std::vector<std::string>& patterns, const Choice& choice);

/// The names of those chosen, in their order.
std::vector<std::string> choose(const std::vector<std::string>& patterns, const std::vector<Choice>& choices);

/// Names and tags, each once: what a pattern could have meant.
std::vector<std::string> words_of(const std::vector<Choice>& choices);

}  // namespace sandglass
