#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sandglass {

/// The allowed word nearest to `word` (Levenshtein distance whatever the case, at most a third of its length), or "".
std::string nearest_spelling(std::string_view word, const std::vector<std::string>& allowed);

/// "'a', 'b' or 'c'"
std::string list_words(const std::vector<std::string>& words);

/// "unknown <kind> 'word'; did you mean 'x'? allowed: ..."
std::string unknown_word(std::string_view kind, std::string_view word,
                         const std::vector<std::string>& allowed);

}  // namespace sandglass
