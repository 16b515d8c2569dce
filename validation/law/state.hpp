#pragma once

#include "validation/law/gas.hpp"

namespace sandglass::law {

/// Z = p/(nT) = 1 + 2^(D-1) nu g (1+r)/2. Chapman & Cowling (1970) ch. 16; the factor (1+r)/2 is the mean
/// impulse of an inelastic contact over that of an elastic one (Jenkins & Richman 1985).
double compressibility_factor(const Gas& gas);

/// nT, the momentum carried by free flight [mass length^(2-D) time^-2].
double kinetic_pressure(const Gas& gas);

/// nT (Z-1), the momentum handed over across the diameter at contacts [mass length^(2-D) time^-2].
double collisional_pressure(const Gas& gas);

/// kinetic_pressure + collisional_pressure.
double pressure(const Gas& gas);

/// Adiabatic sound speed of the elastic gas [length/time]: c^2 = (T/m) (d(nu Z)/dnu + 2 Z^2/D).
double sound_speed(const Gas& gas);

/// S(k -> 0) = T (dn/dp)_T = 1/(d(nu Z)/dnu) of the elastic gas, with Henderson's or Carnahan & Starling's Z.
double long_wave_structure(const Gas& gas);

}  // namespace sandglass::law
