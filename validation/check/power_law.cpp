#include "validation/check/power_law.hpp"

#include "sim/base/error.hpp"
#include "sim/base/statistics.hpp"

#include <cmath>

namespace sandglass {

namespace {
struct Logarithms {
  std::vector<double> x, y, error;
};

Logarithms logarithms(std::span<const double> x, std::span<const double> y,
                      std::span<const double> standard_error) {
  SANDGLASS_EXPECT(x.size() == y.size() && x.size() == standard_error.size() && x.size() >= 3);
  Logarithms points;
  for (std::size_t i = 0; i < x.size(); ++i) {
    SANDGLASS_EXPECT(x[i] > 0 && y[i] > 0 && standard_error[i] > 0);
    points.x.push_back(std::log(x[i]));
    points.y.push_back(std::log(y[i]));
    points.error.push_back(standard_error[i] / y[i]);
  }
  return points;
}
}  // namespace

PowerLawFit fit_power_law(std::span<const double> x, std::span<const double> y,
                          std::span<const double> standard_error) {
  const Logarithms points = logarithms(x, y, standard_error);
  const LineFit line = fit_line(points.x, points.y, points.error);
  std::vector<double> squares;
  for (double t : points.x) squares.push_back(t * t);
  const LineFit flat = fit_line(points.x, squares, points.error);  // what a line already holds of the square
  double product = 0, norm = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double bend = squares[i] - flat.intercept - flat.slope * points.x[i];
    const double weight = 1 / (points.error[i] * points.error[i]);
    product += weight * bend * points.y[i];
    norm += weight * bend * bend;
  }
  return {line.slope,          line.slope_error, line.intercept,         2 * product / norm,
          2 / std::sqrt(norm), line.chi_square,  line.degrees_of_freedom};
}

LocalExponents local_exponents(std::span<const double> x, std::span<const double> y,
                               std::span<const double> standard_error) {
  const Logarithms points = logarithms(x, y, standard_error);
  LocalExponents local;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const double step = points.x[i + 1] - points.x[i];
    local.x.push_back(std::exp((points.x[i + 1] + points.x[i]) / 2));
    local.exponent.push_back((points.y[i + 1] - points.y[i]) / step);
    local.error.push_back(std::hypot(points.error[i], points.error[i + 1]) / std::abs(step));
  }
  return local;
}

}  // namespace sandglass
