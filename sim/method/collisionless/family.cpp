#include "sim/method/collisionless/family.hpp"

#include "sim/method/boundary_faults.hpp"
#include "sim/method/collisionless/collisionless.hpp"
#include "sim/method/grid_from_scene.hpp"
#include "sim/method/motion_from_scene.hpp"

namespace sandglass::collisionless {

namespace {

/// Cells only keep the particles in order.
constexpr double kParticlesPerCell = 16;

using FaultChange = void (*)(Faults&);

const std::vector<FaultEntry<FaultChange>>& planted_faults() {
  static const std::vector<FaultEntry<FaultChange>> all = {
      {{"flight-plus-10-percent", "particles fly 10% longer than a step lasts"},
       [](Faults& faults) { faults.flight = 1.1; }}};
  return all;
}

template <int D>
class Builder final : public MethodBuilder<D> {
 public:
  explicit Builder(const BuildRequest& request)
      : scene_(request.scene),
        grid_(grid_of_edge<D>(scene_, edge_for(scene_, kParticlesPerCell))),
        motion_(motion_of<D>(with_scene_fault(scene_, request.fault))) {
    plant(planted_faults(), request.fault, faults_);
  }

  double collision_rate(double) const override { return 0; }

  std::unique_ptr<Simulator<D>> build(const Streams& streams,
                                      const Attachments<D>& attachments) const override {
    motion::MotionParameters<D> motion = motion_;
    motion.planes = attachments.planes;
    motion.impulses = attachments.impulses;
    return make(motion, streams, faults_);
  }
  std::unique_ptr<Simulator<D>> build_elastic(const Streams& streams) const override {
    return make(motion::conserving(motion_), streams, {});
  }

  void plan(Plan& plan) const override {
    plan.cells = grid_.size();
    plan.particles_per_cell = static_cast<double>(plan.particles) / static_cast<double>(plan.cells);
    plan.columns = {"position", "velocity", "cell"};
    if (scene_.output.ids) plan.columns.push_back("id");
    plan.bytes_per_particle = 2 * sizeof(Phase<D>) + sizeof(typename ParticleStore<D>::Place) +
                              (scene_.output.ids ? 16 : 0) + 8 / plan.particles_per_cell;
    plan.feature("walls with a rule", !motion_.walls.empty());
    plan.feature("particle identities", scene_.output.ids);
  }

 private:
  std::unique_ptr<Simulator<D>> make(const motion::MotionParameters<D>& motion, const Streams& streams,
                                     const Faults& faults) const {
    const Species& species = scene_.species.front();
    std::vector<ColumnInfo> columns;
    if (scene_.output.ids) columns.push_back(column::id);
    return std::make_unique<Collisionless<D>>(grid_, SpeciesTraits{species.diameter, species.mass},
                                              scene_.method.weight, motion, streams, columns, faults);
  }

  Scene scene_;
  Grid<D> grid_;
  motion::MotionParameters<D> motion_;
  Faults faults_;
};

template <int D>
std::unique_ptr<MethodBuilder<D>> make_builder(const BuildRequest& request) {
  return std::make_unique<Builder<D>>(request);
}

}  // namespace

const FamilyBuilder& family() {
  static const FamilyBuilder all{"collisionless",
                                 names_of_faults(planted_faults(), boundary_faults(), exchange_faults()),
                                 make_builder<2>, make_builder<3>};
  return all;
}

}  // namespace sandglass::collisionless
