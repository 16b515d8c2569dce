#pragma once

#include "sim/scene/surface.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// What a user can ask for, as plain values. Filled by read_scene_text(), checked by validate(), never changed
// by a run. Vectors have `Domain::dimension` entries. Units are the scene's own: any consistent set of
// length, mass and time.

namespace sandglass {

enum class Side { periodic, specular };

struct Domain {
  int dimension = 2;
  std::vector<double> size;                ///< edge lengths; the low corner is the origin
  std::vector<std::array<Side, 2>> sides;  ///< per axis: low side, high side; periodic comes in pairs
  bool operator==(const Domain&) const = default;
};

/// Exactly one of count, fraction and number_density is given, and none where the particles are given one by
/// one; particle_count() is the number that follows.
struct Species {
  std::string name = "particle";
  std::optional<std::uint64_t> count;    ///< simulated particles
  std::optional<double> fraction;        ///< area fraction (2D) or volume fraction (3D) of real particles
  std::optional<double> number_density;  ///< real particles per area or volume
  double diameter = 1;
  double mass = 1;
  double restitution = 1;
  double tangential_restitution = -1;         ///< -1 smooth, 0 no sliding is left, 1 perfectly rough
  std::optional<double> friction = {};        ///< Coulomb coefficient; none: always sticking
  std::optional<double> inertia_factor = {};  ///< q of I = q m R^2; none: see inertia_factor()
  bool operator==(const Species&) const = default;
};

/// local: Henderson (2D) or Carnahan-Starling (3D) contact value of the local density.
enum class ContactFactor { none, local };
enum class DensityEstimate { smoothed, cell };
enum class Offset { none, consistent, corrected, random };

/// Time step: fixed, or chosen so that a particle collides `collisions` times per step (Galilean invariant).
struct TimeStep {
  std::optional<double> fixed;
  std::optional<double> collisions;
  bool operator==(const TimeStep&) const = default;
};

/// What keeps an event-driven run from infinitely many collisions in finite time (inelastic collapse).
/// contact_time: a collision is elastic when the previous one of a partner was less than `contact_time` ago
/// (TC model; Luding & McNamara 1998). velocity_dependent: r(v) = 1 - (1 - r) (v/v0)^(3/4) below
/// v0 = `reference_speed`, v the normal relative speed (Bizon et al. 1998).
enum class CollapseGuard { none, contact_time, velocity_dependent };

struct Method {
  std::string preset = "dsmc";  ///< one of presets()
  ContactFactor contact_factor = ContactFactor::none;
  DensityEstimate density = DensityEstimate::smoothed;
  Offset offset = Offset::none;
  double random_offset = 0;          ///< cuba: length of the extra zero-mean offset, in diameters
  std::vector<std::uint64_t> cells;  ///< cells per axis; empty: chosen from cell_size
  std::optional<double> cell_size;   ///< wanted edge; the nearest whole number of cells is taken
  TimeStep time_step;
  double weight = 1;  ///< real particles per simulated one (F_N of the DSMC literature)
  CollapseGuard guard = CollapseGuard::none;
  double contact_time = 0;     ///< guard contact_time
  double reference_speed = 0;  ///< guard velocity_dependent
  bool operator==(const Method&) const = default;
};

enum class Positions { random, lattice, random_without_overlap };

struct ShearWave {
  double amplitude = 0;  ///< velocity along axis 0, as a sine of the position along axis 1
  int periods = 1;       ///< whole periods over the domain
  bool operator==(const ShearWave&) const = default;
};

/// The initial state, unless `Scene::given` lists the particles: then all of this keeps its defaults, unused.
struct Initial {
  Positions positions = Positions::random;
  double temperature = 1;        ///< granular temperature m<C^2>/D
  std::vector<double> velocity;  ///< stream velocity; empty: at rest
  bool exact = true;             ///< remove the sampled mean velocity and scale to exactly `temperature`
  std::optional<ShearWave> shear_wave;
  double equilibrate_collisions = 0;  ///< elastic collisions per particle before time zero
  double spin_temperature = 0;        ///< rotational granular temperature I<w^2>/(degrees of freedom)
  bool operator==(const Initial&) const = default;
};

/// A particle that the scene places itself.
struct GivenParticle {
  std::vector<double> position;
  std::vector<double> velocity;
  std::vector<double> spin;  ///< angular velocity: one component in 2D, three in 3D; empty: none
  std::size_t species = 0;   ///< index into Scene::species
  bool operator==(const GivenParticle&) const = default;
};

/// When an observer samples: every so much time, so many steps, or so many collisions per particle.
struct Cadence {
  enum class Unit { time, steps, collisions } unit = Unit::steps;
  double every = 1;
  bool operator==(const Cadence&) const = default;
};

struct Observe {
  std::string what;  ///< one of observer_kinds(), which also says what uses the values below
  Cadence cadence;
  int axis = 0;                                ///< of the component, or normal of the plane
  double position = 0;                         ///< crossings: where the plane stands on that axis
  std::optional<std::array<double, 2>> range;  ///< first and last bin edge
  std::uint64_t bins = 64;
  std::vector<std::uint64_t> grid;  ///< fields: bins per axis; structure-factor: lattice cells per axis
  bool operator==(const Observe&) const = default;
};

/// Exactly one is given. `collisions` counts collisions per particle, 2 C / N.
struct Duration {
  std::optional<double> time;
  std::optional<std::uint64_t> steps;
  std::optional<double> collisions;
  bool operator==(const Duration&) const = default;
};

struct Output {
  std::string record;  ///< path of the record; empty: scene's name with .h5, in the working folder
  std::optional<Cadence> trajectory;  ///< frames of positions and velocities (first replica)
  bool ids = false;                   ///< keep particle identities (costs 8 bytes a particle)
  std::optional<Cadence> checkpoint;
  std::optional<std::string> event_trace;  ///< file with a line per event (event-driven, first replica)
  bool operator==(const Output&) const = default;
};

struct Run {
  std::uint64_t seed = 1;
  std::uint64_t replicas = 1;
  Duration duration;
  bool operator==(const Run&) const = default;
};

struct Scene {
  std::string title;
  Domain domain;
  std::vector<Species> species;
  Method method;
  std::vector<double> gravity;  ///< acceleration; empty: none
  std::vector<Wall> walls;      ///< sides not listed are plain specular or periodic
  std::vector<Obstacle> obstacles;
  Initial initial;
  std::vector<GivenParticle> given;  ///< positions = "given": all particles; else empty
  std::vector<Observe> observe;
  Output output;
  Run run;
  bool operator==(const Scene&) const = default;
};

/// The method is the exact motion of hard disks and spheres.
bool is_event_driven(const Scene& scene);
/// Some contact, between particles or with a wall or obstacle, changes spins.
bool is_rough(const Scene& scene);

double volume(const Domain& domain);
/// Area (2D) or volume (3D) of one particle.
double particle_volume(const Species& species, int dimension);
double largest_diameter(const Scene& scene);
/// q of I = q m R^2: as given, else that of a full disk (1/2) or sphere (2/5).
double inertia_factor(const Species& species, int dimension);

/// Simulated particles of a species, from whichever of count, fraction or number density was given, or as
/// listed in Scene::given.
std::uint64_t particle_count(const Scene& scene, const Species& species);
/// Real particles per area or volume of a species (weight included).
double number_density(const Scene& scene, const Species& species);
/// Area or volume fraction of a species (weight included).
double fraction(const Scene& scene, const Species& species);
/// The same of all species together.
std::uint64_t particle_count(const Scene& scene);
double fraction(const Scene& scene);

/// Parses and validates. Throws InputError with every fault of the text, each with file, line and column, the
/// allowed values and the nearest spelling.
Scene read_scene_file(const std::string& path);
Scene read_scene_text(const std::string& text, const std::string& file_name);

/// The rules that a scene read from text has passed, for one made or changed in code. Throws InputError with
/// every fault; the faults name the key and have no place.
void validate(const Scene& scene);

/// The scene with every default spelled out, as TOML that read_scene_text() turns into the same Scene.
std::string write_scene(const Scene& scene);

}  // namespace sandglass
