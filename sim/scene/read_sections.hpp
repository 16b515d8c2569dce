#pragma once

#include "sim/scene/scene.hpp"
#include "sim/scene/text/table.hpp"

// One function per table of a scene file. Each fills in its struct and reports errors of type and spelling;
// what the values may be, alone and together, is the business of rules.hpp.

namespace sandglass {

void read_run(Table& table, Run& run);
/// `proportions`: of the edges, where the box follows from the particles; empty where the size is given.
void read_domain(Table& table, Domain& domain, std::vector<double>& proportions);
/// The box that holds the counted particles at their fraction; drops the fraction, which it now implies.
void fit_box(const std::vector<double>& proportions, Scene& scene, Diagnostics& diagnostics);
/// `dimension` decides between area and volume fraction; 0 when the domain does not say it. `given`: the
/// particles are listed one by one, and the species takes no amount. `boxed`: the domain has its size, and one
/// amount is enough.
/// Adds one species, or several for a distribution of diameters.
void read_species(Table& table, int dimension, bool given, bool boxed, std::vector<Species>& all);
void read_method(Table& table, Method& method);
void read_forces(Table& table, std::vector<double>& gravity);
void read_wall(Table& table, Wall& wall);
void read_obstacle(Table& table, Obstacle& obstacle);
void read_source(Table& table, Source& source);
/// `species`: what it may name; nullptr when that is not known.
void read_inflow(Table& table, const std::vector<Species>* species, Inflow& inflow);
void read_region(Table& table, Region& region);
void read_outflow(Table& table, Outflow& outflow);
/// True when positions = "given".
bool read_initial(Table& table, Initial& initial);
/// `species`: what the particle may name; nullptr when that is not known.
void read_particle(Table& table, int dimension, const std::vector<Species>* species, GivenParticle& particle);
void read_observe(Table& table, Observe& observe);
void read_output(Table& table, Output& output);

/// A side of the domain, which must be named.
void read_side(Table& table, int& axis, bool& high);
/// The index of the species that is named; `species`: as of read_particle().
void read_species_name(Table& table, const std::vector<Species>* species, std::size_t& index);
/// The one of time, steps and collisions-per-particle that the table gives; reports none and more than one.
Duration read_duration(Table& table);
/// Reads `key = { time | steps | collisions-per-particle }`.
void read_cadence(Table& table, const std::string& key, Cadence& cadence);
void read_cadence(Table& table, const std::string& key, std::optional<Cadence>& cadence);

}  // namespace sandglass
