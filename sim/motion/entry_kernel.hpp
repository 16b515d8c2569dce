#pragma once

#include "sim/motion/entry_stage.hpp"
#include "sim/motion/open_locator.hpp"
#include "sim/motion/stream_index.hpp"

#include <span>

namespace sandglass::motion {

/// The loop over the particles of each cell: a `Flight` looks where one would end, and flies it there if it may.
template <class Flight, bool Counts, int D = Flight::kDimension>
class EntryKernel final : public EntryStage<D> {
 public:
  EntryKernel(typename Flight::Surroundings surroundings, bool offsets)
      : surroundings_(std::move(surroundings)), offsets_(offsets) {}

  std::uint64_t advance(ParticleStore<D>& store, std::uint32_t first, std::uint32_t last,
                        const MotionStep& step, const CellEntries& entries) const override {
    return with_locator<Flight>(
        store.cells(), [&](auto locator) { return fly(locator, store, first, last, step, entries); });
  }

 private:
  using Real = typename Lanes<D>::Real;

  std::uint64_t fly(const auto locator, ParticleStore<D>& store, std::uint32_t first, std::uint32_t last,
                    const MotionStep& step, const CellEntries& entries) const {
    const auto offsets = store.offsets();
    // The second pair is for calls: nobody sees the first, which therefore stays in registers.
    const Flight flight(surroundings_, store, step), other_flight(flight);
    const auto other_locator = locator;
    Phase<D>* particles = store.phases().data();
    auto* places = store.places();
    std::uint32_t* arrivals = store.arrivals();
    const std::uint8_t* full = entries.full;
    const bool draws = entries.probability != nullptr;
    std::uint64_t refused = 0;
    for (std::uint32_t cell = first; cell < last; ++cell) {
      const bool within = !entries.within_too || full[cell] == 0;
      for (std::uint32_t i = offsets[cell], end = offsets[cell + 1]; i < end; ++i) {
        std::uint32_t to = cell;
        Real arrived;
        const bool free = flight.is_free(particles[i], arrived);
        if (free) to = locator.cell_of(flight.in_box(arrived));
        if (free && (to == cell ? within : full[to] == 0 && !draws)) [[likely]]
          flight.template fly_free<Counts>(particles[i], arrived);
        else
          to = fly_or_stay(other_flight, other_locator, store, i, cell, entries, refused);
        places[i] = {to, arrivals[to]++};
      }
    }
    return refused;
  }

  /// Whatever the path meets and the entry asks; the answer is the cell where it ends. A flight with bounces, hundreds for
  /// who rests on a floor, is not flown again unless something counts them. A look changes spins at rough surfaces.
  template <class Locator>
  [[gnu::noinline]] std::uint32_t fly_or_stay(const Flight& flight, const Locator& locator,
                                              ParticleStore<D>& store, std::uint32_t i, std::uint32_t cell,
                                              const CellEntries& entries, std::uint64_t& refused) const {
    Phase<D>& particle = store.phases()[i];
    const std::span<Spin<D>> spins = store.column(column::spin<D>);
    const Spin<D> spin = spins.empty() ? Spin<D>::Zero() : spins[i];
    Phase<D> arrived = {};
    bool bounded = false;
    const std::uint32_t to = locator.cell_of(flight.look(particle, i, arrived, bounded));
    const bool admitted = admits(entries, to, cell, i - store.offsets()[cell]);
    if (admitted && bounded && !Counts) {
      particle = arrived;
      return to;
    }
    if (!spins.empty()) spins[i] = spin;
    if (admitted) {
      flight.template fly<Counts>(particle, i);
      return to;
    }
    ++refused;
    if (offsets_) store.cells().put_into(cell, particle.position);
    return cell;
  }

  static bool admits(const CellEntries& entries, std::uint32_t to, std::uint32_t from, std::uint32_t place) {
    if (to == from && !entries.within_too) return true;
    if (entries.full[to] != 0) return false;
    if (to == from || entries.probability == nullptr || entries.probability[to] >= 1) return true;
    return Random(entries.key, stream_index(from, place)).uniform() < entries.probability[to];
  }

  typename Flight::Surroundings surroundings_;
  bool offsets_;
};

}  // namespace sandglass::motion
