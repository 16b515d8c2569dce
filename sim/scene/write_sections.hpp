#pragma once

#include "sim/scene/text/write_value.hpp"

// The tables of a scene that hold what is beside the particles' own kind; the rest stands in write_scene.cpp.

namespace sandglass {

void write_wall(Lines& lines, const Wall& wall);
void write_obstacle(Lines& lines, const Obstacle& obstacle);
void write_source(Lines& lines, const Source& source);
/// It names its species as the scene does.
void write_inflow(Lines& lines, const Inflow& inflow, const Scene& scene);
void write_region(Lines& lines, const Region& region);
void write_outflow(Lines& lines, const Outflow& outflow);
/// The particle names its species as the scene does.
void write_particle(Lines& lines, const GivenParticle& particle, const Scene& scene);

}  // namespace sandglass
