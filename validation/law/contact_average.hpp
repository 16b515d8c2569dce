#pragma once

#include "sim/base/vector.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include <gsl/gsl_integration.h>

/// Averages over the colliding pairs of a Maxwellian gas, the raw material of every Enskog result: laws without a closed
/// form are built of them, and the tests build the others again. Velocities in units of sqrt(2T/m); in 2D the z component
/// stays zero.
namespace sandglass::law {

struct Contact {
  Vector<3> first, second;              ///< before
  Vector<3> first_after, second_after;  ///< after an inelastic contact along x
  double approach;                      ///< relative normal speed before
};

using Nodes = std::vector<std::pair<double, double>>;  ///< position, weight

inline Nodes gauss_nodes(const gsl_integration_fixed_type* type, double alpha, std::size_t count) {
  const std::unique_ptr<gsl_integration_fixed_workspace, void (*)(gsl_integration_fixed_workspace*)> space(
      gsl_integration_fixed_alloc(type, count, 0, 1, alpha, 0), gsl_integration_fixed_free);
  if (!space) throw std::runtime_error("no quadrature nodes");
  Nodes nodes;
  for (std::size_t i = 0; i < count; ++i)
    nodes.emplace_back(gsl_integration_fixed_nodes(space.get())[i],
                       gsl_integration_fixed_weights(space.get())[i]);
  return nodes;
}

/// Centre of mass and relative velocity, one Gaussian coordinate each.
struct Motion {
  Vector<3> centre = Vector<3>::Zero();
  Vector<3> relative = Vector<3>::Zero();

  Contact contact(double restitution) const {
    Vector<3> after = relative;
    after.x() = -restitution * relative.x();
    return {centre + relative / 2, centre - relative / 2, centre + after / 2, centre - after / 2,
            relative.x()};
  }
};

/// A number or a matrix of them.
template <class Function, class Argument>
using Answer = std::remove_cvref_t<std::invoke_result_t<Function, Argument>>;
template <class Value>
Value zero() {
  if constexpr (std::is_arithmetic_v<Value>)
    return 0;
  else
    return Value::Zero();
}

/// Sums over the coordinates from `coordinate` on: centre x, y, (z), then relative y, (z).
template <class Function>
Answer<Function, Motion> sum_coordinates(int dimension, int coordinate, const Nodes& nodes, Motion& motion,
                                         const Function& function) {
  if (coordinate == 2 * dimension - 1) return function(motion);
  const bool centre = coordinate < dimension;
  double& target = centre ? motion.centre[coordinate] : motion.relative[coordinate - dimension + 1];
  auto sum = zero<Answer<Function, Motion>>();
  for (const auto& [node, weight] : nodes) {
    target = centre ? node / std::sqrt(2) : node * std::sqrt(2);
    sum += weight / std::sqrt(std::numbers::pi) *
           sum_coordinates(dimension, coordinate + 1, nodes, motion, function);
  }
  return sum;
}

/// Integral of phi(c1) phi(c2) g_x^power F(contact) over approaching pairs (g_x > 0), contact along x. Exact for
/// polynomials F of degree below twice the number of `nodes` that are even in g_x after the average over the rest.
template <class Function>
Answer<Function, Contact> contact_average(int dimension, double restitution, const Function& function,
                                          int power = 1, std::size_t nodes = 6) {
  const double exponent = (power - 1) / 2.0;  // g_x^power dg_x = (2u)^exponent du with u = g_x^2/2
  const Nodes gaussian = gauss_nodes(gsl_integration_fixed_hermite, 0, nodes);
  const Nodes approach = gauss_nodes(gsl_integration_fixed_laguerre, exponent, nodes);
  Motion motion;
  auto sum = zero<Answer<Function, Contact>>();
  for (const auto& [energy, weight] : approach) {
    motion.relative.x() = std::sqrt(2 * energy);
    sum += weight * sum_coordinates(dimension, 0, gaussian, motion, [&](const Motion& at) {
             return Answer<Function, Contact>(function(at.contact(restitution)));
           });
  }
  return sum * std::pow(2, exponent) / std::sqrt(2 * std::numbers::pi);
}

}  // namespace sandglass::law
