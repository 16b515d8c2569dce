#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

/// Numerical integrals that the tests hold the laws against.
namespace sandglass::law::quadrature {

inline double evaluate(double x, void* function) {
  return (*static_cast<const std::function<double(double)>*>(function))(x);
}

/// Integral over [low, high] to 1e-10 relative. Throws std::runtime_error when that is not reached.
inline double integral(std::function<double(double)> function, double low, double high) {
  gsl_set_error_handler_off();
  constexpr std::size_t intervals = 1000;
  const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> space(
      gsl_integration_workspace_alloc(intervals), gsl_integration_workspace_free);
  gsl_function integrand{evaluate, &function};
  double value = 0;
  double error = 0;
  const int status = gsl_integration_qag(&integrand, low, high, 1e-300, 1e-10, intervals, GSL_INTEG_GAUSS31,
                                         space.get(), &value, &error);
  if (status != GSL_SUCCESS) throw std::runtime_error(gsl_strerror(status));
  return value;
}

}  // namespace sandglass::law::quadrature
