#include "sim/space/particle_store.hpp"

#include "sim/base/error.hpp"

#include <limits>
#include <numeric>
#include <string>

namespace sandglass {

namespace {
/// Every address is known beforehand: the line of a particle this far ahead is on its way while others are copied.
constexpr std::size_t kAhead = 12;

template <class T, class Place>
void scatter(const Column<T>& from, const Column<Place>& places, const std::uint32_t* begin, Column<T>& to) {
  const T* source = from.data();
  const Place* place = places.data();
  T* target = to.data();
  const auto slot = [begin, place](std::size_t i) { return begin[place[i].cell] + place[i].rank; };
  const std::size_t count = from.size(), ahead = count > kAhead ? count - kAhead : 0;
  for (std::size_t i = 0; i < ahead; ++i) {
    __builtin_prefetch(target + slot(i + kAhead), 1);
    target[slot(i)] = source[i];
  }
  for (std::size_t i = ahead; i < count; ++i) target[slot(i)] = source[i];
}
}  // namespace

template <int D>
void ParticleStore<D>::sort() {
  // arrival_[c + 1] counts cell c; after the sum, arrival_[c] is where cell c begins.
  std::inclusive_scan(arrival_.begin(), arrival_.end(), arrival_.begin());
  scatter(phase_, place_, arrival_.data(), next_phase_);
  phase_.swap(next_phase_);
  if (keep_ids_) {
    scatter(id_, place_, arrival_.data(), next_id_);
    id_.swap(next_id_);
  }
  offset_.swap(arrival_);
}

template <int D>
void ParticleStore<D>::assign(std::span<const Phase<D>> particles, std::span<const std::uint64_t> ids) {
  if (particles.size() > std::numeric_limits<std::uint32_t>::max())
    throw InputError("a run holds at most 4294967295 particles, got " + std::to_string(particles.size()));
  phase_.assign(particles.begin(), particles.end());
  next_phase_.resize(particles.size());
  place_.resize(particles.size());
  if (keep_ids_) {
    id_.resize(particles.size());
    next_id_.resize(particles.size());
    if (ids.empty())
      std::iota(id_.begin(), id_.end(), std::uint64_t{0});
    else
      id_.assign(ids.begin(), ids.end());
  }
  begin_step();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const std::uint32_t cell = grid_.cell_of(phase_[i].position);
    place_[i] = {cell, arrivals()[cell]++};
  }
  sort();
}

template <int D>
std::size_t ParticleStore<D>::bytes() const {
  return (phase_.capacity() + next_phase_.capacity()) * sizeof(Phase<D>) +
         (id_.capacity() + next_id_.capacity()) * sizeof(std::uint64_t) + place_.capacity() * sizeof(Place) +
         (offset_.capacity() + arrival_.capacity()) * sizeof(std::uint32_t);
}

template class ParticleStore<2>;
template class ParticleStore<3>;

}  // namespace sandglass
