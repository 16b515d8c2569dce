#pragma once

namespace sandglass {

/// When an observer samples: every so much time, so many steps, or so many collisions per particle.
struct Cadence {
  enum class Unit { time, steps, collisions } unit = Unit::steps;
  double every = 1;
  bool operator==(const Cadence&) const = default;
};

}  // namespace sandglass
