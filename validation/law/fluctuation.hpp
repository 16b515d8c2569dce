#pragma once

#include "validation/law/gas.hpp"

/// What the count of particles in a slice of a box does in equilibrium.
namespace sandglass::law {

/// Variance of the count in a part of a closed box of elastic fluid: mean S(0) (1 - share), with S(0) = 1/(Z + nu Z'),
/// `mean` the mean count and `share` the part of the box. Exact for points, whose S(0) is one; else for slices much
/// thicker than a diameter.
double count_variance(const Gas& gas, double mean, double share);

/// Mean of every line but the last of Mueller's power spectrum (3.11) of `samples` values that are independent, each of
/// the given variance: 2 variance/samples [square of what is sampled].
double white_spectrum_level(double variance, double samples);

}  // namespace sandglass::law
