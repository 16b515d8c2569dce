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

BallPhase ball_in(const Frame& frame, std::size_t index, int dimension) {
  const auto ids = frame.columns.get(column::id);
  const auto found = std::find(ids.begin(), ids.end(), index);
  if (found == ids.end()) throw InputError(fmt::format("a frame does not hold ball {}", index + 1));
  const auto place = static_cast<std::size_t>(found - ids.begin());
  const auto width = static_cast<std::size_t>(dimension);
  BallPhase ball{
      in_space(cut(frame.position, place, width)), in_space(cut(frame.velocity, place, width)), {}};
  if (dimension == 2 && frame.columns.has(column::spin<2>))
    ball.spin = Vector<3>(0, 0, frame.columns.get(column::spin<2>)[place][0]);
  if (dimension == 3 && frame.columns.has(column::spin<3>))
    ball.spin = frame.columns.get(column::spin<3>)[place];
  return ball;
}

const std::vector<Frame>& frames_with_ids(const Subject& subject) {
  const std::vector<Frame>& frames = subject.record().trajectory;
  if (frames.empty() || frames.front().columns.get(column::id).empty())
    throw InputError("the record has no trajectory with identities: set 'trajectory' and 'ids' in [output]");
  return frames;
}

}  // namespace sandglass
