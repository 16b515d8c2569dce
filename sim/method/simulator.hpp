#pragma once

#include "sim/observe/view.hpp"

#include <span>
#include <vector>

namespace sandglass {

/// What a method starts from: one entry a particle in every column that is not empty.
template <int D>
struct Particles {
  std::vector<Phase<D>> phases;
  std::vector<Spin<D>> spins;         ///< empty: smooth
  std::vector<std::uint8_t> species;  ///< empty: all of the first species
  std::vector<std::uint64_t> ids;     ///< empty: number them if the method keeps ids
};

/// A method at work: what the run loop needs of it.
template <int D>
class Simulator {
 public:
  virtual ~Simulator() = default;
  /// Takes particles in the given order.
  virtual void assign(const Particles<D>& particles) = 0;
  /// Advances by `dt`; `step` names the random streams.
  virtual void step(double dt, std::uint64_t step) = 0;
  /// Particles, cells and counters; time and step are the run's to fill in.
  virtual View<D> view() = 0;
  virtual std::span<const std::uint64_t> ids() const = 0;
  /// Particles that it holds now.
  virtual std::uint64_t size() const = 0;
  virtual Tally& tally() = 0;
  /// Counts of this method alone since time zero, by the name that they have in a record.
  virtual std::map<std::string, double> counters() const { return {}; }
  /// What a bitwise restart needs beside the view and the tally; and back, after assign().
  virtual Memory save() const { return {}; }
  virtual void load(const Memory&) {}
  /// Bytes held, everything included.
  virtual std::size_t bytes() const = 0;
};

/// The seed and replica that all random streams of a method share.
struct Streams {
  std::uint64_t seed = 1;
  std::uint64_t replica = 0;
};

}  // namespace sandglass
