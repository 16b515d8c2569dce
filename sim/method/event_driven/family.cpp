#include "sim/method/event_driven/family.hpp"

#include "sim/method/boundary_faults.hpp"
#include "sim/method/collision_rate.hpp"
#include "sim/method/event_driven/from_scene.hpp"
#include "sim/method/event_driven/planted_faults.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::event_driven {

namespace {

/// Walls and obstacles at rest, smooth and elastic, closed sides, no gravity and no guard.
Scene elastic_scene(const Scene& scene) {
  Scene elastic = scene;
  elastic.walls.clear();
  for (auto& sides : elastic.domain.sides) std::ranges::replace(sides, Side::open, Side::specular);
  elastic.inflows.clear();
  elastic.outflows.clear();
  for (Obstacle& obstacle : elastic.obstacles) obstacle.surface = {};
  elastic.method.options = EventDrivenOptions{};
  return elastic;
}

template <int D>
class Builder final : public MethodBuilder<D> {
 public:
  explicit Builder(const BuildRequest& request)
      : scene_(request.scene),
        faulty_scene_(with_scene_fault(scene_, request.fault)),
        parameters_(parameters_of<D>(faulty_scene_)) {
    plant(planted_faults(), request.fault, parameters_);
    parameters_.measure_transfer = request.needs.transfer;
    parameters_.impact_bins = request.needs.impact_bins;
    parameters_.count_by_species = request.needs.by_species;
  }

  double collision_rate(double temperature) const override { return enskog_rate(scene_, temperature); }

  std::unique_ptr<Simulator<D>> build(const Streams& streams,
                                      const Attachments<D>& attachments) const override {
    Parameters<D> parameters = parameters_;
    parameters.planes = attachments.planes;
    parameters.impulses = attachments.impulses;
    return make_event_driven<D>(
        parameters, agents_of(faulty_scene_, parameters_, streams, attachments.planes, attachments.impulses),
        streams, attachments.trace);
  }

  /// No loss, spin or gravity, and no fault planted into what particles do.
  std::unique_ptr<Simulator<D>> build_elastic(const Streams& streams) const override {
    Parameters<D> elastic = parameters_;
    elastic.surfaces.assign(elastic.surfaces.size(), Surface{});
    elastic.rough = false;
    elastic.contact_time = 0;
    elastic.gravity.setZero();
    elastic.measure_transfer = false;
    elastic.impact_bins = 0;
    elastic.count_by_species = false;
    elastic.keep_ids = true;
    elastic.heavy.reset();
    elastic.faults = {};
    return make_event_driven<D>(
        elastic, agents_of<D>(elastic_scene(scene_), elastic, streams, nullptr, nullptr), streams);
  }

  /// A tenth of a mean free time.
  double elastic_step() const override { return 0.1 / enskog_rate(scene_, scene_.initial.temperature); }

  void plan(Plan& plan) const override {
    const double edge = parameters_.cell_edge();
    plan.cells = Cells<D>(parameters_.geometry, edge).size();
    plan.particles_per_cell = static_cast<double>(plan.particles) / static_cast<double>(plan.cells);
    plan.cell_size_in_mean_free_paths = edge / plan.mean_free_path;
    plan.particle_moves = 2 * plan.expected_collisions;  // only partners move
    const bool ids = keeps_ids();
    plan.bytes_per_particle = bytes_per_particle(static_cast<double>(plan.particles), ids);
    plan.columns = {"position", "velocity", "local time", "next event", "cell"};
    if (parameters_.rough) plan.columns.push_back("spin");
    if (parameters_.species.size() > 1) plan.columns.push_back("species");
    if (parameters_.contact_time > 0) plan.columns.push_back("last contact");
    if (ids) plan.columns.push_back("id");
    list_features(plan);
    plan.feature("particle identities", ids);
  }

 private:
  /// Also unasked: a wall or an obstacle that draws names its streams by particle.
  bool keeps_ids() const {
    const Agents<D> agents = agents_of<D>(scene_, parameters_, {}, nullptr, nullptr);
    return parameters_.keep_ids ||
           std::ranges::any_of(agents, [](const auto& agent) { return agent->draws(); });
  }

  /// The particle, what comes next, about two entries of the calendar with their slack, the view, and a head per cell.
  double bytes_per_particle(double particles, bool ids) const {
    const double cells = parameters_.geometry.box.prod() / std::pow(parameters_.cell_edge(), D) / particles;
    return sizeof(Particle<D>) + sizeof(Next) + 36 + sizeof(Phase<D>) + 4 * cells +
           (parameters_.rough ? sizeof(Spin<D>) : 0) + (parameters_.species.size() > 1 ? 1 : 0) +
           (parameters_.contact_time > 0 ? 8 : 0) + (ids ? sizeof(std::uint64_t) : 0);
  }

  void list_features(Plan& plan) const {
    const CollapseGuard guard = guard_of(scene_.method).kind;
    plan.feature("several species", parameters_.species.size() > 1);
    plan.feature("spins and rough contacts", parameters_.rough);
    plan.feature("collapse guard: contact time", guard == CollapseGuard::contact_time);
    plan.feature("collapse guard: velocity-dependent restitution",
                 guard == CollapseGuard::velocity_dependent);
    plan.feature("collisional virial (observer pressure)", parameters_.measure_transfer);
    plan.feature("impact parameters", parameters_.impact_bins > 0);
    plan.feature("heavy particles behind a filter", parameters_.heavy.has_value());
    plan.feature("event trace", scene_.output.event_trace.has_value());
  }

  Scene scene_;
  Scene faulty_scene_;  ///< the scene, with the planted fault of its boundaries if there is one
  Parameters<D> parameters_;
};

template <int D>
std::unique_ptr<MethodBuilder<D>> make_builder(const BuildRequest& request) {
  return std::make_unique<Builder<D>>(request);
}

}  // namespace

const FamilyBuilder& family() {
  static const FamilyBuilder all{"event-driven",
                                 names_of_faults(planted_faults(), boundary_faults(), exchange_faults()),
                                 make_builder<2>, make_builder<3>};
  return all;
}

}  // namespace sandglass::event_driven
