#pragma once

#include "sim/method/event_driven/agent.hpp"
#include "sim/method/event_driven/open_side_agent.hpp"
#include "sim/method/event_driven/parameters.hpp"
#include "sim/method/simulator.hpp"
#include "sim/physics/wall.hpp"

namespace sandglass::event_driven {

/// What a dispenser lays behind its piston.
template <int D>
struct Layer {
  std::size_t species = 0;
  double count = 1;                        ///< particles
  double width = 1;                        ///< of the strip that they fill at the density of the stream
  Vector<D> velocity = Vector<D>::Zero();  ///< of the stream; the piston moves with its normal part
  double temperature = 0, spin_temperature = 0;
  std::size_t stream = 0;  ///< names the random numbers
};

/// A piston that moves into the box from a side, at the speed of the stream. When it has made room for a layer it jumps
/// back, and the layer is laid where it was: a row at random, the velocities Maxwell's about the stream (Baryshev 2003,
/// 3.3, figure 3.9). Disks.
///
/// The jump needs no search: who would touch the piston now would have touched it sooner where it was, comes back at that
/// time, finds nothing and looks again.
template <int D>
class DispenserAgent final : public Agent<D> {
 public:
  DispenserAgent(const SidePlace& place, const Layer<D>& layer, const WallRule& piston,
                 const Parameters<D>& parameters, const Streams& streams,
                 WallImpulses<D>* impulses = nullptr);

  Box<D> reach() const override;
  double delay(const ParticleState<D>& particle, double now) const override;
  bool draws() const override { return sandglass::draws(piston_); }
  Outcome act(ParticleState<D>& particle, double now, Random& random) override;
  double next() const override;
  void act(ParticleAccess<D>& particles, double now) override;
  void count(std::map<std::string, double>& counters) const override;
  std::vector<double> save() const override;
  void load(const std::vector<double>& state) override;

 private:
  double inward() const { return place_.high ? -1 : 1; }
  double piston_at(double now) const;
  /// Of the surface of a particle in front of the piston.
  double height(const ParticleState<D>& particle, double now) const;
  std::vector<double> row(Random& random) const;
  Newcomer<D> newcomer(double along, Random& random) const;
  void let_in(ParticleAccess<D>& particles, const Newcomer<D>& newcomer);

  SidePlace place_;
  Layer<D> layer_;
  WallRule piston_;
  SpeciesTraits traits_;
  double gravity_, speed_;  ///< along the inward normal
  double length_;           ///< of the side
  bool round_;              ///< it is periodic
  double reach_;
  Faults faults_;
  Streams streams_;
  WallImpulses<D>* impulses_;
  std::uint64_t layers_ = 0, entered_ = 0;
};

extern template class DispenserAgent<2>;

}  // namespace sandglass::event_driven
