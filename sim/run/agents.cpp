#include "sim/run/agents.hpp"

#include "sim/method/event_driven/obstacle_agent.hpp"
#include "sim/method/event_driven/plane_agent.hpp"
#include "sim/method/event_driven/wall_agent.hpp"
#include "sim/run/setup.hpp"

#include <limits>

namespace sandglass {

namespace {

using namespace event_driven;

constexpr double kSticks = std::numeric_limits<double>::infinity();

/// Of the velocity-dependent guard; zero without.
double reference_speed(const Scene& scene) {
  return scene.method.guard == CollapseGuard::velocity_dependent ? scene.method.reference_speed : 0;
}

Surface surface_of(const Scene& scene, const Species& species) {
  return {{species.restitution, reference_speed(scene)},
          species.tangential_restitution,
          species.friction.value_or(kSticks)};
}

WallKind kind_of(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::specular:
      return WallKind::specular;
    case SurfaceKind::bounce_back:
      return WallKind::bounce_back;
    case SurfaceKind::random_tangential_sign:
      return WallKind::random_tangential_sign;
    case SurfaceKind::thermal:
      return WallKind::thermal;
  }
  return WallKind::specular;
}

/// The velocity-dependent guard holds at walls as well: a ball on the floor collapses as a row of particles does.
WallRule rule_of(const Scene& scene, const SurfaceRule& surface, const AgentFaults& faults) {
  WallRule rule;
  rule.kind = kind_of(surface.rule);
  rule.surface = {{surface.restitution, reference_speed(scene)},
                  surface.tangential_restitution,
                  surface.friction.value_or(kSticks)};
  rule.probability = surface.probability;
  rule.temperature = surface.temperature;
  return faults.changed(rule);
}

template <int D>
Vector<D> vector_of(const std::vector<double>& values) {
  return values.empty() ? Vector<D>(Vector<D>::Zero())
                        : Vector<D>(Eigen::Map<const Vector<D>>(values.data()));
}

/// What the scene says of a side, or a smooth elastic wall at rest.
Wall wall_of(const Scene& scene, int axis, bool high) {
  for (const Wall& wall : scene.walls)
    if (wall.axis == axis && wall.high == high) return wall;
  Wall plain;
  plain.axis = axis;
  plain.high = high;
  return plain;
}

template <int D>
std::unique_ptr<Agent<D>> make_wall(const Scene& scene, const Wall& wall, const Parameters<D>& hard) {
  const double edge = wall.high ? scene.domain.size[static_cast<std::size_t>(wall.axis)] : 0;
  const WallPlace<D> place{wall.axis,
                           wall.high,
                           edge,
                           vector_of<D>(wall.velocity),
                           wall.amplitude,
                           wall.frequency,
                           hard.largest_diameter() / 2};
  return std::make_unique<WallAgent<D>>(hard.agent_faults.changed(place),
                                        rule_of(scene, wall.surface, hard.agent_faults), hard.gravity);
}

}  // namespace

template <int D>
Parameters<D> hard_parameters_of(const Scene& scene) {
  Parameters<D> hard;
  hard.geometry.box = vector_of<D>(scene.domain.size);
  for (std::size_t axis = 0; axis < D; ++axis)
    hard.geometry.periodic[axis] = scene.domain.sides[axis][0] == Side::periodic;
  hard.species.clear();
  hard.surfaces.clear();
  for (const Species& species : scene.species) {
    const double radius = species.diameter / 2;
    hard.species.push_back(
        {species.diameter, species.mass, inertia_factor(species, D) * species.mass * radius * radius});
    for (const Species& other : scene.species)
      hard.surfaces.push_back(mix(surface_of(scene, species), surface_of(scene, other)));
  }
  hard.rough = is_rough(scene);
  hard.contact_time = scene.method.guard == CollapseGuard::contact_time ? scene.method.contact_time : 0;
  hard.gravity = vector_of<D>(scene.gravity);
  hard.keep_ids = scene.output.ids || scene.output.event_trace.has_value();
  hard.particles = particle_count(scene);
  hard.obstacles = scene.obstacles.size();
  return hard;
}

template <int D>
Agents<D> make_agents(const Scene& scene, const Setup<D>& setup, std::vector<Plane>* planes) {
  Agents<D> agents;
  for (int axis = 0; axis < D; ++axis)
    if (!setup.hard.geometry.periodic[static_cast<std::size_t>(axis)])
      for (const bool high : {false, true})
        agents.push_back(make_wall<D>(scene, wall_of(scene, axis, high), setup.hard));
  for (const Obstacle& obstacle : scene.obstacles)
    agents.push_back(std::make_unique<ObstacleAgent<D>>(
        vector_of<D>(obstacle.centre), setup.hard.agent_faults.obstacle_radius * obstacle.radius,
        rule_of(scene, obstacle.surface, setup.hard.agent_faults), setup.hard.gravity,
        setup.hard.largest_diameter() / 2));
  if (planes != nullptr)
    for (Plane& plane : *planes)
      agents.push_back(std::make_unique<PlaneAgent<D>>(&plane, setup.hard.gravity));
  return agents;
}

template Parameters<2> hard_parameters_of(const Scene&);
template Parameters<3> hard_parameters_of(const Scene&);
template Agents<2> make_agents(const Scene&, const Setup<2>&, std::vector<Plane>*);
template Agents<3> make_agents(const Scene&, const Setup<3>&, std::vector<Plane>*);

}  // namespace sandglass
