#pragma once

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

/// Exactly one of count, fraction and number_density is given; particle_count() is the number that follows.
struct Species {
  std::string name = "particle";
  std::optional<std::uint64_t> count;    ///< simulated particles
  std::optional<double> fraction;        ///< area fraction (2D) or volume fraction (3D) of real particles
  std::optional<double> number_density;  ///< real particles per area or volume
  double diameter = 1;
  double mass = 1;
  double restitution = 1;
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

struct Method {
  std::string preset = "dsmc";  ///< dsmc, dsmc-enskog, cba, cba-corrected, cuba, reservoir
  ContactFactor contact_factor = ContactFactor::none;
  DensityEstimate density = DensityEstimate::smoothed;
  Offset offset = Offset::none;
  double random_offset = 0;          ///< cuba: length of the extra zero-mean offset, in diameters
  std::vector<std::uint64_t> cells;  ///< cells per axis; empty: chosen from cell_size
  std::optional<double> cell_size;   ///< wanted edge; the nearest whole number of cells is taken
  TimeStep time_step;
  double weight = 1;  ///< real particles per simulated one (F_N of the DSMC literature)
  bool operator==(const Method&) const = default;
};

enum class Positions { random, lattice, random_without_overlap };

struct ShearWave {
  double amplitude = 0;  ///< velocity along axis 0, as a sine of the position along axis 1
  int periods = 1;       ///< whole periods over the domain
  bool operator==(const ShearWave&) const = default;
};

struct Initial {
  Positions positions = Positions::random;
  double temperature = 1;        ///< granular temperature m<C^2>/D
  std::vector<double> velocity;  ///< stream velocity; empty: at rest
  bool exact = true;             ///< remove the sampled mean velocity and scale to exactly `temperature`
  std::optional<ShearWave> shear_wave;
  double equilibrate_collisions = 0;  ///< elastic collisions per particle before time zero
  bool operator==(const Initial&) const = default;
};

/// When an observer samples: every so much time, so many steps, or so many collisions per particle.
struct Cadence {
  enum class Unit { time, steps, collisions } unit = Unit::steps;
  double every = 1;
  bool operator==(const Cadence&) const = default;
};

struct Observe {
  std::string what;  ///< energy, temperature, momentum, moments, velocity-histogram, collisions, pressure,
                     ///< crossings, fields, shear-mode
  Cadence cadence;
  int axis = 0;         ///< velocity-histogram, crossings: component / normal of the plane
  double position = 0;  ///< crossings: where the plane stands on that axis
  std::optional<std::array<double, 2>> range;  ///< velocity-histogram, crossings: first and last bin edge
  std::uint64_t bins = 64;                     ///< velocity-histogram, crossings
  std::vector<std::uint64_t> grid;             ///< fields: bins per axis
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
  Initial initial;
  std::vector<Observe> observe;
  Output output;
  Run run;
  bool operator==(const Scene&) const = default;
};

double volume(const Domain& domain);
/// Area (2D) or volume (3D) of one particle.
double particle_volume(const Species& species, int dimension);
/// Simulated particles of a species, from whichever of count, fraction or number density was given.
std::uint64_t particle_count(const Scene& scene, const Species& species);
/// Real particles per area or volume of a species (weight included).
double number_density(const Scene& scene, const Species& species);
/// Area or volume fraction of a species (weight included).
double fraction(const Scene& scene, const Species& species);

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
