#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace sandglass {

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

/// Area (2D) or volume (3D) of one particle.
double particle_volume(const Species& species, int dimension);
/// q of I = q m R^2: as given, else that of a full disk (1/2) or sphere (2/5).
double inertia_factor(const Species& species, int dimension);

}  // namespace sandglass
