#include "sim/space/particle_store.hpp"

#include <limits>
#include <numeric>
#include <string>

#include "sim/base/error.hpp"

namespace sandglass {

template <int D>
void ParticleStore<D>::sort() {
  // arrival_[c + 2] counts cell c. After the sum, arrival_[c + 1] is where cell c begins; after the scatter, where it ends.
  std::inclusive_scan(arrival_.begin(), arrival_.end(), arrival_.begin());
  std::uint32_t* cursor = arrival_.data() + 1;
  const std::size_t count = phase_.size();
  for (std::size_t i = 0; i < count; ++i) next_phase_[cursor[destination_[i]]++] = phase_[i];
  if (keep_ids_) {
    // The scatter has moved every cursor to the end of its cell, which is where the next cell begins.
    for (std::size_t cell = grid_.size(); cell > 0; --cell) cursor[cell] = cursor[cell - 1];
    cursor[0] = 0;
    for (std::size_t i = 0; i < count; ++i) next_id_[cursor[destination_[i]]++] = id_[i];
    id_.swap(next_id_);
  }
  phase_.swap(next_phase_);
  offset_.swap(arrival_);
}

template <int D>
void ParticleStore<D>::assign(std::span<const Phase<D>> particles, std::span<const std::uint64_t> ids) {
  if (particles.size() > std::numeric_limits<std::uint32_t>::max())
    throw InputError("a run holds at most 4294967295 particles, got " + std::to_string(particles.size()));
  phase_.assign(particles.begin(), particles.end());
  next_phase_.resize(particles.size());
  destination_.resize(particles.size());
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
    destination_[i] = grid_.cell_of(phase_[i].position);
    ++arrivals()[destination_[i]];
  }
  sort();
}

template <int D>
std::size_t ParticleStore<D>::bytes() const {
  return (phase_.capacity() + next_phase_.capacity()) * sizeof(Phase<D>) +
         (id_.capacity() + next_id_.capacity()) * sizeof(std::uint64_t) +
         (destination_.capacity() + offset_.capacity() + arrival_.capacity()) * sizeof(std::uint32_t);
}

template class ParticleStore<2>;
template class ParticleStore<3>;

}  // namespace sandglass
