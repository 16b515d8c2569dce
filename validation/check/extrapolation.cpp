#include "validation/check/extrapolation.hpp"

#include "sim/base/error.hpp"

#include <cmath>

namespace sandglass {

namespace {
using Columns = std::vector<std::vector<double>>;

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}
}  // namespace

// Gram-Schmidt on polynomials over the points; each basis vector carries its own value at x = 0 along.
std::vector<double> intercept_weights(const std::vector<double>& x, int degree) {
  SANDGLASS_EXPECT(degree >= 0 && x.size() > static_cast<std::size_t>(degree));
  Columns basis;
  std::vector<double> at_zero, weights(x.size(), 0.0);
  for (int power = 0; power <= degree; ++power) {
    std::vector<double> column(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) column[i] = std::pow(x[i], power);
    double zero = power == 0 ? 1 : 0;
    for (std::size_t k = 0; k < basis.size(); ++k) {
      const double share = dot(column, basis[k]);
      for (std::size_t i = 0; i < x.size(); ++i) column[i] -= share * basis[k][i];
      zero -= share * at_zero[k];
    }
    const double norm = std::sqrt(dot(column, column));
    for (double& entry : column) entry /= norm;
    for (std::size_t i = 0; i < x.size(); ++i) weights[i] += zero / norm * column[i];
    basis.push_back(std::move(column));
    at_zero.push_back(zero / norm);
  }
  return weights;
}

std::vector<double> mean_weights(std::size_t count) {
  return std::vector<double>(count, 1 / static_cast<double>(count));
}

}  // namespace sandglass
