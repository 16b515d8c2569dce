#include "sim/observe/shells.hpp"

#include "sim/base/error.hpp"

#include <fmt/format.h>

namespace sandglass {

Shells::Shells(const ObserverSpec& spec)
    : what_(spec.what),
      range_(spec.range),
      bins_(spec.bins),
      per_length_(static_cast<double>(spec.bins) / (spec.range[1] - spec.range[0])) {
  const auto [low, high] = range_;
  if (!(low >= 0 && low < high && std::isfinite(high)))
    throw InputError(
        fmt::format("'observe.range' of the observer '{}' goes from {} to {}; give two rising distances, the "
                    "first not below 0",
                    what_, low, high));
}

void Shells::require(std::size_t particles, bool weighted, double most) const {
  if (particles < 2)
    throw InputError(
        fmt::format("the observer '{}' needs at least 2 particles; remove it, or add particles", what_));
  if (weighted)
    throw InputError(
        fmt::format("the observer '{}' counts particles, and here each stands for another number of real "
                    "ones; remove it",
                    what_));
  if (range_[1] > most)
    throw InputError(
        fmt::format("'observe.range' of the observer '{}' goes to {}; at most half the shortest edge of the "
                    "domain, {}, is allowed",
                    what_, range_[1], most));
}

}  // namespace sandglass
