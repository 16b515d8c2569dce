#include "validation/law/contact.hpp"

#include <array>
#include <cmath>

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

double virial_contact_value(int dimension, double fraction) {
  const VirialSeries& series = dimension == 2 ? kDisks : kSpheres;
  const double excluded = (dimension == 2 ? 2 : 4) * fraction;
  double sum = 0;
  for (auto term = series.rbegin(); term != series.rend(); ++term) sum = sum * excluded + *term;
  return sum;
}

}  // namespace sandglass::law
