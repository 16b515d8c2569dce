#pragma once

#include "sim/base/vector.hpp"

namespace sandglass {

/// A point of phase space: position and velocity, what every particle has.
template <int D>
struct Phase {
  Vector<D> position, velocity;
};

}  // namespace sandglass
