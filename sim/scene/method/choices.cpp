#include "sim/scene/method/capabilities.hpp"

#include <algorithm>
#include <cmath>

// A choice is looked up by its name in the family's options: a new family that offers it is found without a word here.

namespace sandglass {

namespace {
template <class Value, class Get>
Value choice(const Method& method, Value absent, Get get) {
  return std::visit(
      [&](const auto& options) {
        if constexpr (std::is_invocable_v<Get, decltype(options)>)
          return Value(get(options));
        else
          return absent;
      },
      method.options);
}
}  // namespace

Guard guard_of(const Method& method) {
  const auto get = [](const auto& options) -> decltype(Guard(options.guard)) { return options.guard; };
  return choice(method, Guard{}, get);
}

bool loses_pairs(const Scene& scene) {
  const auto get = [](const auto& options) -> decltype(options.pair_count == PairCount::counted) {
    return options.offset != Offset::none && options.pair_count == PairCount::counted;
  };
  return choice(scene.method, false, get);
}

bool has_contact_factor(const Scene& scene) {
  const auto get = [](const auto& options) -> decltype(options.contact_factor == ContactFactor::local) {
    return options.contact_factor == ContactFactor::local;
  };
  return choice(scene.method, false, get);
}

std::vector<double> cells_along(const Scene& scene) {
  const auto given = [](const auto& options) -> decltype(options.cells) { return options.cells; };
  const auto size = [](const auto& options) -> decltype(options.cell_size) { return options.cell_size; };
  const std::vector<std::uint64_t> cells = choice(scene.method, std::vector<std::uint64_t>{}, given);
  const std::optional<double> edge = choice(scene.method, std::optional<double>{}, size);
  std::vector<double> numbers(cells.begin(), cells.end());
  return numbers.empty() && edge ? cells_of_edge(scene, *edge) : numbers;
}

bool has_full_cells(const Scene& scene) {
  const auto get = [](const auto& options) -> decltype(options.excluded_volume == ExcludedVolume::cells) {
    return options.excluded_volume == ExcludedVolume::cells;
  };
  return choice(scene.method, false, get);
}

bool has_diagonal_cells(const Scene& scene) {
  const auto get = [](const auto& options) -> decltype(options.lattice == CellLattice::diagonal) {
    return options.lattice == CellLattice::diagonal;
  };
  return choice(scene.method, false, get);
}

std::vector<double> cells_of_edge(const Scene& scene, double edge) {
  std::vector<double> numbers;
  const bool diagonal = has_diagonal_cells(scene);
  for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis) {
    const double exact = scene.domain.size[axis] / (diagonal ? M_SQRT2 * edge : edge);
    const bool even =
        has_full_cells(scene) && !diagonal && scene.domain.sides[axis][0] == Side::periodic && exact >= 1.5;
    numbers.push_back(std::max(1.0, even ? 2 * std::round(exact / 2) : std::round(exact)));
  }
  return numbers;
}

}  // namespace sandglass
