#pragma once

#include <functional>
#include <span>
#include <vector>

namespace sandglass {

/// A model y(x) with parameters, fitted to points of equal weight.
struct LeastSquares {
  std::vector<double> parameters;
  std::vector<double> errors;  ///< one standard error, from the scatter of independent points
  double mean_square = 0;      ///< of the residuals
};

using Model = std::function<double(std::span<const double> parameters, double x)>;

/// Levenberg-Marquardt from a start near the solution. Throws InputError when it does not settle, or with fewer points
/// than parameters.
LeastSquares least_squares(const Model& model, std::vector<double> start, std::span<const double> x,
                           std::span<const double> y);

/// Mean square residual of points under given parameters.
double mean_square_residual(const Model& model, std::span<const double> parameters, std::span<const double> x,
                            std::span<const double> y);

}  // namespace sandglass
