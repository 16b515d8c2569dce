#include "sim/method/reservoir/family.hpp"

#include "sim/method/collision_rate.hpp"
#include "sim/method/reservoir/reservoir.hpp"

namespace sandglass::reservoir {

namespace {

using FaultChange = void (*)(Faults&);

const std::vector<FaultEntry<FaultChange>>& planted_faults() {
  static const std::vector<FaultEntry<FaultChange>> all = {
      {{"crossing-velocity-maxwellian",
        "crossing velocities from the Maxwellian instead of the flux distribution"},
       [](Faults& faults) { faults.maxwellian = true; }},
      {{"flux-rate-net", "crossings at the net rate in both directions"},
       [](Faults& faults) { faults.net_rate = true; }}};
  return all;
}

/// The plane is that of the first observer.
Parameters parameters_of(const Scene& scene) {
  const auto axis = static_cast<std::size_t>(scene.observe.empty() ? 0 : scene.observe.front().axis);
  Parameters parameters;
  parameters.number_density = number_density(scene, scene.species.front());
  parameters.area = volume(scene.domain) / scene.domain.size[axis];
  parameters.stream = scene.initial.velocity.empty() ? 0 : scene.initial.velocity[axis];
  parameters.thermal = thermal_speed(scene);
  return parameters;
}

template <int D>
class Builder final : public MethodBuilder<D> {
 public:
  explicit Builder(const BuildRequest& request) : parameters_(parameters_of(request.scene)) {
    plant(planted_faults(), request.fault, parameters_.faults);
  }
  double collision_rate(double) const override { return 0; }
  std::unique_ptr<Simulator<D>> build(const Streams& streams,
                                      const Attachments<D>& attachments) const override {
    return std::make_unique<Reservoir<D>>(parameters_, streams, attachments.planes);
  }
  /// It has no particles to bring to equilibrium.
  std::unique_ptr<Simulator<D>> build_elastic(const Streams& streams) const override {
    return build(streams, {});
  }
  void plan(Plan&) const override {}

 private:
  Parameters parameters_;
};

template <int D>
std::unique_ptr<MethodBuilder<D>> make_builder(const BuildRequest& request) {
  return std::make_unique<Builder<D>>(request);
}

}  // namespace

const FamilyBuilder& family() {
  static const FamilyBuilder all{"reservoir", names_of_faults(planted_faults()), make_builder<2>,
                                 make_builder<3>};
  return all;
}

}  // namespace sandglass::reservoir
