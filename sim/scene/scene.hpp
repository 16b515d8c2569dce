#pragma once

#include "sim/scene/domain/domain.hpp"
#include "sim/scene/inflow/inflow.hpp"
#include "sim/scene/initial/initial.hpp"
#include "sim/scene/method/method.hpp"
#include "sim/scene/observe/observe.hpp"
#include "sim/scene/outflow/outflow.hpp"
#include "sim/scene/region/region.hpp"
#include "sim/scene/run/run.hpp"
#include "sim/scene/source/source.hpp"
#include "sim/scene/species/species.hpp"
#include "sim/scene/surface/surface.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// What a user can ask for, as plain values. Filled by read_scene_text(), checked by validate(), never changed
// by a run. Vectors have `Domain::dimension` entries. Units are the scene's own: any consistent set of
// length, mass and time.

namespace sandglass {

struct Scene {
  std::string title;
  Domain domain;
  std::vector<Species> species;
  Method method;
  std::vector<double> gravity;  ///< acceleration; empty: none
  std::vector<Wall> walls;      ///< sides not listed are plain specular or periodic
  std::vector<Obstacle> obstacles;
  std::vector<Source> sources;
  std::vector<Inflow> inflows;
  std::vector<Outflow> outflows;
  std::vector<Region> regions;  ///< of other weights; they do not overlap
  Initial initial;
  std::vector<GivenParticle> given;  ///< positions = "given": all particles; else empty
  std::vector<Observe> observe;
  Output output;
  Run run;
  bool operator==(const Scene&) const = default;
};

/// Name of the scene's family of methods, "dsmc" or "event-driven" for example.
std::string method_family(const Scene& scene);
/// Some contact, between particles or with a wall or obstacle, changes spins.
bool is_rough(const Scene& scene);

double largest_diameter(const Scene& scene);

/// Simulated particles of a species, from whichever of count, fraction or number density was given, or as
/// listed in Scene::given; each of the weight of the method, whatever regions make of them.
std::uint64_t particle_count(const Scene& scene, const Species& species);
/// Real particles per area or volume of a species (weight included).
double number_density(const Scene& scene, const Species& species);
/// Area or volume fraction of a species (weight included).
double fraction(const Scene& scene, const Species& species);
/// The same of all species together.
std::uint64_t particle_count(const Scene& scene);
double fraction(const Scene& scene);
/// Time until the end; infinite where the scene does not say when that is.
double duration_of(const Scene& scene);
/// Simulated particles that the sources bring in until the end, as far as the scene says it: with neither a `count` nor an
/// end in time, none.
std::uint64_t poured_count(const Scene& scene);
/// Simulated particles that come on top of those at the start: what sources pour, and what fills the box at the density of
/// its inflows.
std::uint64_t added_count(const Scene& scene);
/// Least real particles per simulated one anywhere.
double lightest_weight(const Scene& scene);
/// Simulated particles, of the weight of the method, that an inflow lets in per time: the flux of its Maxwellian through the
/// side, or what its piston makes room for.
double inflow_rate(const Scene& scene, const Inflow& inflow);
/// Particles of a layer that a dispenser puts behind its piston: the fewest whose strip is a diameter wide.
double layer_count(const Scene& scene, const Inflow& inflow);
/// Of the particles that the inflows let in, the share that a gas beyond the open side, streaming as they do, would send in
/// there: what an outflow to vacuum neglects.
double neglected_return(const Scene& scene, std::size_t axis, bool high);
/// The axis of gravity; none without gravity or with more than one component.
std::optional<std::size_t> gravity_axis(const Scene& scene);
/// Of what a source pours, along gravity; 0 unless that has one axis.
double pouring_speed(const Scene& scene, const Source& source);
/// Speed along gravity above which a particle is still falling and not part of the pile under the source: that of a fall
/// through one diameter, or of the source where that is faster.
double falling_speed(const Scene& scene, const Source& source);

/// Parses and validates. Throws InputError with every error of the text, each with file, line and column, the
/// allowed values and the nearest spelling.
Scene read_scene_file(const std::string& path);
Scene read_scene_text(const std::string& text, const std::string& file_name);

/// The rules that a scene read from text has passed, for one made or changed in code. Throws InputError with
/// every error; the errors name the key and have no place.
void validate(const Scene& scene);

/// The scene with every default spelled out, as TOML that read_scene_text() turns into the same Scene.
std::string write_scene(const Scene& scene);

}  // namespace sandglass
