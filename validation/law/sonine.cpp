#include "validation/law/sonine.hpp"

#include "validation/law/contact_average.hpp"

#include <cmath>

#include <Eigen/LU>
#include <gsl/gsl_sf_gamma.h>
#include <gsl/gsl_sf_laguerre.h>

namespace sandglass::law {

namespace {
double numerator(double restitution) { return 16 * (1 - restitution) * (1 - 2 * restitution * restitution); }

/// Row j - 1: loss of c^(2j) in collisions, without a correction, then by a2 to a_Order.
template <int Order>
using Losses = Eigen::Matrix<double, Order, Order>;

template <int Order>
Losses<Order> losses(int dimension, double restitution) {
  const auto loss = [dimension](const Contact& contact) {
    const double x1 = contact.first.squaredNorm(), x2 = contact.second.squaredNorm(),
                 y1 = contact.first_after.squaredNorm(), y2 = contact.second_after.squaredNorm();
    Losses<Order> all;
    for (int j = 1; j <= Order; ++j)
      all(j - 1, 0) = std::pow(x1, j) + std::pow(x2, j) - std::pow(y1, j) - std::pow(y2, j);
    for (int n = 2; n <= Order; ++n) {
      const double alpha = 0.5 * dimension - 1;
      all.col(n - 1) = all.col(0) * (gsl_sf_laguerre_n(n, alpha, x1) + gsl_sf_laguerre_n(n, alpha, x2));
    }
    return all;
  };
  return contact_average(dimension, restitution, loss, 1, 2 * Order + 1);
}

/// Share of a_n in <c^(2j)>: <x^j S_n>/<x^j> in any dimension.
double share(int j, int n) {
  if (n > j) return 0;
  return (n % 2 == 0 ? 1 : -1) * gsl_sf_choose(static_cast<unsigned>(j), static_cast<unsigned>(n));
}
}  // namespace

double sonine_a2(int dimension, double restitution) {
  const double r = restitution;
  return numerator(r) / (9 + 24 * dimension - (41 - 8 * dimension) * r + 30 * r * r * (1 - r));
}

double sonine_a2_relinearised(int dimension, double restitution) {
  const double r = restitution;
  return numerator(r) / (25 + 24 * dimension - (57 - 8 * dimension) * r - 2 * r * r * (1 - r));
}

template <int Order>
Eigen::Vector<double, Order - 1> sonine_coefficients(int dimension, double restitution, Linearised form) {
  const Losses<Order> loss = losses<Order>(dimension, restitution);
  Eigen::Matrix<double, Order - 1, Order - 1> left;
  Eigen::Vector<double, Order - 1> right;
  for (int j = 2; j <= Order; ++j) {
    // Stationary: the moment and the thermal speed to the same power are lost alike, 2j/D <c^(2j)> times the loss of c^2.
    const double moment = std::tgamma(0.5 * dimension + j) / std::tgamma(0.5 * dimension);
    const double scale = 2.0 * j / dimension * moment;
    right[j - 2] = scale * loss(0, 0) - loss(j - 1, 0);
    for (int n = 2; n <= Order; ++n)
      left(j - 2, n - 2) = loss(j - 1, n - 1) - scale * loss(0, n - 1) -
                           share(j, n) * (form == Linearised::ratios ? loss(j - 1, 0) : scale * loss(0, 0));
  }
  return left.partialPivLu().solve(right);
}

template Eigen::Vector<double, 1> sonine_coefficients<2>(int, double, Linearised);
template Eigen::Vector2d sonine_coefficients<3>(int, double, Linearised);
template Eigen::Vector3d sonine_coefficients<4>(int, double, Linearised);

double sonine_collision_factor(double a2) { return 1 - a2 / 16; }

double sonine_cooling_factor(double a2) { return 1 + 3 * a2 / 16; }

}  // namespace sandglass::law
