#pragma once

namespace sandglass {

/// Pair correlation of hard particles at contact and its second derivative.
struct ContactValue {
  double value;
  double second_derivative;
};

/// Disks: g = (1 - 7 nu / 16) / (1 - nu)^2 (Henderson 1975), nu the area fraction.
inline ContactValue henderson(double fraction) {
  const double inverse = 1 / (1 - fraction);
  const double square = inverse * inverse;
  // g = 9/16 (1 - nu)^-2 + 7/16 (1 - nu)^-1
  return {(1 - 7 * fraction / 16) * square, square * inverse * (27.0 / 8 * inverse + 7.0 / 8)};
}

/// Spheres: g = (1 - nu / 2) / (1 - nu)^3 (Carnahan & Starling 1969), nu the volume fraction.
inline ContactValue carnahan_starling(double fraction) {
  const double inverse = 1 / (1 - fraction);
  const double cube = inverse * inverse * inverse;
  // g = 1/2 (1 - nu)^-3 + 1/2 (1 - nu)^-2
  return {(1 - fraction / 2) * cube, cube * inverse * (6 * inverse + 3)};
}

using ContactFormula = ContactValue (*)(double fraction);
inline ContactFormula contact_formula(int dimension) {
  return dimension == 2 ? henderson : carnahan_starling;
}

}  // namespace sandglass
