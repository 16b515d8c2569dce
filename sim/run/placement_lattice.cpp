#include "sim/run/placement_lattice.hpp"

#include "sim/base/error.hpp"

#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
/// Particles that just touch may overlap by rounding: this share of their distance.
constexpr double kRounding = 1e-12;

double at_most(double room, double diameter) { return std::floor(room / diameter * (1 + kRounding)); }

template <int D>
std::uint64_t product(const std::array<std::uint64_t, D>& factors) {
  std::uint64_t total = 1;
  for (std::uint64_t factor : factors) total *= factor;
  return total;
}
}  // namespace

template <int D>
std::uint64_t Lattice<D>::points() const {
  return product<D>(layers);
}

template <int D>
bool Lattice<D>::has(std::uint64_t point) const {
  std::uint64_t sum = 0;
  for (std::uint64_t layer : layers) {
    sum += point % layer;
    point /= layer;
  }
  return !checkered || sum % 2 == 0;
}

template <int D>
Vector<D> Lattice<D>::at(std::uint64_t point) const {
  Vector<D> place;
  for (int axis = 0; axis < D; ++axis) {
    const std::uint64_t all = layers[static_cast<std::size_t>(axis)];
    const auto layer = static_cast<double>(point % all);
    if (margin[axis] > 0 && all > 1)
      place[axis] = margin[axis] + (box[axis] - 2 * margin[axis]) * layer / (static_cast<double>(all) - 1);
    else
      place[axis] = box[axis] * (layer + 0.5) / static_cast<double>(all);
    point /= all;
  }
  return place;
}

template <int D>
double Lattice<D>::nearest(const std::array<bool, D>& periodic) const {
  Vector<D> one, two;  // to the next layer and to the one behind it
  for (int axis = 0; axis < D; ++axis) {
    const bool round = periodic[static_cast<std::size_t>(axis)];
    const auto all = static_cast<double>(layers[static_cast<std::size_t>(axis)]);
    const double step = round ? box[axis] / all : (box[axis] - 2 * margin[axis]) / (all - 1);
    one[axis] = round || all > 1 ? step : HUGE_VAL;
    two[axis] = round || all > 2 ? 2 * step : HUGE_VAL;
  }
  double least = two.minCoeff();
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < a; ++b) least = std::min(least, std::hypot(one[a], one[b]));
  return least;
}

template <int D>
Lattice<D> square_lattice(const Vector<D>& box, std::uint64_t count) {
  const double spacing = std::pow(box.prod() / static_cast<double>(count), 1.0 / D);
  Lattice<D> lattice{box, {}};
  for (std::size_t axis = 0; axis < D; ++axis)
    lattice.layers[axis] = std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(std::lround(box[static_cast<int>(axis)] / spacing)));
  for (std::size_t axis = D - 1; lattice.points() < count; axis = (axis + D - 1) % D) ++lattice.layers[axis];
  return lattice;
}

/// In the middle of a cell of at least a diameter a site keeps its radius from walls too.
template <int D>
std::optional<Lattice<D>> fitting_square_lattice(const Vector<D>& box, std::uint64_t count, double diameter) {
  Lattice<D> lattice = square_lattice<D>(box, count);
  std::array<std::uint64_t, D> most;
  for (std::size_t axis = 0; axis < D; ++axis) {
    most[axis] = static_cast<std::uint64_t>(at_most(box[static_cast<int>(axis)], diameter));
    lattice.layers[axis] = std::min(lattice.layers[axis], most[axis]);
  }
  while (lattice.points() < count) {
    int widest = -1;
    double cell = 0;
    for (int axis = 0; axis < D; ++axis) {
      const std::uint64_t now = lattice.layers[static_cast<std::size_t>(axis)];
      if (now >= most[static_cast<std::size_t>(axis)] || !(box[axis] / static_cast<double>(now) > cell))
        continue;
      widest = axis;
      cell = box[axis] / static_cast<double>(now);
    }
    if (widest < 0) return std::nullopt;
    ++lattice.layers[static_cast<std::size_t>(widest)];
  }
  return lattice;
}

