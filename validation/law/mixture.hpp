#pragma once

#include <vector>

namespace sandglass::law {

/// One species of a uniform mixture.
struct Component {
  double number_density = 0;
  double diameter = 1;
  double mass = 1;
  double temperature = 1;  ///< granular, of its own
};

/// Mean speed of a pair of Maxwellian species: sqrt(pi s/2) in 2D, sqrt(8 s/pi) in 3D, s = T_1/m_1 + T_2/m_2.
double mean_relative_speed(int dimension, const Component& one, const Component& two);

/// Collisions of one particle of `one` with those of `two` per time, n_2 sigma_12 <v_12> g; sigma_12 is d_1 + d_2 in 2D and
/// pi (d_1 + d_2)^2/4 in 3D (Chapman & Cowling 1970, ch. 5; g as of Enskog).
double mixture_collision_rate(int dimension, const Component& one, const Component& two,
                              double contact_value = 1);

/// Pair correlation at contact of species i and j of a mixture: Jenkins & Mancini (1987) in 2D, Boublik (1970) and
/// Mansoori, Carnahan, Starling & Leland (1971) in 3D.
double mixture_contact_value(int dimension, const std::vector<Component>& all, std::size_t i, std::size_t j);

/// p/(n T) of an elastic mixture at one temperature: 1 + pi/2 sum n_i n_j d_ij^2 g_ij / n in 2D, 2 pi/3 and d_ij^3 in 3D
/// (virial theorem).
double mixture_compressibility(int dimension, const std::vector<Component>& all);

/// Energy that a particle of `one` gains in a collision with one of `two`, mean over the collisions of Maxwellian species:
/// -2 (1 + r) (M/m_1) (T_1 - (1 + r)/2 M s), M the reduced mass (Garzo & Dufty 1999 to this order).
double mixture_energy_change(double restitution, const Component& one, const Component& two);

/// T_1/T_2 of a cooling mixture of two species once both cool at the same rate. `contact` are the contact values of the
/// pairs 11, 12 and 22.
struct ThreePairs {
  double same_1 = 1, cross = 1, same_2 = 1;
};
double mixture_temperature_ratio(int dimension, double restitution, Component one, Component two,
                                 const ThreePairs& contact = {});

}  // namespace sandglass::law
