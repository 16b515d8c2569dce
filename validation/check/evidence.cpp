#include "validation/check/evidence.hpp"

#include <array>

#include <fmt/format.h>

namespace sandglass {

std::string to_string(Expectation kind) {
  static const std::array<const char*, 4> names{"equal", "at-least", "at-most", "between"};
  return names.at(static_cast<std::size_t>(kind));
}

std::string expectation_text(const Evidence& evidence) {
  switch (evidence.kind) {
    case Expectation::equal:
      return fmt::format("{:.6g}", evidence.expected);
    case Expectation::at_least:
      return fmt::format("at least {:.6g}", evidence.expected);
    case Expectation::at_most:
      return fmt::format("at most {:.6g}", evidence.expected);
    case Expectation::between:
      return fmt::format("{:.6g} to {:.6g}", evidence.expected, evidence.upper);
  }
  return "";
}

}  // namespace sandglass
