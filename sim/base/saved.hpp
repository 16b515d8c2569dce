#pragma once

#include <cmath>
#include <cstdint>
#include <string>

// Numbers of a checkpoint on their way back into a run. Its checksums say that nobody has changed it by accident.

namespace sandglass {

/// Throws InputError: `what` is a number that no run leaves behind.
[[noreturn]] void refuse_saved(const std::string& what);

inline double saved_number(double number, double low, double high, const char* what) {
  if (!(number >= low && number <= high)) refuse_saved(what);  // not a number either
  return number;
}

/// A whole number from 0 to 2^53, up to which a double holds every one of them; or to `most`.
inline std::uint64_t saved_count(double number, const char* what = "a count", double most = 0x1p53) {
  if (!(number >= 0 && number <= most && number == std::floor(number))) refuse_saved(what);
  return static_cast<std::uint64_t>(number);
}

}  // namespace sandglass
