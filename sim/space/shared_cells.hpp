#pragma once

#include "sim/base/communicator.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace sandglass {

/// The cells that this process works on: all of them, or where several ranks share a box, a range of them. Ranges follow
/// each other in the order of the ranks, and their cuts show in no result: cells keep their numbers, which name the random
/// streams, and particles of lower ranks arrive before the own ones, those of higher ranks behind.
class SharedCells {
 public:
  explicit SharedCells(std::uint32_t cells) : cuts_{0, cells} {}

  /// From now on with others. The first rank has all cells until the first cut.
  void share(Communicator& ranks);
  bool shared() const { return ranks_ != nullptr; }
  Communicator& ranks() const { return *ranks_; }

  std::uint32_t first() const { return cuts_[rank_]; }
  std::uint32_t last() const { return cuts_[rank_ + 1]; }
  std::size_t owner(std::uint32_t cell) const {
    return static_cast<std::size_t>(std::upper_bound(cuts_.begin() + 1, cuts_.end() - 1, cell) -
                                    cuts_.begin() - 1);
  }

  /// First cell of each rank, and the end.
  const std::vector<std::uint32_t>& cuts() const { return cuts_; }
  void set_cuts(std::vector<std::uint32_t> cuts) { cuts_ = std::move(cuts); }

  /// Fills in the numbers by cell that other ranks work out.
  template <class T>
  void complete(std::span<T> by_cell) const {
    if (!shared()) return;
    const std::span<const T> own = by_cell.subspan(first(), last() - first());
    const auto all = ranks_->collect(bytes_of(own));
    for (std::size_t rank = 0; rank < all.size(); ++rank)
      if (rank != rank_ && !all[rank].empty())
        std::memcpy(by_cell.data() + cuts_[rank], all[rank].data(), all[rank].size());
  }

 private:
  Communicator* ranks_ = nullptr;
  std::size_t rank_ = 0;
  std::vector<std::uint32_t> cuts_;
};

/// Of one process alone; `offsets` of all cells, as of ParticleStore.
inline SharedCells all_cells(std::span<const std::uint32_t> offsets) {
  return SharedCells(static_cast<std::uint32_t>(offsets.size() - 1));
}
/// Cuts that give each rank about as many particles.
std::vector<std::uint32_t> equal_cuts(std::span<const std::uint32_t> offsets, std::size_t ranks);
/// Particles of the rank that has most.
std::uint32_t largest_share(std::span<const std::uint32_t> offsets, const std::vector<std::uint32_t>& cuts);

}  // namespace sandglass
