#pragma once

#include "validation/law/law.hpp"

/// The laws of each topic, in the order in which they are listed.
namespace sandglass::law {

std::vector<Law> equilibrium_laws();     ///< contact value, collision rate, equation of state
std::vector<Law> reference_laws();       ///< the elastic fluid as well as it is known
std::vector<Law> cooling_laws();         ///< Haff's law and its Sonine correction
std::vector<Law> guarded_laws();         ///< cooling under the TC model
std::vector<Law> velocity_laws();        ///< moments of the velocity distribution
std::vector<Law> flux_laws();            ///< velocities of particles that cross a plane
std::vector<Law> transport_laws();       ///< viscosities
std::vector<Law> few_body_laws();        ///< a ball on a floor, balls in a row
std::vector<Law> free_molecular_laws();  ///< walls, obstacles and gravity without collisions
std::vector<Law> heap_laws();            ///< shape and growth of a heap
std::vector<Law> falling_laws();         ///< free fall, collapse under gravity, flow along it
std::vector<Law> vibrated_bed_laws();    ///< energy that a vibrating bottom gives
std::vector<Law> fluctuation_laws();     ///< counts in a slice and their spectrum
std::vector<Law> impact_laws();          ///< impact parameters that are not spread evenly
std::vector<Law> channel_laws();         ///< streams in a channel, with and without gravity
std::vector<Law> sedimentation_laws();   ///< what a column of gas ends in
std::vector<Law> diffuse_wall_laws();    ///< heat and shear between thermal walls
std::vector<Law> rough_laws();           ///< cooling of particles with spin
std::vector<Law> mixture_laws();         ///< several species
std::vector<Law> uniform_shear_laws();   ///< a gas that is sheared, Bagnold
std::vector<Law> mixing_laws();          ///< two particles that repel each other, and the leapfrog

}  // namespace sandglass::law
