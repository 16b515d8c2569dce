#pragma once

/// A dilute column of one temperature over a bottom that vibrates as A sin(2 pi f t), by one balance of energy.
namespace sandglass::law {

struct VibratedBed {
  int dimension = 2;
  double layers = 1;  ///< particles per width times d (disks), per area times d^2 (spheres)
  double width = 1;   ///< between the side walls [length]; spheres: a square box
  double restitution = 1;
  double bottom_restitution = 1;
  double side_restitution = 1;
  double gravity = 1;
  double speed = 1;  ///< V = 2 pi A f, largest of the bottom [length/time]
};

/// Energy that a moving bottom gives to a half-Maxwellian, over m n T/m sqrt(m/T)<U^2> [1]: c = (1+r)(1+3r)/(2 sqrt(2
/// pi)). First order in m<U^2>/T: Kumaran 1998, 2 sqrt(2/pi) for an elastic bottom.
double bottom_gain(double restitution);

/// T/m [length^2/time^2]: x > 0 of c V^2/2 = a x + b x^2/(g L), with a of particles and bottom, b of the side walls:
/// a = k layers (1 - r^2) + (1 - r_bottom^2)/sqrt(2 pi), k = sqrt(pi)/2 (disks), sqrt(pi) (spheres),
/// b = (D-1) sqrt(2/pi) (1 - r_side^2). Infinite when nothing dissipates.
double vibrated_bed_temperature_over_mass(const VibratedBed& bed);

/// Rise of the centre of mass above its height at rest, T/(m g) [length].
double vibrated_bed_rise(const VibratedBed& bed);

/// d ln(rise)/d ln V: 2 where particles or bottom dissipate, 1 where side walls do, and between.
double vibrated_bed_exponent(const VibratedBed& bed);

/// <U^2> m/T, the small quantity of the law.
double vibrated_bed_expansion(const VibratedBed& bed);

}  // namespace sandglass::law
