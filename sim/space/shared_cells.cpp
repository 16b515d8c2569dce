#include "sim/space/shared_cells.hpp"

namespace sandglass {

void SharedCells::share(Communicator& ranks) {
  ranks_ = &ranks;
  rank_ = ranks.rank();
  cuts_.resize(ranks.count() + 1, cuts_.back());
}

/// At the cell edge that is nearest to an equal share.
std::vector<std::uint32_t> equal_cuts(std::span<const std::uint32_t> offsets, std::size_t ranks) {
  std::vector<std::uint32_t> cuts{0};
  const std::uint64_t particles = offsets.back();
  for (std::size_t rank = 1; rank < ranks; ++rank) {
    const std::uint64_t wanted = particles * rank / ranks;
    auto cut = std::lower_bound(offsets.begin(), offsets.end(), wanted);
    if (cut != offsets.begin() && wanted - *(cut - 1) < *cut - wanted) --cut;
    cuts.push_back(std::max(cuts.back(), static_cast<std::uint32_t>(cut - offsets.begin())));
  }
  cuts.push_back(static_cast<std::uint32_t>(offsets.size() - 1));
  return cuts;
}

std::uint32_t largest_share(std::span<const std::uint32_t> offsets, const std::vector<std::uint32_t>& cuts) {
  std::uint32_t largest = 0;
  for (std::size_t rank = 0; rank + 1 < cuts.size(); ++rank)
    largest = std::max(largest, offsets[cuts[rank + 1]] - offsets[cuts[rank]]);
  return largest;
}

}  // namespace sandglass
