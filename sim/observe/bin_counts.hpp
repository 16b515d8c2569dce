#pragma once

#include "sim/observe/lattice.hpp"
#include "sim/observe/population.hpp"

#include <vector>

namespace sandglass {

/// Sum of `amount(i)` over the particles of each kind in each bin, [bin * kinds + kind]; `kind(i)` is below `kinds`.
template <int D, class Kind, class Amount>
std::vector<double> sums_by_bin(const View<D>& view, const Lattice<D>& bins, std::size_t kinds, Kind kind,
                                Amount amount) {
  std::vector<double> sums(bins.size() * kinds);
  for (std::uint32_t i = 0; i < view.particles.size(); ++i)
    sums[bins.bin_of(view.particles[i].position, view.box) * kinds + kind(i)] += amount(i);
  return sums;
}

/// Number density of the real particles of each kind in each bin, in the same order; `kind_of` a species.
template <int D, class KindOf>
std::vector<double> densities_by_bin(const View<D>& view, const Lattice<D>& bins, std::size_t kinds,
                                     KindOf kind_of) {
  return with_population(view, [&](const auto& all) {
    std::vector<double> density = sums_by_bin(
        view, bins, kinds, [&](std::uint32_t i) { return kind_of(all.index(i)); }, all.weight);
    const double unit = all.weight.unit * static_cast<double>(bins.size()) / view.box.prod();
    for (double& value : density) value *= unit;
    return density;
  });
}

}  // namespace sandglass
