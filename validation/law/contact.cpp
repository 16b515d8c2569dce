#include "validation/law/contact.hpp"

#include "sim/base/error.hpp"

#include <array>

namespace sandglass::law {

namespace {
/// B_k / B_2^(k-1), k = 2..10.
using VirialSeries = std::array<double, 9>;
constexpr VirialSeries kDisks = {1,         0.78200443, 0.53223180, 0.33355604, 0.1988425,
                                 0.1148728, 0.0649930,  0.0362193,  0.0199537};
constexpr VirialSeries kSpheres = {1,          0.625,     0.28694951, 0.110252, 0.03888198,
                                   0.01302354, 0.0041832, 0.0013094,  0.0004035};
}  // namespace

double contact_value(int dimension, double fraction) {
  const double room = 1 - fraction;
  return dimension == 2 ? (1 - 7 * fraction / 16) / (room * room) : (1 - fraction / 2) / (room * room * room);
}

double contact_value_slope(int dimension, double fraction) {
  const double room = 1 - fraction;
  return dimension == 2 ? (25 - 7 * fraction) / (16 * room * room * room)
                        : (2.5 - fraction) / (room * room * room * room);
}

double virial_ratio(int dimension, int k) {
  SANDGLASS_EXPECT(k >= 2 && k <= 10);
  return (dimension == 2 ? kDisks : kSpheres)[k - 2];
}

double virial_contact_value(int dimension, double fraction) {
  const double excluded = (dimension == 2 ? 2 : 4) * fraction;
  double sum = 0;
  for (int k = 10; k >= 2; --k) sum = sum * excluded + virial_ratio(dimension, k);
  return sum;
}

}  // namespace sandglass::law
