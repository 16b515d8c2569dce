#pragma once

#include <cmath>

namespace sandglass {

/// How crowded a mixture is: area fraction and (pi/4) sum of diameters per area in 2D, volume fraction and (pi/6) sum of
/// squared diameters per volume in 3D.
struct Crowding {
  double fraction = 0, width = 0;

  Crowding operator*(double factor) const { return {fraction * factor, width * factor}; }
  Crowding operator+(const Crowding& other) const { return {fraction + other.fraction, width + other.width}; }
};

/// That of one particle per unit of area or volume.
inline Crowding crowding_of(int dimension, double diameter) {
  const double width = dimension == 2 ? M_PI / 4 * diameter : M_PI / 6 * diameter * diameter;
  return {width * diameter, width};
}

/// Pair correlation at contact of two species of a mixture, P(x)/(1 - nu) with x = width d_1 d_2/(d_1 + d_2)/(1 - nu).
/// Disks: P = 1 + 9x/8 (Jenkins & Mancini 1987); spheres: P = 1 + 3x + 2x^2 (Boublik 1970; Mansoori, Carnahan, Starling &
/// Leland 1971).
class MixtureContactValue {
 public:
  MixtureContactValue(int dimension, const Crowding& crowding, double diameter_1, double diameter_2)
      : linear_(dimension == 2 ? 9.0 / 8 : 3),
        square_(dimension == 2 ? 0 : 2),
        room_(1 - crowding.fraction),
        reduced_(diameter_1 * diameter_2 / (diameter_1 + diameter_2)),
        x_(crowding.width * reduced_ / room_) {}

  double value() const { return polynomial() / room_; }
  /// Second derivative along `change`, as particles are added that crowd by so much.
  double second_derivative(const Crowding& change) const {
    const double a = change.fraction, s = reduced_ * change.width + x_ * a;  // dx = s/(1 - nu)
    return (2 * a * a * polynomial() + 4 * a * s * (linear_ + 2 * square_ * x_) + 2 * square_ * s * s) /
           (room_ * room_ * room_);
  }

 private:
  double polynomial() const { return 1 + x_ * (linear_ + square_ * x_); }

  double linear_, square_, room_, reduced_, x_;
};

}  // namespace sandglass
