#pragma once

#include "sim/base/saved.hpp"

#include <cstdint>
#include <vector>

namespace sandglass {

/// Collisions per particle, 2 C / N. Where N changes during a run, the sum over the stretches of equal N.
class CollisionCount {
 public:
  CollisionCount() = default;
  CollisionCount(std::uint64_t particles) : particles_(particles) {}  // NOLINT: a count of so many particles

  /// `collisions` since time zero, `particles` as there are now.
  double per_particle(std::uint64_t collisions, std::uint64_t particles) {
    if (particles != particles_) {
      settled_ = last_;
      counted_ = seen_;
      particles_ = particles;
    }
    seen_ = collisions;
    last_ = particles_ == 0
                ? settled_
                : settled_ + 2 * static_cast<double>(collisions - counted_) / static_cast<double>(particles_);
    return last_;
  }

  std::vector<double> save() const {
    return {settled_, static_cast<double>(counted_), static_cast<double>(particles_), last_,
            static_cast<double>(seen_)};
  }
  void load(const std::vector<double>& state) {
    settled_ = saved_number(state.at(0), 0, 1e300, "collisions per particle");
    counted_ = saved_count(state.at(1));
    particles_ = saved_count(state.at(2));
    last_ = saved_number(state.at(3), 0, 1e300, "collisions per particle");
    seen_ = saved_count(state.at(4));
  }

 private:
  double settled_ = 0;         ///< of the stretches before this one
  std::uint64_t counted_ = 0;  ///< collisions in them
  std::uint64_t particles_ = 0;
  double last_ = 0;         ///< answer of the last call
  std::uint64_t seen_ = 0;  ///< collisions at the last call
};

}  // namespace sandglass
