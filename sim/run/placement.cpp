#include "sim/run/placement.hpp"

#include "sim/base/error.hpp"
#include "sim/run/placement_lattice.hpp"
#include "sim/run/placement_packing.hpp"
#include "sim/run/placement_points.hpp"

#include <algorithm>
#include <functional>

namespace sandglass {

namespace {

void refuse_overlaps(bool hard) {
  if (hard)
    throw InputError(
        "'initial.positions' = \"random\" lets hard particles overlap; use \"lattice\" or "
        "\"random-without-overlap\"");
}

template <int D>
std::vector<Vector<D>> place_on_lattice(const Scene& scene, const Room<D>& room, std::uint64_t count) {
  if (room.hard) return fitting_sites<D>(room, count, largest_diameter(scene));
  const Lattice<D> lattice = square_lattice<D>(room.box, count);
  const auto total = static_cast<double>(lattice.points());
  std::vector<Vector<D>> points(count);
  // Spread the empty sites evenly.
  for (std::uint64_t i = 0; i < count; ++i)
    points[i] = lattice.at(
        static_cast<std::uint64_t>((static_cast<double>(i) + 0.5) * total / static_cast<double>(count)));
  return points;
}

/// From the top down, so that the first particles are those of the highest layer.
template <int D>
std::vector<Vector<D>> place_in_layers(const Scene& scene, const Room<D>& room, std::uint64_t count) {
  std::vector<Vector<D>> points = place_on_lattice<D>(scene, room, count);
  std::ranges::stable_sort(points, std::greater(), [](const Vector<D>& point) { return point[D - 1]; });
  return points;
}

std::vector<double> radii_of(const Scene& scene, std::uint64_t count, std::span<const std::uint8_t> species) {
  std::vector<double> radii(count, scene.species.front().diameter / 2);
  for (std::size_t i = 0; i < species.size(); ++i) radii[i] = scene.species[species[i]].diameter / 2;
  return radii;
}

template <int D>
std::vector<Vector<D>> points_of(const Scene& scene, std::uint64_t count, const Streams& streams,
                                 std::span<const std::uint8_t> species) {
  const Room<D> room(scene);
  const StreamKey key(streams.seed, Purpose::positions, streams.replica, 0);
  switch (scene.initial.positions) {
    case Positions::random:
      refuse_overlaps(room.hard);
      return place_randomly<D>(room, count, key);
    case Positions::barometric:
      refuse_overlaps(room.hard);
      return place_barometrically<D>(scene, room, count, key);
    case Positions::lattice:
      return place_on_lattice<D>(scene, room, count);
    case Positions::layers:
      return place_in_layers<D>(scene, room, count);
    case Positions::random_without_overlap:
      return pack_randomly<D>(room, radii_of(scene, count, species), key);
  }
  return {};
}

}  // namespace

template <int D>
std::vector<Phase<D>> place(const Scene& scene, std::uint64_t count, const Streams& streams,
                            std::span<const std::uint8_t> species) {
  std::vector<Phase<D>> particles;
  particles.reserve(count);
  for (const Vector<D>& point : points_of<D>(scene, count, streams, species))
    particles.push_back({point, Vector<D>::Zero()});
  return particles;
}

template std::vector<Phase<2>> place(const Scene&, std::uint64_t, const Streams&,
                                     std::span<const std::uint8_t>);
template std::vector<Phase<3>> place(const Scene&, std::uint64_t, const Streams&,
                                     std::span<const std::uint8_t>);

}  // namespace sandglass
