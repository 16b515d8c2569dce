#pragma once

#include "sim/base/vector.hpp"
#include "validation/check/subject.hpp"

#include <vector>

// Frames of a record with a few particles, read ball by ball.

namespace sandglass {

/// A ball of a frame in three dimensions; a disk has z = 0 and spins about z.
struct FramedBall {
  Vector<3> position, velocity, spin;
};

Vector<3> in_space(const std::vector<double>& components);
/// Of a disk (one component) or a sphere (three); none is at rest.
Vector<3> spin_in_space(const std::vector<double>& components);

/// The ball that was given as number `index`, from 0. Throws InputError when the frame does not hold it.
FramedBall ball_in(const Frame& frame, std::size_t index, int dimension);

/// The trajectory. Throws InputError when the record has none, or no identities.
const std::vector<Frame>& frames_with_ids(const Subject& subject);

}  // namespace sandglass
