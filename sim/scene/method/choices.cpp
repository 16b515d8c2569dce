#include "sim/scene/method/capabilities.hpp"
#include "sim/scene/method/guard.hpp"

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

void set_guard(Method& method, const Guard& guard) {
  const auto set = [&guard](auto& options) {
    if constexpr (requires { options.guard; }) options.guard = guard;
  };
  std::visit(set, method.options);
}

bool loses_pairs(const Scene& scene) {
  const auto get = [](const auto& options) -> decltype(options.pair_count == PairCount::counted) {
    return options.partners == Partners::contact ||
           (options.offset != Offset::none && options.pair_count != PairCount::expected);
  };
  return choice(scene.method, false, get);
}

double density_window(const Scene& scene) {
  const auto get = [](const auto& options) -> decltype(options.density_window) {
    return options.density_window;
  };
  return static_cast<double>(choice(scene.method, std::optional<std::uint64_t>{}, get).value_or(1));
}

bool has_contact_factor(const Scene& scene) {
  const auto get = [](const auto& options) -> decltype(options.contact_factor == ContactFactor::local) {
    return options.contact_factor == ContactFactor::local;
  };
  return choice(scene.method, false, get);
}

bool has_partners_at_contact(const Scene& scene) {
  const auto get = [](const auto& options) -> decltype(options.partners == Partners::contact) {
    return options.partners == Partners::contact;
  };
  return choice(scene.method, false, get);
}

double offset_along(const Scene& scene, double diameter, double restitution) {
  const auto get = [](const auto& options) -> decltype(Offset(options.offset)) { return options.offset; };
  switch (choice(scene.method, Offset::none, get)) {
    case Offset::none:
      return 0;
    case Offset::corrected:
      return diameter * (1 + restitution) / (2 * restitution);
    case Offset::consistent:
    case Offset::random:
      break;
  }
  return diameter;
}

double random_offset(const Scene& scene) {
  const auto get = [](const auto& options) -> decltype(double(options.random_offset)) {
    return options.random_offset;
  };
  return choice(scene.method, 0.0, get);
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

std::string kept_whole(const Scene& scene) {
  if (!capabilities(scene).ranks) return "method '" + method_family(scene) + "'";
  if (!scene.sources.empty()) return "a [[source]]";
  if (!scene.inflows.empty()) return "an [[inflow]]";
  if (!scene.regions.empty()) return "a [[region]]";
  const auto get =
      [](const auto& options) -> decltype(std::string(options.lattice != CellLattice::fixed, ' ')) {
    if (options.excluded_volume == ExcludedVolume::cells) return "excluded-volume = \"cells\"";
    if (options.partners == Partners::contact) return "partners = \"contact\"";
    if (options.pair_count == PairCount::time_counter) return "pair-count = \"time-counter\"";
    if (options.impact == ImpactDistribution::fitted) return "impact = \"fitted\"";
    return "";
  };
  return choice(scene.method, std::string(), get);
}

double least_cell_edge(const Scene& scene) {
  double widest = 0;
  if (has_partners_at_contact(scene))
    for (const Species& species : scene.species) widest = std::max(widest, species.diameter);
  return widest;
}

namespace {
/// The most cells of at least this edge; as many as wanted where there is no such edge.
double at_most(double wanted, double size, double least) {
  double cells = least > 0 ? std::min(wanted, std::floor(size / least)) : wanted;
  while (cells > 1 && cells * least > size) --cells;
  return std::max(1.0, cells);
}
}  // namespace

std::vector<double> cells_of_edge(const Scene& scene, double edge) {
  std::vector<double> numbers;
  const double along = has_diagonal_cells(scene) ? M_SQRT2 * edge : edge;
  for (const double length : scene.domain.size)
    numbers.push_back(at_most(std::round(length / along), length, least_cell_edge(scene)));
  return numbers;
}

}  // namespace sandglass
