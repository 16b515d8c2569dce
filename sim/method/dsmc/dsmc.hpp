#pragma once

#include "sim/method/dsmc/collision_stage.hpp"
#include "sim/method/dsmc/local_factor.hpp"
#include "sim/method/dsmc/motion_stage.hpp"
#include "sim/method/simulator.hpp"

#include <memory>
#include <optional>

namespace sandglass::dsmc {

/// Direct simulation Monte Carlo and its dense-gas variants in D dimensions. A step collides the particles of each cell,
/// moves them, and sorts them into the cells where they arrive.
template <int D>
class Dsmc final : public Simulator<D> {
 public:
  /// `purpose` names the streams of the collisions; ids are kept only if asked for.
  Dsmc(const Grid<D>& grid, const Parameters& parameters, const MotionParameters<D>& motion,
       const Streams& streams, Purpose purpose = Purpose::collisions, bool keep_ids = false);

  void assign(const Particles<D>& particles) override;
  void step(double dt, std::uint64_t step) override;
  View<D> view() override;
  std::span<const std::uint64_t> ids() const override { return store_.ids(); }
  std::uint64_t size() const override { return store_.size(); }
  Tally& tally() override { return tally_; }
  std::map<std::string, double> counters() const override;
  Memory save() const override;
  void load(const Memory& memory) override;
  std::size_t bytes() const override;

 private:
  void collide_and_move(double dt, const CollisionStep<D>& collisions);

  Parameters parameters_;
  Streams streams_;
  Purpose purpose_;
  MotionParameters<D> motion_parameters_;
  ParticleStore<D> store_;
  std::unique_ptr<CollisionStage<D>> collisions_;
  std::unique_ptr<MotionStage<D>> motion_;
  std::optional<LocalContactFactor<D>> factor_;
  Tally tally_;
  std::uint64_t bound_raised_ = 0;
};

extern template class Dsmc<2>;
extern template class Dsmc<3>;

}  // namespace sandglass::dsmc
