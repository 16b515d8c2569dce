#pragma once

#include "sim/base/communicator.hpp"
#include "sim/observe/plane.hpp"
#include "sim/observe/tally.hpp"
#include "sim/observe/wall_impulses.hpp"

#include <cstdint>
#include <vector>

namespace sandglass {

/// All that is counted since time zero where ranks share a box: whole numbers and exact sums, so that it does not show who
/// has counted what. Null for what is not counted.
template <int D>
struct CountsOfRanks {
  Tally& tally;
  std::vector<std::uint64_t*> others;
  std::vector<Plane>* planes = nullptr;
  WallImpulses<D>* impulses = nullptr;

  /// The first rank takes over what all have counted.
  void gather(Communicator& ranks);
  void clear();

 private:
  Communicator::Bytes packed() const;
  void add(const std::vector<double>& numbers);
};

extern template struct CountsOfRanks<2>;
extern template struct CountsOfRanks<3>;

}  // namespace sandglass
