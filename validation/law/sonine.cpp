#include "validation/law/sonine.hpp"

namespace sandglass::law {

namespace {
double numerator(double restitution) { return 16 * (1 - restitution) * (1 - 2 * restitution * restitution); }
}  // namespace

double sonine_a2(int dimension, double restitution) {
  const double r = restitution;
  return numerator(r) / (9 + 24 * dimension - (41 - 8 * dimension) * r + 30 * r * r * (1 - r));
}

double sonine_a2_relinearised(int dimension, double restitution) {
  const double r = restitution;
  return numerator(r) / (25 + 24 * dimension - (57 - 8 * dimension) * r - 2 * r * r * (1 - r));
}

double sonine_collision_factor(double a2) { return 1 - a2 / 16; }

double sonine_cooling_factor(double a2) { return 1 + 3 * a2 / 16; }

}  // namespace sandglass::law
