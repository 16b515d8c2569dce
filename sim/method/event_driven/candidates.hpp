#pragma once

#include "sim/method/event_driven/particle.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace sandglass::event_driven {

/// Particles found near a place. It begins with the first one of each cell; the next in the same cell is added when a
/// particle is taken. Storage that grows and is never given back.
class Candidates {
 public:
  static constexpr std::uint32_t kAtOnce = 4;
  using Four = std::array<std::uint32_t, kAtOnce>;

  void clear() { size_ = done_ = 0; }
  /// Adds a particle or nobody, without a branch: nobody is written and then not counted.
  void add(std::uint32_t particle) {
    list_[size_] = particle;
    size_ += particle != kNobody;
  }

  std::uint32_t size() const { return size_; }
  std::uint32_t operator[](std::uint32_t k) const { return list_[k]; }

  bool more() const { return done_ < size_; }
  /// The next four, filled up with `filler` at the end.
  template <int D>
  Four next(const Particle<D>* particles, std::uint32_t filler) {
    if (size_ + 2 * kAtOnce > list_.size()) [[unlikely]]
      list_.resize(2 * list_.size());
    Four who, below;
    for (std::uint32_t k = 0; k < kAtOnce; ++k) {
      const bool known = done_ + k < size_;
      who[k] = known ? list_[done_ + k] : filler;
      below[k] = known ? particles[who[k]].below : kNobody;
    }
    done_ = std::min(done_ + kAtOnce, size_);
    for (const std::uint32_t particle : below) add(particle);
    return who;
  }

 private:
  std::uint32_t size_ = 0, done_ = 0;
  std::vector<std::uint32_t> list_ = std::vector<std::uint32_t>(256);
};

}  // namespace sandglass::event_driven
