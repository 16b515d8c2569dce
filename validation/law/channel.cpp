#include "validation/law/channel.hpp"

#include "validation/law/sedimentation.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_roots.h>

namespace sandglass::law {

namespace {
using std::numbers::pi;

/// Momentum that passes per mass that passes, m u + T/u.
double thrust(double mass, double velocity, double temperature) {
  return mass * velocity + temperature / velocity;
}

/// The equation of cooling_stream() for (u, T_r).
struct Cooling {
  const CoolingStream& stream;
  double c;

  double temperature(double velocity) const { return velocity * (c - stream.mass * velocity); }
  double collision_rate(double velocity) const {
    const double start = std::sqrt(8 * stream.temperature.translation / (pi * stream.mass));
    const double speed = stream.gas.dimension == 3 ? start : start * pi / 4;
    return speed / stream.mean_free_path * stream.velocity / velocity *
           std::sqrt(temperature(velocity) / stream.temperature.translation);
  }
};

int derivative(double, const double* now, double* change, void* parameters) {
  const auto& cooling = *static_cast<const Cooling*>(parameters);
  const int dimension = cooling.stream.gas.dimension;
  const double u = now[0], mass = cooling.stream.mass;
  const Temperatures gain = rough_energy_change(cooling.stream.gas, {cooling.temperature(u), now[1]});
  const double per_length = cooling.collision_rate(u) / (2 * u);
  change[0] =
      per_length * gain.translation / ((dimension + 2) / 2.0 * cooling.c - (dimension + 1) * mass * u);
  change[1] = per_length * gain.rotation / (dimension == 2 ? 0.5 : 1.5);
  return GSL_SUCCESS;
}

/// Energy that a particle carries past a plane, at this velocity: in equilibrium on a floor.
double carried(const FallingStream& stream, double velocity) {
  const double temperature =
      velocity * (thrust(stream.mass, stream.velocity, stream.temperature) - stream.mass * velocity);
  const Column column{stream.mass, temperature, stream.gravity, stream.height};
  return stream.mass * velocity * velocity / 2 + (stream.freedom / 2 + 1) * temperature +
         stream.mass * stream.gravity * mean_column_height(column);
}

double missing(double velocity, void* parameters) {
  const auto& stream = *static_cast<const FallingStream*>(parameters);
  const double start = stream.mass * stream.velocity * stream.velocity / 2 +
                       (stream.freedom / 2 + 1) * stream.temperature +
                       stream.mass * stream.gravity * stream.height / 2;
  return carried(stream, velocity) - start;
}
}  // namespace

double mean_path_viscosity(double density, double mean_speed, double mean_free_path) {
  return 5 * pi / 32 * density * mean_speed * mean_free_path;
}

double mean_speed_of_spheres(double most_probable_speed) { return 2 / std::sqrt(pi) * most_probable_speed; }

double most_probable_speed(double temperature, double mass) { return std::sqrt(2 * temperature / mass); }

double channel_reynolds_number(double speed_ratio, double height) {
  return 16 * speed_ratio * height / (5 * std::sqrt(pi));
}

double mach_number(double speed_ratio, double heat_capacity_ratio) {
  return speed_ratio * std::sqrt(2 / heat_capacity_ratio);
}

double heat_capacity_ratio(double freedom) { return 1 + 2 / freedom; }

StreamState cooling_stream(const CoolingStream& stream, double distance) {
  gsl_set_error_handler_off();
  Cooling cooling{stream, thrust(stream.mass, stream.velocity, stream.temperature.translation)};
  gsl_odeiv2_system system{derivative, nullptr, 2, &cooling};
  const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3 * stream.mean_free_path, 0, 1e-11),
      gsl_odeiv2_driver_free);
  double x = 0, now[] = {stream.velocity, stream.temperature.rotation};
  if (distance > 0 && gsl_odeiv2_driver_apply(driver.get(), &x, distance, now) != GSL_SUCCESS)
    return {std::nan(""), {std::nan(""), std::nan("")}};
  return {now[0], {cooling.temperature(now[0]), now[1]}};
}

/// Between the speed of the start and the one at which a slower stream would carry less again.
StreamState falling_stream_end(const FallingStream& stream) {
  gsl_set_error_handler_off();
  FallingStream parameters = stream;
  const double c = thrust(stream.mass, stream.velocity, stream.temperature);
  const double slowest = (stream.freedom / 2 + 1) * c / (stream.mass * (stream.freedom + 1));
  const StreamState none{std::nan(""), {std::nan(""), std::nan("")}};
  if (!(slowest < stream.velocity) || missing(slowest, &parameters) < 0) return none;
  gsl_function function{missing, &parameters};
  const std::unique_ptr<gsl_root_fsolver, void (*)(gsl_root_fsolver*)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  if (gsl_root_fsolver_set(solver.get(), &function, slowest, stream.velocity) != GSL_SUCCESS) return none;
  for (int step = 0; step < 200; ++step) {
    if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS) return none;
    if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver.get()), gsl_root_fsolver_x_upper(solver.get()),
                               0, 1e-14) == GSL_SUCCESS)
      break;
  }
  const double velocity = gsl_root_fsolver_root(solver.get()),
               temperature = velocity * (c - stream.mass * velocity);
  return {velocity, {temperature, temperature}};
}

}  // namespace sandglass::law
