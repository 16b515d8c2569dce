#include "sim/space/migration.hpp"

#include <algorithm>
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

/// Behind those that arrive in their cells already.
template <int D>
void take_in(ParticleStore<D>& store, const Bytes& message) {
  std::vector<CellPlace> places;
  for (const std::uint32_t cell : cells_in(message)) places.push_back({cell, store.arrivals()[cell]++});
  store.unpack(message, places);
}

/// Those who arrive in cells of others, in messages to these, and out of the store at the coming sort.
template <int D>
std::vector<Bytes> take_leaving(ParticleStore<D>& store, const SharedCells& cells) {
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

/// A cell where particles from lower ranks arrive.
struct Mixed {
  std::uint32_t cell, own, from_below;
};

std::vector<Mixed> mixed_cells(std::span<const Bytes> from_below, const std::uint32_t* arrivals) {
  std::vector<std::uint32_t> arrive;
  for (const Bytes& message : from_below) {
    const std::vector<std::uint32_t> cells = cells_in(message);
    arrive.insert(arrive.end(), cells.begin(), cells.end());
  }
  std::ranges::sort(arrive);
  std::vector<Mixed> mixed;
  for (const std::uint32_t cell : arrive) {
    if (mixed.empty() || mixed.back().cell != cell) mixed.push_back({cell, arrivals[cell], 0});
    ++mixed.back().from_below;
  }
  return mixed;
}
}  // namespace

/// Those from lower ranks are put before the own ones when all stand in their cells: few cells have any.
template <int D>
void migrate_and_sort(ParticleStore<D>& store, const SharedCells& cells) {
  const std::vector<Bytes> messages = cells.ranks().exchange(take_leaving(store, cells));
  const std::span<const Bytes> from_below = std::span(messages).first(cells.ranks().rank());
  const std::vector<Mixed> mixed = mixed_cells(from_below, store.arrivals());
  for (const Bytes& message : messages) take_in(store, message);
  store.sort();
  for (const auto& [cell, own, below] : mixed) {
    const std::size_t first = store.offsets()[cell];
    store.rotate(first, first + own, first + own + below);
  }
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
  for (const Bytes& message : messages) take_in(all, message);
  all.sort();
}

template void migrate_and_sort(ParticleStore<2>&, const SharedCells&);
template void migrate_and_sort(ParticleStore<3>&, const SharedCells&);
template void gather(const ParticleStore<2>&, const SharedCells&, ParticleStore<2>&);
template void gather(const ParticleStore<3>&, const SharedCells&, ParticleStore<3>&);

}  // namespace sandglass
