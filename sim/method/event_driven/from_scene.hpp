#pragma once

#include "sim/method/event_driven/event_driven.hpp"
#include "sim/scene/scene.hpp"

namespace sandglass::event_driven {

/// Particles, forces and guards of the scene.
template <int D>
Parameters<D> parameters_of(const Scene& scene);

/// Sides of the box, obstacles, the planes that count, filters and dispensers, in this order. `planes` and `impulses` must outlive them; null: none count.
template <int D>
Agents<D> agents_of(const Scene& scene, const Parameters<D>& parameters, const Streams& streams,
                    std::vector<Plane>* planes, WallImpulses<D>* impulses);

extern template Parameters<2> parameters_of(const Scene&);
extern template Parameters<3> parameters_of(const Scene&);
extern template Agents<2> agents_of(const Scene&, const Parameters<2>&, const Streams&, std::vector<Plane>*,
                                    WallImpulses<2>*);
extern template Agents<3> agents_of(const Scene&, const Parameters<3>&, const Streams&, std::vector<Plane>*,
                                    WallImpulses<3>*);

}  // namespace sandglass::event_driven
