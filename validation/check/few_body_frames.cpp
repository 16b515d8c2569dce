#include "validation/check/few_body_frames.hpp"

#include "sim/base/error.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sandglass {

namespace {
std::vector<double> cut(const std::vector<double>& all, std::size_t place, std::size_t width) {
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(place * width);
  return {begin, begin + static_cast<std::ptrdiff_t>(width)};
}
}  // namespace

Vector<3> in_space(const std::vector<double>& components) {
  Vector<3> vector = Vector<3>::Zero();
  for (std::size_t axis = 0; axis < components.size(); ++axis)
    vector[static_cast<int>(axis)] = components[axis];
  return vector;
}

Vector<3> spin_in_space(const std::vector<double>& components) {
  return components.size() == 1 ? Vector<3>(0, 0, components[0]) : in_space(components);
}

FramedBall ball_in(const Frame& frame, std::size_t index, int dimension) {
  const auto found = std::find(frame.id.begin(), frame.id.end(), index);
  if (found == frame.id.end()) throw InputError(fmt::format("a frame does not hold ball {}", index + 1));
  const auto place = static_cast<std::size_t>(found - frame.id.begin());
  const auto width = static_cast<std::size_t>(dimension);
  FramedBall ball{in_space(cut(frame.position, place, width)), in_space(cut(frame.velocity, place, width)),
                  Vector<3>::Zero()};
  if (!frame.spin.empty()) ball.spin = spin_in_space(cut(frame.spin, place, dimension == 2 ? 1 : 3));
  return ball;
}

const std::vector<Frame>& frames_with_ids(const Subject& subject) {
  const std::vector<Frame>& frames = subject.record().trajectory;
  if (frames.empty() || frames.front().id.empty())
    throw InputError("the record has no trajectory with identities: set 'trajectory' and 'ids' in [output]");
  return frames;
}

}  // namespace sandglass
