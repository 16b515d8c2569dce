#pragma once

#include "sim/method/cell_simulator.hpp"
#include "sim/method/mixing/pair_forces.hpp"
#include "sim/method/mixing/parameters.hpp"

#include <optional>
#include <vector>

namespace sandglass::mixing {

/// Cells as wide as the cutoff; without one, a single cell.
Grid<2> cells_of(const Parameters& parameters);

/// Greenspan's discrete model of two fluids (1972): particles of given mass that repel each other and feel the part of
/// gravity that those below them leave. Leapfrog, half a kick first: positions are those of the time that a view shows,
/// velocities those of half a step before.
class Mixing final : public CellSimulator<2> {
 public:
  Mixing(const Parameters& parameters, const Streams& streams);

  /// Step 0 is the first and gives half a kick.
  void step(double dt, std::uint64_t step) override;
  /// Pairs within the cutoff and reflections at walls since time zero.
  std::map<std::string, double> counters() const override;
  Memory save() const override;
  void load(const Memory& memory) override;
  std::size_t bytes() const override;

 private:
  void accelerate();
  void move(double kick, double dt, std::uint64_t step);
  [[noreturn]] void refuse(std::uint64_t step, double dt, const Phase<2>& particle) const;
  double mass(std::size_t particle, std::span<const std::uint8_t> species) const;

  Parameters parameters_;
  PairForces pairs_;
  std::optional<Support> support_;
  std::vector<double> masses_;
  std::vector<Vector<2>> accelerations_;
  std::uint64_t pairs_in_range_ = 0, reflections_ = 0;
};

}  // namespace sandglass::mixing
