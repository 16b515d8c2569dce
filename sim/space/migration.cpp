#include "sim/space/migration.hpp"

#include <numeric>

namespace sandglass {

namespace {
using Bytes = Communicator::Bytes;

/// The cells of some particles, then all that these have.
template <int D>
Bytes message_of(const ParticleStore<D>& store, std::span<const std::uint32_t> places,
                 std::span<const std::uint32_t> cells) {
  if (places.empty()) return {};
  Bytes message = store.pack(places);
  const Bytes tail = bytes_of(cells);
  message.insert(message.end(), tail.begin(), tail.end());
  return message;
}

std::vector<std::uint32_t> cells_in(const Bytes& message) {
  std::vector<std::uint32_t> cells(packed_count(message));
  if (!cells.empty())
    std::memcpy(cells.data(), message.data() + message.size() - cells.size() * sizeof(std::uint32_t),
                cells.size() * sizeof(std::uint32_t));
  return cells;
}

/// `rank_in(cell)`: of the next particle among the arrivals of its cell.
template <int D, class RankInCell>
void take_in(ParticleStore<D>& store, const Bytes& message, RankInCell rank_in) {
  std::vector<CellPlace> places;
  for (const std::uint32_t cell : cells_in(message)) places.push_back({cell, rank_in(cell)});
  store.unpack(message, places);
}
}  // namespace

template <int D>
std::vector<Bytes> Migration<D>::take_leaving(ParticleStore<D>& store, const SharedCells& cells) {
  const std::uint32_t first = cells.first(), own = cells.last() - first, removed = store.removed();
  std::vector<std::vector<std::uint32_t>> places(cells.ranks().count()), arrive(places.size());
  CellPlace* place = store.places();
  std::uint32_t* arrivals = store.arrivals();
  for (std::uint32_t i = 0; i < store.size(); ++i) {
    const std::uint32_t cell = place[i].cell;
    if (cell - first < own || cell == removed) [[likely]]
      continue;
    const std::size_t owner = cells.owner(cell);
    places[owner].push_back(i);
    arrive[owner].push_back(cell);
    arrivals[cell] = 0;
    place[i] = {removed, arrivals[removed]++};
  }
  std::vector<Bytes> messages;
  for (std::size_t rank = 0; rank < places.size(); ++rank)
    messages.push_back(message_of<D>(store, places[rank], arrive[rank]));
  return messages;
}

template <int D>
void Migration<D>::make_room_for(ParticleStore<D>& store, const SharedCells& cells,
                                 std::span<const Bytes> from_below) {
  std::fill(from_below_.begin() + cells.first(), from_below_.begin() + cells.last(), 0u);
  bool any = false;
  for (const Bytes& message : from_below)
    for (const std::uint32_t cell : cells_in(message)) {
      ++from_below_[cell];
      any = true;
    }
  if (!any) return;
  CellPlace* place = store.places();
  for (std::size_t i = 0; i < store.size(); ++i)
    if (place[i].cell != store.removed()) place[i].rank += from_below_[place[i].cell];
  for (std::uint32_t cell = cells.first(); cell < cells.last(); ++cell)
    store.arrivals()[cell] += from_below_[cell];
}

template <int D>
void Migration<D>::apply(ParticleStore<D>& store, const SharedCells& cells) {
  const std::vector<Bytes> messages = cells.ranks().exchange(take_leaving(store, cells));
  const std::size_t rank = cells.ranks().rank();
  const std::span<const Bytes> all = messages;
  make_room_for(store, cells, all.first(rank));
  std::fill(from_below_.begin() + cells.first(), from_below_.begin() + cells.last(), 0u);
  for (const Bytes& message : all.first(rank))
    take_in(store, message, [this](std::uint32_t cell) { return from_below_[cell]++; });
  for (const Bytes& message : all.subspan(rank + 1))
    take_in(store, message, [&store](std::uint32_t cell) { return store.arrivals()[cell]++; });
}

template <int D>
void gather(const ParticleStore<D>& store, const SharedCells& cells, ParticleStore<D>& all) {
  std::vector<std::uint32_t> places(store.size()), in_cells;
  std::iota(places.begin(), places.end(), 0u);
  const auto offsets = store.offsets();
  for (std::uint32_t cell = cells.first(); cell < cells.last(); ++cell)
    in_cells.insert(in_cells.end(), offsets[cell + 1] - offsets[cell], cell);
  const auto messages = gather(cells.ranks(), message_of<D>(store, places, in_cells));
  if (!cells.ranks().is_first()) return;
  all.clear();
  for (const Bytes& message : messages)
    take_in(all, message, [&all](std::uint32_t cell) { return all.arrivals()[cell]++; });
  all.sort();
}

template class Migration<2>;
template class Migration<3>;
template void gather(const ParticleStore<2>&, const SharedCells&, ParticleStore<2>&);
template void gather(const ParticleStore<3>&, const SharedCells&, ParticleStore<3>&);

}  // namespace sandglass
