#include "sim/space/cell_colours.hpp"

namespace sandglass {

namespace {
constexpr std::uint32_t kColours = 5;

/// Every third cell has the same colour; what is left over before a seam has colours of its own.
std::uint32_t colour_along(std::uint32_t place, std::uint32_t cells, bool periodic) {
  const std::uint32_t regular = periodic ? cells - cells % 3 : cells;
  return place < regular ? place % 3 : 3 + place - regular;
}
}  // namespace

template <int D>
std::vector<std::vector<std::uint32_t>> cell_colours(const Grid<D>& grid,
                                                     const std::array<bool, D>& periodic) {
  std::vector<std::vector<std::uint32_t>> colours(D == 2 ? kColours * kColours
                                                         : kColours * kColours * kColours);
  for (std::uint32_t cell = 0; cell < grid.size(); ++cell) {
    std::uint32_t colour = 0, rest = cell;
    for (int axis = 0; axis < D; ++axis) {
      const std::uint32_t cells = grid.cells(axis);
      colour =
          colour * kColours + colour_along(rest % cells, cells, periodic[static_cast<std::size_t>(axis)]);
      rest /= cells;
    }
    colours[colour].push_back(cell);
  }
  std::erase_if(colours, [](const auto& cells) { return cells.empty(); });
  return colours;
}

template std::vector<std::vector<std::uint32_t>> cell_colours<2>(const Grid<2>&, const std::array<bool, 2>&);
template std::vector<std::vector<std::uint32_t>> cell_colours<3>(const Grid<3>&, const std::array<bool, 3>&);

}  // namespace sandglass
