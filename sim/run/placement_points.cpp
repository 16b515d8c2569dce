#include "sim/run/placement_points.hpp"

#include "sim/base/error.hpp"

#include <cmath>

namespace sandglass {

namespace {
/// Tries for one particle; a box that is nearly all obstacle runs out of them.
constexpr int kTries = 100'000;

/// Draws each particle from a stream of its own, again and again until it stands outside every obstacle.
template <int D, class Draw>
std::vector<Vector<D>> place_outside_obstacles(const Room<D>& room, std::uint64_t count, const StreamKey& key,
                                               Draw draw) {
  std::vector<Vector<D>> points(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    Random random(key, i);
    int tries = 0;
    do {
      if (++tries > kTries)
        throw InputError(
            "'initial.positions': no room for a particle outside the obstacles; use fewer or smaller ones");
      for (int axis = 0; axis < D; ++axis) points[i][axis] = draw(axis, random.uniform());
    } while (room.blocked(points[i], 0));
  }
  return points;
}
}  // namespace

template <int D>
std::vector<Vector<D>> place_randomly(const Room<D>& room, std::uint64_t count, const StreamKey& key) {
  return place_outside_obstacles<D>(room, count, key,
                                    [&room](int axis, double uniform) { return room.box[axis] * uniform; });
}

/// The height above the end that gravity pulls to has the density exp(-z/h) on [0, L], its distribution function inverted.
template <int D>
std::vector<Vector<D>> place_barometrically(const Scene& scene, const Room<D>& room, std::uint64_t count,
                                            const StreamKey& key) {
  const auto draw = [&](int axis, double uniform) {
    const double length = room.box[axis], pull = scene.gravity[static_cast<std::size_t>(axis)];
    if (pull == 0) return length * uniform;
    const double scale = scene.initial.temperature / (scene.species.front().mass * std::abs(pull));
    const double height = -scale * std::log1p(uniform * std::expm1(-length / scale));
    return pull < 0 ? height : length - height;
  };
  return place_outside_obstacles<D>(room, count, key, draw);
}

template std::vector<Vector<2>> place_randomly(const Room<2>&, std::uint64_t, const StreamKey&);
template std::vector<Vector<3>> place_randomly(const Room<3>&, std::uint64_t, const StreamKey&);
template std::vector<Vector<2>> place_barometrically(const Scene&, const Room<2>&, std::uint64_t,
                                                     const StreamKey&);
template std::vector<Vector<3>> place_barometrically(const Scene&, const Room<3>&, std::uint64_t,
                                                     const StreamKey&);

}  // namespace sandglass
