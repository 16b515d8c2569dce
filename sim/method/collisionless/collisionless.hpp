#pragma once

#include "sim/method/cell_simulator.hpp"

namespace sandglass::collisionless {

/// Faults that the mutant suite plants.
struct Faults {
  double flight = 1;  ///< factor on the time that particles fly in a step
};

/// Particles that never collide: the Knudsen limit of a gas between walls, obstacles and planes.
template <int D>
class Collisionless final : public CellSimulator<D> {
 public:
  Collisionless(const Grid<D>& grid, const SpeciesTraits& traits, double weight,
                const motion::MotionParameters<D>& motion, const Streams& streams,
                const std::vector<ColumnInfo>& columns = {}, const Faults& faults = {})
      : CellSimulator<D>(grid, {traits}, weight, motion, streams, columns), faults_(faults) {}

  void step(double dt, std::uint64_t step) override;

 private:
  Faults faults_;
};

extern template class Collisionless<2>;
extern template class Collisionless<3>;

}  // namespace sandglass::collisionless
