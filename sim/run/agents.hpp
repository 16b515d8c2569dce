#pragma once

#include "sim/method/event_driven/event_driven.hpp"
#include "sim/scene/scene.hpp"

namespace sandglass {

template <int D>
struct Setup;

/// What the event-driven method is told of the scene's particles and forces.
template <int D>
event_driven::Parameters<D> hard_parameters_of(const Scene& scene);

/// Walls, obstacles and the planes that count, in this order. `planes` must outlive them.
template <int D>
event_driven::Agents<D> make_agents(const Scene& scene, const Setup<D>& setup, std::vector<Plane>* planes);

}  // namespace sandglass
