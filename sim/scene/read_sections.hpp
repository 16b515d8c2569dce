#pragma once

#include "sim/scene/scene.hpp"
#include "sim/scene/table.hpp"

// One function per table of a scene file. Each fills in its struct and reports faults of type and spelling;
// what the values may be, alone and together, is the business of rules.hpp.

namespace sandglass {

void read_run(Table& table, Run& run);
void read_domain(Table& table, Domain& domain);
/// `dimension` decides between area and volume fraction; 0 when the domain does not tell it.
void read_species(Table& table, int dimension, Species& species);
void read_method(Table& table, Method& method);
void read_forces(Table& table, std::vector<double>& gravity);
void read_initial(Table& table, Initial& initial);
void read_observe(Table& table, Observe& observe);
void read_output(Table& table, Output& output);

/// The one of time, steps and collisions-per-particle that the table gives; reports none and more than one.
Duration read_duration(Table& table);
/// Reads `key = { time | steps | collisions-per-particle }`.
void read_cadence(Table& table, const std::string& key, Cadence& cadence);
void read_cadence(Table& table, const std::string& key, std::optional<Cadence>& cadence);

}  // namespace sandglass
