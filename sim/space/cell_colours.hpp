#pragma once

#include "sim/space/grid.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace sandglass {

/// Cells by colours such that the surroundings (the cell and all that touch it, across periodic edges too) of two cells of
/// one colour have no cell in common: work that reads and writes the surroundings of a cell may take the cells of a colour
/// in any order. Three colours along a walled axis, up to five along a periodic one.
template <int D>
std::vector<std::vector<std::uint32_t>> cell_colours(const Grid<D>& grid,
                                                     const std::array<bool, D>& periodic);

extern template std::vector<std::vector<std::uint32_t>> cell_colours<2>(const Grid<2>&,
                                                                        const std::array<bool, 2>&);
extern template std::vector<std::vector<std::uint32_t>> cell_colours<3>(const Grid<3>&,
                                                                        const std::array<bool, 3>&);

}  // namespace sandglass
