#include "sim/method/event_driven/from_scene.hpp"

#include "sim/method/event_driven/dispenser_agent.hpp"
#include "sim/method/event_driven/filter_agent.hpp"
#include "sim/method/event_driven/obstacle_agent.hpp"
#include "sim/method/event_driven/outflow_agent.hpp"
#include "sim/method/event_driven/plane_agent.hpp"
#include "sim/method/event_driven/wall_agent.hpp"
#include "sim/method/from_scene.hpp"

namespace sandglass::event_driven {

namespace {

SidePlace place_of(const Scene& scene, int axis, bool high) {
  return {axis, high, high ? scene.domain.size[static_cast<std::size_t>(axis)] : 0};
}

/// Null: what lies beyond the side sends nothing back for those who leave.
const Outflow* outflow_at(const Scene& scene, int axis, bool high) {
  for (const Outflow& outflow : scene.outflows)
    if (outflow.axis == axis && outflow.high == high) return &outflow;
  return nullptr;
}

template <int D>
Backflow<D> backflow_of(const Outflow& outflow, const Parameters<D>& parameters) {
  return Backflow<D>({outflow.axis, outflow.high, vector_of<D>(outflow.velocity), outflow.temperature,
                      parameters.faults.maxwellian_backflow},
                     parameters.species);
}

template <int D>
std::unique_ptr<Agent<D>> make_open_side(const Scene& scene, const SidePlace& place,
                                         const Parameters<D>& parameters, WallImpulses<D>* impulses) {
  const Outflow* outflow = outflow_at(scene, place.axis, place.high);
  if (outflow == nullptr || outflow->filter)
    return std::make_unique<OpenSideAgent<D>>(place, parameters.gravity, impulses);
  return std::make_unique<OutflowAgent<D>>(place, backflow_of(*outflow, parameters), parameters.gravity,
                                           impulses);
}

template <int D>
std::unique_ptr<Agent<D>> make_side(const Scene& scene, int axis, bool high, const Parameters<D>& parameters,
                                    WallImpulses<D>* impulses) {
  const SidePlace side = place_of(scene, axis, high);
  if (scene.domain.sides[static_cast<std::size_t>(axis)][high ? 1 : 0] == Side::open)
    return make_open_side(scene, side, parameters, impulses);
  const Wall wall = wall_of(scene, axis, high);
  const WallPlace<D> place{axis,
                           high,
                           side.edge,
                           vector_of<D>(wall.velocity),
                           wall.amplitude,
                           wall.frequency,
                           parameters.largest_diameter() / 2};
  return std::make_unique<WallAgent<D>>(place, wall_rule_of(scene, wall.surface), parameters.gravity,
                                        impulses);
}

/// Of disks.
std::unique_ptr<Agent<2>> make_filter(const Scene& scene, const Outflow& outflow,
                                      const Parameters<2>& parameters, WallImpulses<2>* impulses) {
  SidePlace place = place_of(scene, outflow.axis, outflow.high);
  place.edge += (outflow.high ? -1 : 1) * *outflow.filter;
  return std::make_unique<FilterAgent<2>>(place, backflow_of(outflow, parameters),
                                          vector_of<2>(outflow.velocity), impulses);
}

/// Of disks.
std::unique_ptr<Agent<2>> make_dispenser(const Scene& scene, std::size_t index,
                                         const Parameters<2>& parameters, const Streams& streams,
                                         WallImpulses<2>* impulses) {
  const Inflow& inflow = scene.inflows[index];
  const double side = volume(scene.domain) / scene.domain.size[static_cast<std::size_t>(inflow.axis)];
  const double count = layer_count(scene, inflow);
  const Layer<2> layer{inflow.species,
                       count,
                       count / (inflow.number_density * side),
                       vector_of<2>(inflow.velocity),
                       inflow.temperature,
                       inflow.spin_temperature,
                       index};
  WallRule piston;
  if (inflow.piston == Piston::thermal) {
    piston.kind = WallKind::thermal;
    piston.temperature = inflow.temperature;
  }
  return std::make_unique<DispenserAgent<2>>(place_of(scene, inflow.axis, inflow.high), layer, piston,
                                             parameters, streams, impulses);
}

}  // namespace

template <int D>
Parameters<D> parameters_of(const Scene& scene) {
  Parameters<D> parameters;
  parameters.geometry = {vector_of<D>(scene.domain.size), periodic_axes<D>(scene)};
  parameters.species = traits_of(scene);
  parameters.surfaces = surfaces_of(scene);
  parameters.rough = is_rough(scene);
  parameters.contact_time = guard_of(scene.method).contact_time;
  parameters.gravity = vector_of<D>(scene.gravity);
  parameters.keep_ids = scene.output.ids || scene.output.event_trace.has_value();
  parameters.particles = particle_count(scene) + added_count(scene);
  parameters.obstacles = scene.obstacles.size();
  for (const Outflow& outflow : scene.outflows) {
    if (!outflow.filter) continue;
    parameters.heavy = {vector_of<D>(outflow.velocity), place_of(scene, outflow.axis, outflow.high).number()};
    parameters.species.push_back(parameters.species.front());
    parameters.surfaces.assign(4, parameters.surfaces.front());
  }
  return parameters;
}

template <int D>
Agents<D> agents_of(const Scene& scene, const Parameters<D>& parameters, const Streams& streams,
                    std::vector<Plane>* planes, WallImpulses<D>* impulses) {
  Agents<D> agents;
  for (int axis = 0; axis < D; ++axis)
    if (!parameters.geometry.periodic[static_cast<std::size_t>(axis)])
      for (const bool high : {false, true})
        agents.push_back(make_side<D>(scene, axis, high, parameters, impulses));
  for (const Obstacle& obstacle : scene.obstacles)
    agents.push_back(std::make_unique<ObstacleAgent<D>>(
        vector_of<D>(obstacle.centre), obstacle.radius, wall_rule_of(scene, obstacle.surface),
        parameters.gravity, parameters.largest_diameter() / 2));
  if (planes != nullptr)
    for (Plane& plane : *planes)
      agents.push_back(std::make_unique<PlaneAgent<D>>(&plane, parameters.gravity));
  if constexpr (D == 2) {
    for (const Outflow& outflow : scene.outflows)
      if (outflow.filter) agents.push_back(make_filter(scene, outflow, parameters, impulses));
    for (std::size_t i = 0; i < scene.inflows.size(); ++i)
      if (scene.inflows[i].entry == InflowEntry::dispenser)
        agents.push_back(make_dispenser(scene, i, parameters, streams, impulses));
  }
  return agents;
}

template Parameters<2> parameters_of(const Scene&);
template Parameters<3> parameters_of(const Scene&);
template Agents<2> agents_of(const Scene&, const Parameters<2>&, const Streams&, std::vector<Plane>*,
                             WallImpulses<2>*);
template Agents<3> agents_of(const Scene&, const Parameters<3>&, const Streams&, std::vector<Plane>*,
                             WallImpulses<3>*);

}  // namespace sandglass::event_driven