/// Layers two apart are in line: they are no nearer than a diameter. Around a periodic axis the colours alternate only
/// with an even number of layers.
template <int D>
std::optional<Lattice<D>> fitting_checkered_lattice(const Room<D>& room, std::uint64_t count,
                                                    double diameter) {
  std::array<std::uint64_t, D> most;
  Lattice<D> lattice{room.box, {}, true};
  for (int axis = 0; axis < D; ++axis) {
    lattice.margin[axis] = room.margin(axis, diameter / 2);
    most[static_cast<std::size_t>(axis)] =
        static_cast<std::uint64_t>(at_most(2 * room.box[axis], diameter)) + 1;
  }
  std::optional<Lattice<D>> best;
  double widest = diameter * (1 - kRounding);
  const std::uint64_t choices = product<D>(most) / most[D - 1];
  for (std::uint64_t choice = 0; choice < choices; ++choice) {
    std::uint64_t rest = choice, plane = 1;
    bool closes = true;
    for (std::size_t axis = 0; axis + 1 < D; ++axis) {
      lattice.layers[axis] = rest % most[axis] + 1;
      rest /= most[axis];
      plane *= lattice.layers[axis];
      closes &= !room.periodic[axis] || lattice.layers[axis] % 2 == 0;
    }
    lattice.layers[D - 1] = (2 * count - 1 + plane - 1) / plane;
    if (room.periodic[D - 1]) lattice.layers[D - 1] += lattice.layers[D - 1] % 2;
    if (!closes || lattice.layers[D - 1] > most[D - 1]) continue;
    const double nearest = lattice.nearest(room.periodic);
    if (nearest < widest || (best && nearest == widest)) continue;
    widest = nearest;
    best = lattice;
  }
  return best;
}

namespace {
template <int D>
std::vector<Vector<D>> free_sites(const Lattice<D>& lattice, const Room<D>& room, double radius) {
  std::vector<Vector<D>> sites;
  for (std::uint64_t point = 0; point < lattice.points(); ++point)
    if (lattice.has(point))
      if (const Vector<D> site = lattice.at(point); !room.blocked(site, radius)) sites.push_back(site);
  return sites;
}

/// Finer and finer, until enough sites are free; `lattice_of` gives one of so many sites, or none. Empty if it fails.
template <int D, class Make>
std::vector<Vector<D>> refine(const Room<D>& room, std::uint64_t count, double radius, Make lattice_of) {
  std::uint64_t wanted = count;
  while (const std::optional<Lattice<D>> lattice = lattice_of(wanted)) {
    std::vector<Vector<D>> sites = free_sites<D>(*lattice, room, radius);
    if (sites.size() >= count) return sites;
    wanted += count - sites.size();
  }
  return {};
}
}  // namespace

template <int D>
std::vector<Vector<D>> fitting_sites(const Room<D>& room, std::uint64_t count, double diameter) {
  std::vector<Vector<D>> sites = refine<D>(room, count, diameter / 2, [&](std::uint64_t wanted) {
    return fitting_square_lattice<D>(room.box, wanted, diameter);
  });
  if (sites.empty())
    sites = refine<D>(room, count, diameter / 2, [&](std::uint64_t wanted) {
      return fitting_checkered_lattice<D>(room, wanted, diameter);
    });
  if (sites.empty())
    throw InputError(fmt::format(
        "'initial.positions': neither a square nor a {} lattice of {} particles as large as the largest "
        "(diameter {}) fits into the domain; use fewer or smaller particles, a larger domain, or, if it is "
        "not dense, positions = \"random-without-overlap\"",
        D == 2 ? "triangular" : "face-centred cubic", count, diameter));
  std::vector<Vector<D>> taken(count);
  for (std::uint64_t i = 0; i < count; ++i)
    taken[i] = sites[static_cast<std::size_t>(
        (static_cast<double>(i) + 0.5) * static_cast<double>(sites.size()) / static_cast<double>(count))];
  return taken;
}

template struct Lattice<2>;
template struct Lattice<3>;
template Lattice<2> square_lattice(const Vector<2>&, std::uint64_t);
template Lattice<3> square_lattice(const Vector<3>&, std::uint64_t);
template std::optional<Lattice<2>> fitting_square_lattice(const Vector<2>&, std::uint64_t, double);
template std::optional<Lattice<3>> fitting_square_lattice(const Vector<3>&, std::uint64_t, double);
template std::optional<Lattice<2>> fitting_checkered_lattice(const Room<2>&, std::uint64_t, double);
template std::optional<Lattice<3>> fitting_checkered_lattice(const Room<3>&, std::uint64_t, double);
template std::vector<Vector<2>> fitting_sites(const Room<2>&, std::uint64_t, double);
template std::vector<Vector<3>> fitting_sites(const Room<3>&, std::uint64_t, double);

}  // namespace sandglass
