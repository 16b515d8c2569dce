#include "sim/run/placement.hpp"

#include "sim/base/error.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {

template <int D>
Vector<D> uniform_point(const Vector<D>& box, Random& random) {
  Vector<D> point;
  for (int axis = 0; axis < D; ++axis) point[axis] = box[axis] * random.uniform();
  return point;
}

template <int D>
std::vector<Phase<D>> place_randomly(const Vector<D>& box, std::uint64_t count, const StreamKey& key) {
  std::vector<Phase<D>> particles(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    Random random(key, i);
    particles[i] = {uniform_point<D>(box, random), Vector<D>::Zero()};
  }
  return particles;
}

/// Rows of a rectangular lattice with as square a cell as whole numbers allow.
template <int D>
std::vector<Phase<D>> place_on_lattice(const Vector<D>& box, std::uint64_t count) {
  const double spacing = std::pow(box.prod() / static_cast<double>(count), 1.0 / D);
  std::array<std::uint64_t, D> sites;
  std::uint64_t total = 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    sites[axis] = std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(std::lround(box[static_cast<int>(axis)] / spacing)));
    total *= sites[axis];
  }
  for (std::size_t axis = D - 1; total < count; axis = (axis + D - 1) % D) {
    total = total / sites[axis] * (sites[axis] + 1);
    ++sites[axis];
  }
  std::vector<Phase<D>> particles(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    // Spread the empty sites evenly.
    std::uint64_t site = static_cast<std::uint64_t>((static_cast<double>(i) + 0.5) *
                                                    static_cast<double>(total) / static_cast<double>(count));
    for (std::size_t axis = 0; axis < D; ++axis) {
      particles[i].position[static_cast<int>(axis)] = box[static_cast<int>(axis)] *
                                                      (static_cast<double>(site % sites[axis]) + 0.5) /
                                                      static_cast<double>(sites[axis]);
      site /= sites[axis];
    }
    particles[i].velocity.setZero();
  }
  return particles;
}

/// Random sequential addition: a point is kept if no earlier particle is nearer than a diameter.
template <int D>
class Packing {
 public:
  Packing(const Vector<D>& box, const std::array<bool, D>& periodic, double diameter)
      : box_(box), periodic_(periodic), square_diameter_(diameter * diameter) {
    std::size_t total = 1;
    for (std::size_t axis = 0; axis < D; ++axis) {
      cells_[axis] =
          std::max<std::int64_t>(1, static_cast<std::int64_t>(box[static_cast<int>(axis)] / diameter));
      total *= static_cast<std::size_t>(cells_[axis]);
    }
    members_.resize(total);
  }

  bool add(const Vector<D>& point) {
    if (touches(point)) return false;
    members_[number(cell_of(point))].push_back(point);
    return true;
  }

 private:
  using Cell = std::array<std::int64_t, D>;

  Cell cell_of(const Vector<D>& point) const {
    Cell cell;
    for (std::size_t axis = 0; axis < D; ++axis)
      cell[axis] = std::min(cells_[axis] - 1, static_cast<std::int64_t>(point[static_cast<int>(axis)] /
                                                                        box_[static_cast<int>(axis)] *
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
      if (periodic_[static_cast<std::size_t>(axis)])
        gap[axis] -= box_[axis] * std::round(gap[axis] / box_[axis]);
    return gap.squaredNorm();
  }
  bool touches(const Vector<D>& point) const {
    const Cell centre = cell_of(point);
    int neighbours = 1;
    for (int axis = 0; axis < D; ++axis) neighbours *= 3;
    for (int code = 0; code < neighbours; ++code) {
      Cell cell = centre;
      for (int axis = 0, rest = code; axis < D; ++axis, rest /= 3)
        cell[static_cast<std::size_t>(axis)] += rest % 3 - 1;
      for (const Vector<D>& other : members_[number(cell)])
        if (square_distance(point, other) < square_diameter_) return true;
    }
    return false;
  }

  Vector<D> box_;
  std::array<bool, D> periodic_;
  double square_diameter_;
  Cell cells_;
  std::vector<std::vector<Vector<D>>> members_;
};

template <int D>
std::vector<Phase<D>> place_without_overlap(const Scene& scene, const Vector<D>& box, std::uint64_t count,
                                            const StreamKey& key) {
  constexpr int kTries = 100000;
  std::array<bool, D> periodic;
  for (std::size_t axis = 0; axis < D; ++axis) periodic[axis] = scene.domain.sides[axis][0] == Side::periodic;
  Packing<D> packing(box, periodic, scene.species.front().diameter);
  std::vector<Phase<D>> particles;
  for (std::uint64_t i = 0; i < count; ++i) {
    Random random(key, i);
    Vector<D> point = uniform_point<D>(box, random);
    for (int tries = 0; !packing.add(point); ++tries) {
      if (tries == kTries)
        throw InputError(
            fmt::format("no room for particle {} of {} without overlap after {} tries; use positions = "
                        "\"lattice\" or a lower fraction",
                        i + 1, count, kTries));
      point = uniform_point<D>(box, random);
    }
    particles.push_back({point, Vector<D>::Zero()});
  }
  return particles;
}

}  // namespace

template <int D>
std::vector<Phase<D>> place(const Scene& scene, std::uint64_t count, const Streams& streams) {
  const Vector<D> box = Eigen::Map<const Vector<D>>(scene.domain.size.data());
  const StreamKey key(streams.seed, Purpose::positions, streams.replica, 0);
  switch (scene.initial.positions) {
    case Positions::random:
      return place_randomly<D>(box, count, key);
    case Positions::lattice:
      return place_on_lattice<D>(box, count);
    case Positions::random_without_overlap:
      return place_without_overlap<D>(scene, box, count, key);
  }
  return {};
}

template std::vector<Phase<2>> place(const Scene&, std::uint64_t, const Streams&);
template std::vector<Phase<3>> place(const Scene&, std::uint64_t, const Streams&);

}  // namespace sandglass
