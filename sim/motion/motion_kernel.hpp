#pragma once

#include "sim/motion/motion_stage.hpp"
#include "sim/motion/open_locator.hpp"

namespace sandglass::motion {

/// The loop over particles, for a `Flight` that carries one of them through the step and a `Flight::Locator` that finds the
/// cell where it arrives.
template <class Flight, bool Counts, int D = Flight::kDimension>
class MotionKernel final : public MotionStage<D> {
 public:
  explicit MotionKernel(typename Flight::Surroundings surroundings)
      : surroundings_(std::move(surroundings)) {}

  void advance(ParticleStore<D>& store, std::size_t first, std::size_t last,
               const MotionStep& step) const override {
    with_locator<Flight>(store.cells(), [&](auto locator) { fly(locator, store, first, last, step); });
  }

 private:
  void fly(const auto locator, ParticleStore<D>& store, std::size_t first, std::size_t last,
           const MotionStep& step) const {
    const Flight flight(surroundings_, store, step);
    Phase<D>* particles = store.phases().data();
    auto* places = store.places();
    std::uint32_t* arrivals = store.arrivals();
    for (std::size_t i = first; i < last; ++i) {
      const auto position = flight.template fly<Counts>(particles[i], i);
      const std::uint32_t cell = locator.cell_of(position);
      places[i] = {cell, arrivals[cell]++};
    }
  }

  typename Flight::Surroundings surroundings_;
};

}  // namespace sandglass::motion
