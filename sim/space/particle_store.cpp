#include "sim/space/particle_store.hpp"

#include "sim/base/error.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <string>

namespace sandglass {

namespace {
void require_one_value_each(const Columns& columns, std::size_t particles) {
  for (const NamedColumn& column : columns.all())
    if (column.particles() != particles)
      throw InputError("the particle column '" + column.info.name + "' holds " +
                       std::to_string(column.particles()) + " values for " + std::to_string(particles) +
                       " particles");
}

void require_room(std::size_t particles) {
  if (particles > std::numeric_limits<std::uint32_t>::max())
    throw InputError("a run holds at most 4294967295 particles, got " + std::to_string(particles));
}

std::size_t size_of(const ColumnInfo& info) {
  return info.components * (info.number == Number::byte ? 1 : 8);
}
/// Of a block in a message: all begin where any number may.
std::size_t block(std::size_t bytes) { return (bytes + 7) / 8 * 8; }

/// Copies the values at the places one behind the other; `size` of each.
void pick(const void* values, std::size_t size, std::span<const std::uint32_t> places, std::byte* to) {
  for (const std::uint32_t place : places) {
    std::memcpy(to, static_cast<const std::byte*>(values) + place * size, size);
    to += size;
  }
}
}  // namespace

std::uint64_t packed_count(std::span<const std::byte> packed) {
  std::uint64_t count = 0;
  if (!packed.empty()) std::memcpy(&count, packed.data(), sizeof count);
  return count;
}

template <int D>
ParticleStore<D>::ParticleStore(const LatticeOfCells<D>& cells, const std::vector<ColumnInfo>& columns)
    : cells_(cells), offset_(cells.size() + 2), arrival_(cells.size() + 2) {
  for (const ColumnInfo& info : columns) columns_.push_back(make_stored_column(info));
}

template <int D>
ColumnViews ParticleStore<D>::columns() const {
  ColumnViews views;
  for (const auto& column : columns_) views.add(column->view());
  return views;
}

template <int D>
void ParticleStore<D>::sort() {
  for (const Particles<D>& particles : inserted_) append(particles);
  inserted_.clear();
  // arrival_[c + 1] counts cell c; after the sum, arrival_[c] is where cell c begins.
  std::inclusive_scan(arrival_.begin(), arrival_.end(), arrival_.begin());
  velocity_sum_.assign(sums_velocities_ ? cells_.size() + 1 : 0, Vector<D>::Zero());
  if (sums_velocities_)
    scatter(phase_, place_, arrival_.data(), next_phase_,
            [sum = velocity_sum_.data()](std::uint32_t cell, const Phase<D>& particle) {
              sum[cell] += particle.velocity;
            });
  else
    scatter(phase_, place_, arrival_.data(), next_phase_);
  phase_.swap(next_phase_);
  for (const auto& column : columns_) column->sort(place_, arrival_.data());
  offset_.swap(arrival_);
  if (offset_[removed()] < size()) resize(offset_[removed()]);
}

template <int D>
void ParticleStore<D>::stay(std::span<const std::uint32_t> leaving) {
  std::vector<bool> leaves(size());
  for (const std::uint32_t place : leaving) leaves.at(place) = true;
  begin_step();
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell)
    for (std::uint32_t i = offset_[cell]; i < offset_[cell + 1]; ++i) {
      const std::uint32_t arrives = leaves[i] ? removed() : cell;
      place_[i] = {arrives, arrivals()[arrives]++};
    }
}

template <int D>
void ParticleStore<D>::drop(std::span<const std::uint32_t> leaving) {
  for (const std::uint32_t place : leaving) place_[place].cell = removed();
  begin_step();
  for (Place& place : place_) place.rank = arrivals()[place.cell]++;
}

template <int D>
void ParticleStore<D>::find_cells() {
  begin_step();
  for (std::size_t i = 0; i < size(); ++i)
    if (place_[i].cell == removed())
      place_[i].rank = arrivals()[removed()]++;
    else
      place_in_cell(i);
}

template <int D>
void ParticleStore<D>::place_in_cell(std::size_t i) {
  const std::uint32_t cell = cells_.cell_of(phase_[i].position);
  place_[i] = {cell, arrivals()[cell]++};
}

template <int D>
void ParticleStore<D>::insert(const Particles<D>& particles) {
  require_one_value_each(particles.columns, particles.phases.size());
  require_room(size() + particles.phases.size());
  inserted_.push_back(particles);
  inserted_.back().columns.remove(column::id.name);
}

