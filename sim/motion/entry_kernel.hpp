#pragma once

#include "sim/motion/entry_stage.hpp"
#include "sim/motion/open_locator.hpp"
#include "sim/motion/stream_index.hpp"

#include <span>

namespace sandglass::motion {

/// The loop over the particles of each cell: a `Flight` looks where one would end, and flies it there if it may. A flight
/// with bounces, hundreds for who rests on a floor, is not flown again unless something counts them. A look changes spins at
/// rough surfaces.
template <class Flight, bool Counts, int D = Flight::kDimension>
class EntryKernel final : public EntryStage<D> {
 public:
  EntryKernel(typename Flight::Surroundings surroundings, bool offsets)
      : surroundings_(std::move(surroundings)), offsets_(offsets) {}

  std::uint64_t advance(ParticleStore<D>& store, std::uint32_t first, std::uint32_t last,
                        const MotionStep& step, const CellEntries& entries) const override {
    const std::span<Spin<D>> spins = store.column(column::spin<D>);
    return with_locator<Flight>(store.cells(), [&](auto locator) {
      return spins.empty() ? fly<false>(locator, store, spins, first, last, step, entries)
                           : fly<true>(locator, store, spins, first, last, step, entries);
    });
  }

 private:
  /// `Spins`: particles have them.
  template <bool Spins>
  std::uint64_t fly(const auto locator, ParticleStore<D>& store, [[maybe_unused]] std::span<Spin<D>> spins,
                    std::uint32_t first, std::uint32_t last, const MotionStep& step,
                    const CellEntries& entries) const {
    const auto offsets = store.offsets();
    const Flight flight(surroundings_, store, step);
    Phase<D>* particles = store.phases().data();
    auto* places = store.places();
    std::uint32_t* arrivals = store.arrivals();
    std::uint64_t refused = 0;
    Phase<D> arrived = {};
    for (std::uint32_t cell = first; cell < last; ++cell) {
      const bool within = !entries.within_too || entries.full[cell] == 0;
      for (std::uint32_t i = offsets[cell]; i < offsets[cell + 1]; ++i) {
        bool bounded = false;
        [[maybe_unused]] Spin<D> spin;
        if constexpr (Spins) spin = spins[i];
        std::uint32_t to = locator.cell_of(flight.look(particles[i], i, arrived, bounded));
        if ((to == cell && within) || admits(entries, to, cell, i - offsets[cell])) {
          if (bounded && !Counts) {
            particles[i] = arrived;
          } else {
            if constexpr (Spins) spins[i] = spin;
            flight.template fly<Counts>(particles[i], i);
          }
        } else {
          to = cell;
          if constexpr (Spins) spins[i] = spin;
          ++refused;
          if (offsets_) store.cells().put_into(cell, particles[i].position);
        }
        places[i] = {to, arrivals[to]++};
      }
    }
    return refused;
  }

  static bool admits(const CellEntries& entries, std::uint32_t to, std::uint32_t from, std::uint32_t place) {
    if (entries.full[to] != 0) return false;
    if (entries.probability == nullptr || entries.probability[to] >= 1) return true;
    return Random(entries.key, stream_index(from, place)).uniform() < entries.probability[to];
  }

  typename Flight::Surroundings surroundings_;
  bool offsets_;
};

}  // namespace sandglass::motion
