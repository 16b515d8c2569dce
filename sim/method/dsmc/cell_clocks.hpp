#pragma once

#include "sim/base/random.hpp"
#include "sim/observe/tally.hpp"

#include <cstdint>
#include <vector>

namespace sandglass::dsmc {

/// How far the collisions of each cell are ahead of the start of a step, in steps of that length; see TimeCounterKernel.
class CellClocks {
 public:
  /// `forgotten`: planted fault.
  explicit CellClocks(bool forgotten) : forgotten_(forgotten) {}

  /// A random fraction of a step each, as the source has it.
  void start(std::uint32_t cells, const StreamKey& key);
  /// Before a step of this length. Those of the step before may have been longer or shorter.
  void begin_step(double dt);
  double* values() { return ahead_.data(); }

  void save(Memory& memory) const;
  void load(const Memory& memory);
  std::size_t bytes() const { return ahead_.capacity() * sizeof(double); }

 private:
  bool forgotten_;
  double dt_ = 0;  ///< of the last step; 0 before the first
  std::vector<double> ahead_;
};

}  // namespace sandglass::dsmc
