#pragma once

#include "sim/space/migration.hpp"

#include <optional>

namespace sandglass {

/// The particles of one box on several ranks: the store of each holds those in its cells.
template <int D>
class SharedStore {
 public:
  /// `columns` are those of the store.
  SharedStore(ParticleStore<D>& store, const std::vector<ColumnInfo>& columns, Communicator& ranks);

  const SharedCells& work() const { return work_; }
  /// Of a store to which all particles have been assigned. Every rank then knows the same cuts.
  void keep_own();
  /// Instead of ParticleStore::sort(), where particles have moved. From time to time cuts move too.
  void sort();
  /// The particles of all ranks, on the first of them; on others their own. Goes stale with the next sort.
  const ParticleStore<D>& gather();
  std::size_t bytes() const { return all_ ? all_->bytes() : 0; }

 private:
  void balance();
  std::vector<std::uint32_t> offsets_of_all() const;

  ParticleStore<D>& store_;
  SharedCells work_;
  std::optional<ParticleStore<D>> all_;  ///< on the first rank
  std::uint64_t sorts_ = 0;
};

extern template class SharedStore<2>;
extern template class SharedStore<3>;

}  // namespace sandglass
