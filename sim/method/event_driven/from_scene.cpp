#include "sim/method/event_driven/from_scene.hpp"

#include "sim/method/event_driven/obstacle_agent.hpp"
#include "sim/method/event_driven/open_side_agent.hpp"
#include "sim/method/event_driven/plane_agent.hpp"
#include "sim/method/event_driven/wall_agent.hpp"
#include "sim/method/from_scene.hpp"

namespace sandglass::event_driven {

namespace {

template <int D>
std::unique_ptr<Agent<D>> make_side(const Scene& scene, int axis, bool high, const Parameters<D>& parameters,
                                    WallImpulses<D>* impulses) {
  const auto index = static_cast<std::size_t>(axis);
  const double edge = high ? scene.domain.size[index] : 0;
  if (scene.domain.sides[index][high ? 1 : 0] == Side::open)
    return std::make_unique<OpenSideAgent<D>>(SidePlace{axis, high, edge}, parameters.gravity, impulses);
  const Wall wall = wall_of(scene, axis, high);
  const WallPlace<D> place{wall.axis,
                           wall.high,
                           edge,
                           vector_of<D>(wall.velocity),
                           wall.amplitude,
                           wall.frequency,
                           parameters.largest_diameter() / 2};
  return std::make_unique<WallAgent<D>>(place, wall_rule_of(scene, wall.surface), parameters.gravity,
                                        impulses);
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
  return parameters;
}

template <int D>
Agents<D> agents_of(const Scene& scene, const Parameters<D>& parameters, std::vector<Plane>* planes,
                    WallImpulses<D>* impulses) {
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
  return agents;
}

template Parameters<2> parameters_of(const Scene&);
template Parameters<3> parameters_of(const Scene&);
template Agents<2> agents_of(const Scene&, const Parameters<2>&, std::vector<Plane>*, WallImpulses<2>*);
template Agents<3> agents_of(const Scene&, const Parameters<3>&, std::vector<Plane>*, WallImpulses<3>*);

}  // namespace sandglass::event_driven
