#pragma once

#include "sim/base/vector.hpp"
#include "validation/check/subject.hpp"

#include <optional>
#include <vector>

// Frames of a record with a few particles, read ball by ball.

namespace sandglass {

/// Phase and spin of a ball, in three dimensions; a disk has z = 0 and spins about z.
struct BallPhase {
  Vector<3> position, velocity;
  std::optional<Vector<3>> spin;  ///< if the frame holds spins
};

Vector<3> in_space(const std::vector<double>& components);
/// Of a disk (one component) or a sphere (three); none is at rest.
Vector<3> spin_in_space(const std::vector<double>& components);

/// The ball that was given as number `index`, from 0. Throws InputError when the frame does not hold it.
BallPhase ball_in(const Frame& frame, std::size_t index, int dimension);

/// The trajectory. Throws InputError when the record has none, or no identities.
const std::vector<Frame>& frames_with_ids(const Subject& subject);

}  // namespace sandglass
