#pragma once

#include "validation/law/gas.hpp"

/// What the count of particles in a slice of a box does in equilibrium.
namespace sandglass::law {

/// Variance of the count in a part of a closed box of elastic fluid: mean S(0) (1 - share), with S(0) = 1/(Z + nu Z'),
/// `mean` the mean count and `share` the part of the box. Exact for points, whose S(0) is one; else for slices much
/// thicker than a diameter.
double count_variance(const Gas& gas, double mean, double share);

/// How a Monte Carlo method with a local contact value sees its fluid along one axis: pairs come from whole cells, the
/// contact value from whole windows of cells.
struct CellFluid {
  double edge = 0;    ///< of a cell along the axis [length]; 0: no cells
  double window = 1;  ///< cells along the axis in the window
};

/// Structure factor of that fluid at equilibrium, for a wave number along the axis [1]:
/// 1/S = 1 + 2(Z - 1) c + B nu^2 chi' c w with B = 2^(D-1), c = sin^2(x)/x^2, w = sin(W x)/(W sin x), x = k edge/2.
/// Linear in the density, mean over places of the cells against the wave; the displacement itself, missing pairs and a
/// finite time step are left out.
double cell_structure(const Gas& gas, double wave_number, const CellFluid& cells);

/// The variance of count_variance() in that fluid: all waves of a periodic box of `length` along the axis that are no
/// shorter than a thousandth of the slice.
double cell_count_variance(const Gas& gas, double mean, double share, double length, const CellFluid& cells);

/// Mean of every line but the last of Mueller's power spectrum (3.11) of `samples` values that are independent, each of
/// the given variance: 2 variance/samples [square of what is sampled].
double white_spectrum_level(double variance, double samples);

}  // namespace sandglass::law
