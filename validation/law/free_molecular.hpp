#pragma once

namespace sandglass::law {

// A gas whose particles never collide: the Knudsen limit. Every wall and obstacle then sees the Maxwellian that
// the others send, and what it feels is an integral over that.

/// Temperature between two thermal walls [energy]: sqrt(T1 T2), along each axis and at each place, at uniform
/// density. The walls send half-Maxwellians of equal flux, so their densities are as 1/sqrt(T1) to 1/sqrt(T2).
/// Kennard 1938, Kinetic Theory of Gases, sec. 176. Any dimension.
double knudsen_temperature(double first_wall, double second_wall);

/// A fixed disk (dimension 2) or sphere (3) in a wide stream. Of the particles that arrive a share
/// `accommodation` leaves as from a gas at rest at the temperature of the surface, a share `reversal` goes back
/// the way it came, and the rest is reflected as by a mirror.
struct StreamPastObstacle {
  int dimension = 3;
  double number_density = 1;
  double mass = 1;
  double temperature = 1;
  double velocity = 1;  ///< of the stream
  double radius = 1;
  double surface_temperature = 1;
  double accommodation = 0;
  double reversal = 0;
};

/// Force along the stream [mass length/time^2], of the sign of the velocity. Sphere: Epstein 1924, Baines et
/// al. 1965; disk: Stalder et al. 1951 (a cylinder, per length). Free flight of particles much smaller than the
/// obstacle; the mean free path much longer than it. Exact at every speed.
double free_molecular_drag(const StreamPastObstacle& stream);

/// A column at rest above z = 0 in uniform gravity, with a lid.
struct Column {
  double mass = 1;
  double temperature = 1;
  double gravity = 1;  ///< towards smaller z, may be zero
  double height = 1;   ///< of the lid
};

/// Share of the particles below z: (1 - exp(-m g z/T))/(1 - exp(-m g h/T)). Isothermal ideal gas, with or
/// without collisions. Boltzmann 1868. 0 below the floor, 1 above the lid.
double barometric_fraction(const Column& column, double z);

}  // namespace sandglass::law
