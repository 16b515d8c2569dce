#pragma once

#include "validation/check/subject.hpp"
#include "validation/law/falling.hpp"

/// Particles that fall to the floor of a box: what one replica of a record shows of all of them together.
namespace sandglass {

/// Gravity points to a wall at the low side of one axis; nobody enters or leaves.
bool falls_to_floor(const Scene& scene);

/// Along gravity, upwards, at the times of all samples, the first at time zero. Throws InputError when the observers do
/// not sample at the same times.
struct Fall {
  std::vector<double> time;
  std::vector<double> height;    ///< of the centre of mass
  std::vector<double> momentum;  ///< of all real particles
  std::vector<double> impulse;   ///< of all walls on the particles since the sample before; none at the first
};
Fall fall_of(const Subject& subject, std::size_t replica);

/// Edge of a collision cell along gravity; 0 for a method that knows where particles are.
double cell_edge(const Subject& subject);

/// All real particles of the replica at the given sample, as the laws of falling take them.
law::FallingParticles particles_at(const Subject& subject, const Fall& fall, std::size_t sample);

}  // namespace sandglass
