#include "sim/base/spelling.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace sandglass {

namespace {
char lower(char letter) { return static_cast<char>(std::tolower(static_cast<unsigned char>(letter))); }

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (lower(a[i - 1]) != lower(b[j - 1]) ? 1u : 0u);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row[b.size()];
}
}  // namespace

std::string nearest_spelling(std::string_view word, const std::vector<std::string>& allowed) {
  std::string nearest;
  std::size_t least = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : allowed) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string list_words(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += "'" + words[i] + "'";
  }
  return text;
}

std::string unknown_word(std::string_view kind, std::string_view word,
                         const std::vector<std::string>& allowed) {
  std::string text = "unknown " + std::string(kind) + " '" + std::string(word) + "'";
  if (const std::string nearest = nearest_spelling(word, allowed); !nearest.empty())
    text += "; did you mean '" + nearest + "'?";
  return text + (text.back() == '?' ? " allowed: " : "; allowed: ") + list_words(allowed);
}

}  // namespace sandglass
