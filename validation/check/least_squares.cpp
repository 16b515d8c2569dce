#include "validation/check/least_squares.hpp"

#include "sim/base/error.hpp"

#include <cmath>
#include <memory>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

namespace sandglass {

namespace {
struct Problem {
  const Model* model;
  std::span<const double> x, y;
};

int residuals(const gsl_vector* parameters, void* data, gsl_vector* result) {
  const Problem& problem = *static_cast<const Problem*>(data);
  const std::span<const double> values(parameters->data, parameters->size);
  for (std::size_t i = 0; i < problem.x.size(); ++i) {
    const double residual = (*problem.model)(values, problem.x[i]) - problem.y[i];
    if (!std::isfinite(residual)) return GSL_EDOM;
    gsl_vector_set(result, i, residual);
  }
  return GSL_SUCCESS;
}

std::vector<double> errors_of(gsl_multifit_nlinear_workspace* space, std::size_t count, double variance) {
  const std::unique_ptr<gsl_matrix, void (*)(gsl_matrix*)> covariance(gsl_matrix_alloc(count, count),
                                                                      gsl_matrix_free);
  gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(space), 0, covariance.get());
  std::vector<double> errors;
  for (std::size_t i = 0; i < count; ++i)
    errors.push_back(std::sqrt(variance * gsl_matrix_get(covariance.get(), i, i)));
  return errors;
}
}  // namespace

LeastSquares least_squares(const Model& model, std::vector<double> start, std::span<const double> x,
                           std::span<const double> y) {
  const std::size_t count = start.size();
  if (x.size() <= count) throw InputError("a fit needs more points than it has parameters: measure more");
  gsl_set_error_handler_off();
  Problem problem{&model, x, y};
  gsl_multifit_nlinear_fdf system{};
  system.f = residuals;
  system.n = x.size();
  system.p = count;
  system.params = &problem;
  const gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  const std::unique_ptr<gsl_multifit_nlinear_workspace, void (*)(gsl_multifit_nlinear_workspace*)> space(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, x.size(), count),
      gsl_multifit_nlinear_free);
  const gsl_vector_const_view first = gsl_vector_const_view_array(start.data(), count);
  gsl_multifit_nlinear_init(&first.vector, &system, space.get());
  int reason = 0;
  const int status =
      gsl_multifit_nlinear_driver(200, 1e-10, 1e-10, 1e-12, nullptr, nullptr, &reason, space.get());
  if (status != GSL_SUCCESS && status != GSL_ENOPROG)
    throw InputError("a fit does not settle: the data are far from the model");
  LeastSquares fit;
  const gsl_vector* found = gsl_multifit_nlinear_position(space.get());
  fit.parameters.assign(found->data, found->data + count);
  fit.mean_square = mean_square_residual(model, fit.parameters, x, y);
  const auto points = static_cast<double>(x.size());
  fit.errors =
      errors_of(space.get(), count, fit.mean_square * points / (points - static_cast<double>(count)));
  return fit;
}

double mean_square_residual(const Model& model, std::span<const double> parameters, std::span<const double> x,
                            std::span<const double> y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double residual = model(parameters, x[i]) - y[i];
    sum += residual * residual;
  }
  return sum / static_cast<double>(x.size());
}

}  // namespace sandglass
