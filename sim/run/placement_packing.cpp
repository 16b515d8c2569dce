#include "sim/run/placement_packing.hpp"

#include "sim/base/error.hpp"
#include "sim/base/stop_request.hpp"

#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace sandglass {

namespace {

template <int D>
Vector<D> uniform_point(const Room<D>& room, double radius, Random& random) {
  Vector<D> point;
  for (int axis = 0; axis < D; ++axis) {
    const double low = room.margin(axis, radius), high = room.box[axis] - low;
    point[axis] = std::min(low + (high - low) * random.uniform(), high);
  }
  return point;
}

/// The particles so far, by cell. No cell is smaller than the largest particle, nor than the room of one.
template <int D>
class Packing {
 public:
  Packing(const Room<D>& room, double largest_diameter, std::size_t count) : room_(room) {
    const double spacing = std::pow(room.box.prod() / static_cast<double>(count), 1.0 / D);
    std::size_t total = 1;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const double cells = room.box[static_cast<int>(axis)] / std::max(largest_diameter, spacing);
      cells_[axis] = std::max<std::int64_t>(1, static_cast<std::int64_t>(cells));
      total *= static_cast<std::size_t>(cells_[axis]);
    }
    members_.resize(total);
  }

  bool add(const Vector<D>& point, double radius) {
    if (room_.blocked(point, radius) || touches(point, radius)) return false;
    members_[number(cell_of(point))].push_back({point, radius});
    return true;
  }

 private:
  using Cell = std::array<std::int64_t, D>;
  struct Member {
    Vector<D> centre;
    double radius;
  };

  Cell cell_of(const Vector<D>& point) const {
    Cell cell;
    for (std::size_t axis = 0; axis < D; ++axis)
      cell[axis] = std::min(cells_[axis] - 1, static_cast<std::int64_t>(point[static_cast<int>(axis)] /
                                                                        room_.box[static_cast<int>(axis)] *
                                                                        static_cast<double>(cells_[axis])));
    return cell;
  }
  std::size_t number(const Cell& cell) const {
    std::size_t result = 0;
    for (std::size_t axis = 0; axis < D; ++axis)
      result = result * static_cast<std::size_t>(cells_[axis]) +
               static_cast<std::size_t>((cell[axis] + cells_[axis]) % cells_[axis]);
    return result;
  }
  double square_distance(const Vector<D>& a, const Vector<D>& b) const {
    Vector<D> gap = a - b;
    for (int axis = 0; axis < D; ++axis)
      if (room_.periodic[static_cast<std::size_t>(axis)])
        gap[axis] -= room_.box[axis] * std::round(gap[axis] / room_.box[axis]);
    return gap.squaredNorm();
  }
  bool touches(const Vector<D>& point, double radius) const {
    const Cell centre = cell_of(point);
    int neighbours = 1;
    for (int axis = 0; axis < D; ++axis) neighbours *= 3;
    for (int code = 0; code < neighbours; ++code) {
      Cell cell = centre;
      for (int axis = 0, rest = code; axis < D; ++axis, rest /= 3)
        cell[static_cast<std::size_t>(axis)] += rest % 3 - 1;
      for (const Member& other : members_[number(cell)]) {
        const double reach = radius + other.radius;
        if (square_distance(point, other.centre) < reach * reach) return true;
      }
    }
    return false;
  }

  const Room<D>& room_;
  Cell cells_;
  std::vector<std::vector<Member>> members_;
};

std::vector<std::size_t> largest_first(std::span<const double> radii) {
  std::vector<std::size_t> order(radii.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) { return radii[i]; });
  return order;
}

}  // namespace

template <int D>
std::vector<Vector<D>> pack_randomly(const Room<D>& room, std::span<const double> radii,
                                     const StreamKey& key) {
  constexpr int kTries = 100000;
  std::vector<Vector<D>> points(radii.size());
  if (radii.empty()) return points;
  Packing<D> packing(room, 2 * *std::ranges::max_element(radii), radii.size());
  std::size_t placed = 0;
  for (std::size_t i : largest_first(radii)) {
    stop_request.heed();
    Random random(key, i);
    Vector<D> point = uniform_point<D>(room, radii[i], random);
    for (int tries = 0; !packing.add(point, radii[i]); ++tries) {
      if (tries == kTries)
        throw InputError(
            fmt::format("no room for particle {} of {} without overlap after {} tries; use positions = "
                        "\"lattice\" or a lower fraction",
                        placed + 1, radii.size(), kTries));
      point = uniform_point<D>(room, radii[i], random);
    }
    points[i] = point;
    ++placed;
  }
  return points;
}

template std::vector<Vector<2>> pack_randomly(const Room<2>&, std::span<const double>, const StreamKey&);
template std::vector<Vector<3>> pack_randomly(const Room<3>&, std::span<const double>, const StreamKey&);

}  // namespace sandglass
