#pragma once

#include "validation/check/check.hpp"

#include <vector>

// One function per topic, that is per file of checks; check.cpp joins them into the registry.

namespace sandglass {

std::vector<CheckInfo> collision_checks();
std::vector<CheckInfo> pressure_checks();
std::vector<CheckInfo> contact_checks();
std::vector<CheckInfo> structure_checks();
std::vector<CheckInfo> conservation_checks();
std::vector<CheckInfo> moment_checks();
std::vector<CheckInfo> distribution_checks();
std::vector<CheckInfo> cooling_checks();
std::vector<CheckInfo> clustering_checks();
std::vector<CheckInfo> guarded_checks();
std::vector<CheckInfo> flux_checks();
std::vector<CheckInfo> shear_checks();
std::vector<CheckInfo> few_body_checks();
std::vector<CheckInfo> row_checks();
std::vector<CheckInfo> bounce_checks();
std::vector<CheckInfo> knudsen_checks();
std::vector<CheckInfo> drag_checks();
std::vector<CheckInfo> column_checks();
std::vector<CheckInfo> column_pressure_checks();
std::vector<CheckInfo> pipe_flow_checks();
std::vector<CheckInfo> pipe_wave_checks();
std::vector<CheckInfo> pipe_transport_checks();
std::vector<CheckInfo> diffuse_wall_checks();
std::vector<CheckInfo> sedimentation_rest_checks();
std::vector<CheckInfo> sedimentation_fall_checks();
std::vector<CheckInfo> falling_checks();
std::vector<CheckInfo> packing_checks();
std::vector<CheckInfo> collapse_checks();
std::vector<CheckInfo> bagnold_checks();
std::vector<CheckInfo> wall_balance_checks();
std::vector<CheckInfo> correlation_checks();
std::vector<CheckInfo> pair_correlation_checks();
std::vector<CheckInfo> vibrated_bed_rise_checks();
std::vector<CheckInfo> vibrated_bed_flow_checks();
std::vector<CheckInfo> vibrated_bed_velocity_checks();
std::vector<CheckInfo> heap_checks();
std::vector<CheckInfo> heap_growth_checks();
std::vector<CheckInfo> mixture_checks();
std::vector<CheckInfo> rough_checks();
std::vector<CheckInfo> time_step_checks();
std::vector<CheckInfo> repulsion_checks();
std::vector<CheckInfo> two_fluid_checks();
std::vector<CheckInfo> symmetry_checks();
std::vector<CheckInfo> stream_checks();
std::vector<CheckInfo> cloning_checks();
std::vector<CheckInfo> open_stream_checks();
std::vector<CheckInfo> channel_checks();
std::vector<CheckInfo> falling_stream_checks();

/// One species of smooth particles, periodic on every side, no obstacles, no forces: what the laws of a uniform gas assume.
bool is_uniform(const Scene& scene);
/// is_uniform, elastic, drawn from a Maxwellian and without a shear wave: stationary from time zero.
bool is_equilibrium(const Scene& scene);
/// is_uniform, drawn from a Maxwellian and dissipative, every collision at the species' restitution.
bool is_cooling(const Scene& scene);
/// A handful of given particles without walls, forces or guard.
bool is_few_bodies(const Scene& scene);
/// Cooling under the TC model.
/// What a method without contact value has in its place, as a number of a check; 0: that of the gas.
law::Parameter contact_number();
/// That over the contact value of the gas.
double contact_ratio(const Subject& subject, double contact_value);
bool is_guarded(const Scene& scene);
/// Particles have a surface and collide where it touches.
bool touches(const Scene& scene);

}  // namespace sandglass
