#include "sim/space/particle_store.hpp"

#include "sim/base/error.hpp"

#include <limits>
#include <numeric>
#include <string>

namespace sandglass {

template <int D>
void ParticleStore<D>::sort() {
  // arrival_[c + 1] counts cell c; after the sum, arrival_[c] is where cell c begins.
  std::inclusive_scan(arrival_.begin(), arrival_.end(), arrival_.begin());
  const std::uint32_t* begin = arrival_.data();
  const std::size_t count = phase_.size();
  for (std::size_t i = 0; i < count; ++i) next_phase_[begin[place_[i].cell] + place_[i].rank] = phase_[i];
  phase_.swap(next_phase_);
  if (keep_ids_) {
    for (std::size_t i = 0; i < count; ++i) next_id_[begin[place_[i].cell] + place_[i].rank] = id_[i];
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
