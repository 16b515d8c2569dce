#pragma once

#include "validation/law/gas.hpp"

#include <span>

/// Shear waves of a gas that cools in a periodic box.
namespace sandglass::law {

/// Waves longer than 2 pi over this grow beside the cooling temperature: sqrt(zeta/(2 nu)) with the cooling rate and
/// Enskog's kinematic viscosity (Goldhirsch & Zanetti 1993; docs/theory.md) [1/length]. Zero for r = 1.
double marginal_wave_number(const Gas& gas);
/// 2 pi over that [length].
double marginal_wave_length(const Gas& gas);

/// Share of the energy that noise holds in the stable shear waves of `box` beyond equipartition [1]: fluctuating
/// hydrodynamics, waves no shorter than 2 pi mean free paths and 2 pi diameters. Infinite where the box holds a wave that
/// grows. A bound more than a prediction: hard disks hold 0.8 of it at area fraction 0.05, a
/// quarter to a half at 0.25.
double shear_mode_share(const Gas& gas, std::span<const double> box, double particles);

}  // namespace sandglass::law
