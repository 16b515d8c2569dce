#pragma once

#include "sim/observe/view.hpp"

#include <span>

namespace sandglass {

/// A method at work: what the run loop needs of it.
template <int D>
class Simulator {
 public:
  virtual ~Simulator() = default;
  /// Takes particles in the given order; empty `ids`: number them if the method keeps ids.
  virtual void assign(std::span<const Phase<D>> particles, std::span<const std::uint64_t> ids) = 0;
  /// Advances by `dt`; `step` names the random streams.
  virtual void step(double dt, std::uint64_t step) = 0;
  /// Particles, cells and counters; time and step are the run's to fill in.
  virtual View<D> view() = 0;
  virtual std::span<const std::uint64_t> ids() const = 0;
  virtual Tally& tally() = 0;
  /// Bytes held, everything included.
  virtual std::size_t bytes() const = 0;
};

/// The seed and replica that all random streams of a method share.
struct Streams {
  std::uint64_t seed = 1;
  std::uint64_t replica = 0;
};

}  // namespace sandglass
