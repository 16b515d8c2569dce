#pragma once

#include "sim/space/lattice_of_cells.hpp"
#include "sim/space/particles.hpp"
#include "sim/space/stored_column.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace sandglass {

/// Particles sorted by cell, with a second buffer for the counting sort of every step. Within a cell the order is that of
/// (old cell, old place), then that of insertion: it does not depend on how cells are shared out. Of the columns beside
/// the phases only those exist that are asked for; all are sorted together.
template <int D>
class ParticleStore {
 public:
  explicit ParticleStore(const LatticeOfCells<D>& cells, const std::vector<ColumnInfo>& columns = {});

  const LatticeOfCells<D>& cells() const { return cells_; }
  const Grid<D>& grid() const { return cells_.grid(); }
  /// Displaces the cells, see ShiftedCells; the particles are then to be counted into them and sorted.
  void shift_cells(const Vector<D>& part) { cells_.shift(part); }
  std::size_t size() const { return phase_.size(); }

  std::span<Phase<D>> phases() { return phase_; }
  std::span<const Phase<D>> phases() const { return phase_; }
  /// The columns beside the phases, by declaration.
  ColumnViews columns() const;
  /// Empty when the column was not asked for.
  template <class T>
  std::span<T> column(const ColumnKey<T>& key) {
    const std::span<const T> values = columns().get(key);
    return {const_cast<T*>(values.data()), values.size()};
  }
  std::span<const std::uint64_t> ids() const { return columns().get(column::id); }
  /// First particle of each cell; one more entry than cells.
  std::span<const std::uint32_t> offsets() const { return {offset_.data(), offset_.size() - 1}; }

  // Moving. The motion gives every particle the place where it arrives; sort() then knows every address beforehand and
  // waits for no counter.
  using Place = CellPlace;
  void begin_step() { std::fill(arrival_.begin(), arrival_.end(), 0u); }
  /// For the motion's inner loop: places of the particles and counters of arrivals by cell.
  Place* places() { return place_.data(); }
  std::uint32_t* arrivals() { return arrival_.data() + 1; }
  /// A particle that arrives in this cell, which is none, is dropped by the sort.
  std::uint32_t removed() const { return cells_.size(); }
  /// Instead of a motion: all particles keep their cells, but those at the places `leaving` are dropped by the sort.
  void stay(std::span<const std::uint32_t> leaving = {});
  /// After the motion: those at the places `leaving` are dropped by the sort, whatever cells they arrive in.
  void drop(std::span<const std::uint32_t> leaving);
  /// After the motion, where the cells have been displaced since: all but the removed are in those where they stand.
  void find_cells();
  /// Takes particles in at the coming sort, behind those that arrive in their cells, with new ids. Throws InputError when a
  /// column has another length than the phases.
  void insert(const Particles<D>& particles);
  /// Moves every particle to its place.
  void sort();
  /// Whether the coming sorts add up the velocities of each cell, in the order in which its particles then stand.
  void sum_velocities(bool sum) { sums_velocities_ = sum; }
  /// By cell; empty where the last sort did not add up, or velocities have changed since.
  std::span<const Vector<D>> velocity_sums() const { return velocity_sum_; }
  void velocities_changed() { velocity_sum_.clear(); }

  // Particles that come and go as they are, see Migration.
  /// All that those at the given places have, in a message that begins with their number.
  std::vector<std::byte> pack(std::span<const std::uint32_t> places) const;
  /// Takes them in at the coming sort, each at its place.
  void unpack(std::span<const std::byte> packed, std::span<const CellPlace> places);
  /// No particle, and none has arrived.
  void clear();
  /// Gives back the memory of many who have left.
  void shrink();
  /// As std::rotate, within a cell.
  void rotate(std::size_t first, std::size_t middle, std::size_t last);

  /// Takes particles in the given order and sorts them into cells. Columns that it keeps and that are not given get their
  /// initial value, ids the numbers 0, 1, ... Throws InputError as insert().
  void assign(const Particles<D>& particles);

  /// The next particle to be inserted gets this id; never below it again. For restarts.
  std::uint64_t next_id() const { return next_id_; }
  void set_next_id(std::uint64_t id) { next_id_ = id; }

  /// Bytes that the store holds, by what is allocated.
  std::size_t bytes() const;

 private:
  void resize(std::size_t particles);
  void append(const Particles<D>& particles);
  std::size_t packed_size(std::size_t particles) const;
  void place_in_cell(std::size_t i);
  void fill(StoredColumn& column, std::size_t first, const Particles<D>& particles);
  void fill_ids(StoredColumn& column, std::size_t first, std::size_t count);

  LatticeOfCells<D> cells_;
  Column<Phase<D>> phase_, next_phase_;
  std::vector<std::unique_ptr<StoredColumn>> columns_;
  Column<Place> place_;
  std::vector<std::uint32_t> offset_, arrival_;  ///< by cell, one more for what is removed, and the end
  std::vector<Particles<D>> inserted_;           ///< wait for the sort
  bool sums_velocities_ = false;
  std::vector<Vector<D>> velocity_sum_;  ///< by cell, one more for what is removed
  std::uint64_t next_id_ = 0;
};

/// Particles in what ParticleStore::pack() gave.
std::uint64_t packed_count(std::span<const std::byte> packed);

extern template class ParticleStore<2>;
extern template class ParticleStore<3>;

}  // namespace sandglass
