#pragma once

/// Two particles of the model of mixing fluids (Greenspan 1972), and the leapfrog that moves them.
namespace sandglass::law {

/// Acceleration alpha M r / [(r + xi)^p ((r + xi)/d)^beta] of the separation r of two particles of mass M together, the
/// second factor for r < d, none from the cutoff on.
struct PairRepulsion {
  double coefficient = 1;
  double exponent = 2;
  double core_exponent = 0;
  double softening_length = 0;
  double diameter = 1;
  double cutoff = 2;  ///< finite
};

double repulsion_acceleration(const PairRepulsion& law, double mass, double distance);

/// Its integral from the distance to the cutoff: half the square of the relative speed that comes to rest there. In closed
/// form.
double repulsion_work(const PairRepulsion& law, double mass, double distance);

/// Where two particles that would pass at `impact` > 0 turn, with relative speed `speed` far away.
double turning_distance(const PairRepulsion& law, double mass, double speed, double impact);

/// Angle by which their relative velocity turns (Landau & Lifshitz, Mechanics, section 18).
double deflection_angle(const PairRepulsion& law, double mass, double speed, double impact);

/// Longest stable step of the leapfrog, 2/omega, where a pair turns that comes head-on with this relative speed: omega^2 is
/// the slope of the acceleration there, without softening (q - 1)(q - 2) v^2/(2 r^2) in the core, q = p + beta. A steeper
/// core turns the pair farther out: the step is longest for a core of middling steepness.
double stable_step(const PairRepulsion& law, double mass, double speed);

/// Frequency of a light particle in the middle between two heavy ones of this mass that stand still, each at `distance`
/// below the diameter, when nothing softens: omega^2 = 2 alpha m (p + beta - 1) (d/a)^beta / a^p.
double cage_frequency(const PairRepulsion& law, double mass, double distance);

/// Place after n steps of the leapfrog, over that at the start, of an oscillator that starts at rest with half a kick:
/// cos(n theta), cos(theta) = 1 - (omega dt)^2/2, and for omega dt > 2 (-1)^n cosh(n phi), cosh(phi) = (omega dt)^2/2 - 1.
/// Exact.
double leapfrog_place(double angle, double steps);

/// Mean of s/(s + smallest) over even overshoots s from 0 to `path`: what the listing's wall leaves of the speed of a
/// particle that flies `path` in a step onto it.
double listed_wall_factor(double path, double smallest);

}  // namespace sandglass::law
