#include "sim/space/shared_store.hpp"

#include <numeric>

namespace sandglass {

namespace {
/// Sorts between two looks at the balance, and the largest share over the mean above which cells change hands: the counts
/// of all cells travel then.
constexpr std::uint64_t kLook = 20;
constexpr double kLargest = 1.05;

/// The largest of all sizes over their mean.
double imbalance(Communicator& ranks, std::uint64_t own) {
  double largest = 0, sum = 0;
  for (const auto& size : collect<std::uint64_t>(ranks, {own})) {
    largest = std::max(largest, static_cast<double>(size.front()));
    sum += static_cast<double>(size.front());
  }
  return sum > 0 ? largest * static_cast<double>(ranks.count()) / sum : 1;
}
}  // namespace

template <int D>
SharedStore<D>::SharedStore(ParticleStore<D>& store, const std::vector<ColumnInfo>& columns,
                            Communicator& ranks)
    : store_(store), work_(store.cells().size()) {
  work_.share(ranks);
  if (ranks.is_first()) all_.emplace(store.cells(), columns);
}

template <int D>
void SharedStore<D>::keep_own() {
  const auto offsets = store_.offsets();
  work_.set_cuts(equal_cuts(offsets, work_.ranks().count()));
  std::vector<std::uint32_t> others(store_.size());
  std::iota(others.begin(), others.end(), 0u);
  others.erase(others.begin() + offsets[work_.first()], others.begin() + offsets[work_.last()]);
  store_.stay(others);
  store_.sort();
  store_.shrink();
}

template <int D>
void SharedStore<D>::sort() {
  migrate_and_sort(store_, work_);
  if (++sorts_ % kLook == 0) balance();
}

/// Cells keep their particles in their order, whoever holds them.
template <int D>
void SharedStore<D>::balance() {
  if (imbalance(work_.ranks(), store_.size()) <= kLargest) return;
  const std::vector<std::uint32_t> offsets = offsets_of_all();
  std::vector<std::uint32_t> cuts = equal_cuts(offsets, work_.ranks().count());
  if (largest_share(offsets, cuts) >= largest_share(offsets, work_.cuts())) return;
  store_.stay();
  work_.set_cuts(std::move(cuts));
  migrate_and_sort(store_, work_);
}

template <int D>
std::vector<std::uint32_t> SharedStore<D>::offsets_of_all() const {
  std::vector<std::uint32_t> offsets(store_.cells().size() + 1);
  const std::span<std::uint32_t> counts = std::span(offsets).subspan(1);
  for (std::uint32_t cell = work_.first(); cell < work_.last(); ++cell)
    counts[cell] = store_.offsets()[cell + 1] - store_.offsets()[cell];
  work_.complete(counts);
  std::inclusive_scan(offsets.begin(), offsets.end(), offsets.begin());
  return offsets;
}

template <int D>
const ParticleStore<D>& SharedStore<D>::gather() {
  sandglass::gather(store_, work_, all_ ? *all_ : store_);
  return all_ ? *all_ : store_;
}

template class SharedStore<2>;
template class SharedStore<3>;

}  // namespace sandglass
