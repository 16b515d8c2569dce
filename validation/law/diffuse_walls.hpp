#pragma once

#include "validation/law/gas.hpp"

/// A dilute gas between two parallel walls that send every particle off as a gas at rest would ("thermal", fully
/// diffuse), a distance apart: heat flows from one to the other (Fourier), or one slides along (Couette). Of the gas that
/// is given, `temperature` is that of both walls where they are alike, else ignored.
namespace sandglass::law {

/// Particles that a wall sends off per area and time when `number_density` of them would fill a half space at rest:
/// n sqrt(T/(2 pi m)).
double emitted_flux(double number_density, double mass, double temperature);
/// Mean kinetic energy of one of them in the frame of the wall, (D + 1) T/2: T along the normal, which the flux favours,
/// T/2 along each other axis.
double emitted_energy(int dimension, double temperature);

struct Gap {
  Gas gas;
  double width = 1;
  double low_temperature = 1, high_temperature = 1;  ///< of the two walls
  double sliding = 0;  ///< velocity of one wall along itself, less that of the other
};

/// Heat per area and time without collisions: (D + 1)/2 n sqrt(2/(pi m)) sqrt(T1 T2) (sqrt T2 - sqrt T1).
double free_molecular_heat_flux(const Gap& gap);
/// Shear stress without collisions, m U times the flux of each stream: n m U sqrt(2/(pi m)) sqrt(T1 T2)/(sqrt T1 + sqrt T2).
double free_molecular_shear_stress(const Gap& gap);

/// Without slip or jump: the integral of the conductivity over temperature, over the width; the conductivity goes as
/// sqrt T (all Sonine orders).
double continuum_heat_flux(const Gap& gap);
/// eta U/width, all Sonine orders; walls alike.
double continuum_shear_stress(const Gap& gap);

/// How far behind a wall the bulk's straight line would reach the wall's own value, over Maxwell's estimate of that
/// length (sqrt(pi/2) eta/sqrt(m n^2 T) for the velocity, sqrt(2 pi m T) kappa/((D + 1) n T) for temperature): 1 in free
/// flight. The largest known values, for fully diffuse walls: slip 1.147 (BGK, every dimension; spheres 1.114: Siewert
/// 2003), jump 1.176 (BGK in 3D; spheres 1.127: Sone, Ohwada & Aoki 1989).
struct EndCorrection {
  double least = 1, most = 1;
};
EndCorrection slip_correction();
EndCorrection jump_correction();

/// Flux at any mean free path: 1/flux = correction/free-molecular + 1/continuum. With correction 1 it is Sherman's (1963)
/// interpolation, the four-moment result of Lees (1965). Exact in both limits when the correction is that of the limit.
double interpolated_flux(double free_molecular, double continuum, double correction);

/// Lengths of slip and jump at a diffuse wall of the dilute gas of hard spheres: 1.2540 and 2.4001 times sqrt(pi)/2 mean free
/// paths. Sone 2007, Molecular Gas Dynamics, sec. 3.1.5 (Ohwada, Sone & Aoki 1989; Sone, Ohwada & Aoki 1989).
double slip_length_of_spheres(const Gas& gas);
double jump_length_of_spheres(const Gas& gas);
/// Maxwell's (1879) estimates of the same in any dimension, from half of the bulk's flux carried by what arrives.
double slip_length_maxwell(const Gas& gas);
double jump_length_maxwell(const Gas& gas);

}  // namespace sandglass::law
