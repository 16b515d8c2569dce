#pragma once

#include <cstddef>

namespace sandglass {

/// Where the sums of Tally::cloning stand: for who comes into a region of lower weight (cloned) and of higher weight
/// (removed, or kept with more weight), over mass, momentum along each axis and kinetic energy of real particles.
template <int D>
struct CloningSums {
  /// brought: |what| those who cross bring; gained: what copies and survivors have more than they; variance: of what is gained,
  /// the sum over crossings.
  enum Kind : std::size_t { brought, gained, variance };
  static constexpr std::size_t kAmounts = D + 2;
  static constexpr std::size_t kSize = 3 * 2 * kAmounts;

  static constexpr std::size_t place(Kind kind, bool removed, std::size_t amount) {
    return (2 * kind + removed) * kAmounts + amount;
  }
};

}  // namespace sandglass