template <int D>
void ParticleStore<D>::append(const Particles<D>& particles) {
  const std::size_t first = size();
  resize(first + particles.phases.size());
  std::copy(particles.phases.begin(), particles.phases.end(),
            phase_.begin() + static_cast<std::ptrdiff_t>(first));
  for (const auto& column : columns_) fill(*column, first, particles);
  for (std::size_t i = first; i < size(); ++i) place_in_cell(i);
}

template <int D>
void ParticleStore<D>::fill(StoredColumn& column, std::size_t first, const Particles<D>& particles) {
  const ColumnInfo info = column.view().info;
  if (const NamedColumn* given = particles.columns.find(info))
    column.write(first, given->view());
  else if (info.fits(column::id))
    fill_ids(column, first, particles.phases.size());
}

template <int D>
void ParticleStore<D>::fill_ids(StoredColumn& column, std::size_t first, std::size_t count) {
  std::vector<std::uint64_t> ids(count);
  std::iota(ids.begin(), ids.end(), next_id_);
  column.write(first, {column::id, ids.data(), count});
  next_id_ += count;
}

template <int D>
std::size_t ParticleStore<D>::packed_size(std::size_t particles) const {
  std::size_t size = sizeof(std::uint64_t) + particles * sizeof(Phase<D>);
  for (const auto& column : columns_) size += block(particles * size_of(column->view().info));
  return size;
}

template <int D>
std::vector<std::byte> ParticleStore<D>::pack(std::span<const std::uint32_t> places) const {
  std::vector<std::byte> packed(packed_size(places.size()));
  const std::uint64_t count = places.size();
  std::memcpy(packed.data(), &count, sizeof count);
  std::byte* to = packed.data() + sizeof count;
  pick(phase_.data(), sizeof(Phase<D>), places, to);
  to += count * sizeof(Phase<D>);
  for (const auto& column : columns_) {
    const ColumnView values = column->view();
    pick(values.numbers, size_of(values.info), places, to);
    to += block(count * size_of(values.info));
  }
  return packed;
}

template <int D>
void ParticleStore<D>::unpack(std::span<const std::byte> packed, std::span<const CellPlace> places) {
  if (places.empty()) return;
  const std::size_t first = size(), count = places.size();
  resize(first + count);
  std::copy(places.begin(), places.end(), place_.begin() + static_cast<std::ptrdiff_t>(first));
  const std::byte* from = packed.data() + sizeof(std::uint64_t);
  std::memcpy(static_cast<void*>(phase_.data() + first), from, count * sizeof(Phase<D>));
  from += count * sizeof(Phase<D>);
  for (const auto& column : columns_) {
    const ColumnInfo info = column->view().info;
    column->write(first, {info, from, count});
    from += block(count * size_of(info));
  }
}

template <int D>
void ParticleStore<D>::clear() {
  resize(0);
  begin_step();
}

/// A few more may arrive than leave.
template <int D>
void ParticleStore<D>::shrink() {
  const std::size_t room = size() + size() / 8;
  sandglass::shrink(phase_, room);
  sandglass::shrink(next_phase_, room);
  sandglass::shrink(place_, room);
  for (const auto& column : columns_) column->shrink(room);
}

template <int D>
void ParticleStore<D>::rotate(std::size_t first, std::size_t middle, std::size_t last) {
  sandglass::rotate(phase_, first, middle, last);
  for (const auto& column : columns_) column->rotate(first, middle, last);
}

template <int D>
void ParticleStore<D>::assign(const Particles<D>& particles) {
  require_room(particles.phases.size());
  require_one_value_each(particles.columns, particles.phases.size());
  resize(0);
  inserted_.clear();
  next_id_ = 0;
  begin_step();
  append(particles);
  for (const std::uint64_t id : ids()) next_id_ = std::max(next_id_, id + 1);
  sort();
}

template <int D>
void ParticleStore<D>::resize(std::size_t particles) {
  phase_.resize(particles);
  next_phase_.resize(particles);
  place_.resize(particles);
  for (const auto& column : columns_) column->resize(particles);
}

template <int D>
std::size_t ParticleStore<D>::bytes() const {
  std::size_t bytes = (phase_.capacity() + next_phase_.capacity()) * sizeof(Phase<D>) +
                      place_.capacity() * sizeof(Place) +
                      (offset_.capacity() + arrival_.capacity()) * sizeof(std::uint32_t) +
                      velocity_sum_.capacity() * sizeof(Vector<D>) + cells_.bytes();
  for (const auto& column : columns_) bytes += column->bytes();
  return bytes;
}

template class ParticleStore<2>;
template class ParticleStore<3>;

}  // namespace sandglass
