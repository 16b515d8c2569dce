#pragma once

#include "sim/scene/scene.hpp"
#include "sim/scene/text/diagnostics.hpp"

#include <optional>
#include <string>

// What the values of a scene may be: alone (bounds) and together. Each rule reports and goes on, so that one
// reading shows every error; a rule that rests on a value already reported is left out.

namespace sandglass {

/// Checks every rule on a scene and reports each error.
void check_rules(const Scene& scene, Diagnostics& diagnostics);

void check_run(const Scene& scene, Diagnostics& diagnostics);
/// How many steps the run takes.
void check_steps(const Scene& scene, Diagnostics& diagnostics);
void check_domain(const Scene& scene, Diagnostics& diagnostics);
void check_species(const Scene& scene, Diagnostics& diagnostics);
void check_packing(const Scene& scene, Diagnostics& diagnostics);
void check_method(const Scene& scene, Diagnostics& diagnostics);
void check_gravity(const Scene& scene, Diagnostics& diagnostics);
void check_initial(const Scene& scene, Diagnostics& diagnostics);
void check_overlap(const Scene& scene, Diagnostics& diagnostics);
void check_observers(const Scene& scene, Diagnostics& diagnostics);
void check_walls(const Scene& scene, Diagnostics& diagnostics);
void check_obstacles(const Scene& scene, Diagnostics& diagnostics);
void check_sources(const Scene& scene, Diagnostics& diagnostics);
void check_inflows(const Scene& scene, Diagnostics& diagnostics);
void check_regions(const Scene& scene, Diagnostics& diagnostics);
void check_outflows(const Scene& scene, Diagnostics& diagnostics);
void check_given(const Scene& scene, Diagnostics& diagnostics);
void check_spins(const Scene& scene, Diagnostics& diagnostics);
/// Of the family itself, on its keys and what they need.
void check_family(const Scene& scene, Diagnostics& diagnostics);
/// What the scene asks of a method that cannot do it.
void check_capabilities(const Scene& scene, Diagnostics& diagnostics);

/// Whether the domain has this axis; reports a side of the third axis in two dimensions.
bool check_side(const Domain& domain, int axis, bool high, const std::string& path, Diagnostics& diagnostics);
/// Whether the side is open; reports one that is not. `stream`: what it would do, "a stream comes in by".
bool check_open_side(const Scene& scene, int axis, bool high, const std::string& path, const char* stream,
                     Diagnostics& diagnostics);
/// Without a particle at the start there is neither a temperature, a collision rate nor a largest speed.
void check_step_of_empty_box(const Scene& scene, Diagnostics& diagnostics);

void check_rough(double tangential_restitution, const std::optional<double>& friction,
                 const std::string& path, Diagnostics& diagnostics);

/// "area-fraction" in two dimensions, "volume-fraction" in three.
std::string fraction_key(int dimension);

}  // namespace sandglass
