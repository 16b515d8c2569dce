#pragma once

namespace sandglass {

// What a finite number of particles changes. A periodic run fixes momentum and energy, so the N velocities
// relative to their mean are a point on a sphere of K = D(N-1) dimensions, spread evenly in equilibrium.
// Every moment of a uniform point is a ratio of Gamma functions: the formulas are exact for any N. With
// granular temperature T = m sum C^2 / K, its radius is sqrt(K T/m).

/// <C^order>/<C^2>^(order/2) over that of a Maxwellian, when <C^2> is the same sample's and
/// `degrees_of_freedom` coordinates share it: product over j < order/2 of K/(K+2j). Even order.
double self_normalised_factor(int order, double degrees_of_freedom);

/// Mean relative speed over that of a Maxwellian of the same T: sqrt(K/2) Gamma(K/2)/Gamma((K+1)/2) = 1 +
/// 1/(4K) + ...
double relative_speed_factor(double degrees_of_freedom);

/// Pairs in contact over those of an infinite gas of hard particles at the same density, when N is fixed:
/// 1 - S(0)/(2 N g) d^2(nu^2 g)/dnu^2, which is 1 - 1/N for a dilute gas. Lebowitz & Percus (1961); O(1/N^2) left out.
double fixed_count_factor(int dimension, double fraction, double particles);

/// Collision rate over the Enskog rate of an infinite gas: a particle has N-1 partners, not N.
double collision_rate_factor(double particles, int dimension);

/// Probability that one velocity component lies below `velocity`: the marginal of the sphere, a Beta
/// distribution of C^2, with the variance of one particle T/m (N-1)/N.
double component_cumulative(double velocity, double temperature_over_mass, double particles, int dimension);

}  // namespace sandglass
