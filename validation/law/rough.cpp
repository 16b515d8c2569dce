#include "validation/law/rough.hpp"

#include "sim/base/error.hpp"

#include <cmath>
#include <memory>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

namespace sandglass::law {

namespace {
/// d/dtau of the two temperatures as a matrix on them.
struct Rates {
  double a, b, c, d;  ///< dT_t = a T_t + b T_r, dT_r = c T_t + d T_r

  explicit Rates(const RoughGas& gas) {
    const double freedom = gas.dimension == 2 ? 1 : 3;
    const Temperatures of_translation = rough_energy_change(gas, {1, 0});
    const Temperatures of_rotation = rough_energy_change(gas, {0, 1});
    a = of_translation.translation / gas.dimension;
    b = of_rotation.translation / gas.dimension;
    c = of_translation.rotation / freedom;
    d = of_rotation.rotation / freedom;
  }
  Temperatures operator()(const Temperatures& now) const {
    return {a * now.translation + b * now.rotation, c * now.translation + d * now.rotation};
  }
  double mean() const { return (a + d) / 2; }
  double split() const { return std::hypot((a - d) / 2, std::sqrt(b * c)); }  // b, c >= 0
};

int derivative(double, const double* now, double* change, void* rates) {
  const Temperatures gain = (*static_cast<const Rates*>(rates))({now[0], now[1]});
  const double speed = std::sqrt(std::max(now[0], 0.0));
  change[0] = speed * gain.translation;
  change[1] = speed * gain.rotation;
  return GSL_SUCCESS;
}
}  // namespace

Temperatures rough_energy_change(const RoughGas& gas, const Temperatures& now) {
  const double q = gas.inertia, eta = q * (1 + gas.tangential) / (2 * q + 2), tangents = gas.dimension - 1;
  const double exchange = 2 * tangents * eta * eta / q;
  const double normal = (1 - gas.restitution) * (1 + gas.restitution);
  return {-(normal + 2 * tangents * eta * (1 - eta)) * now.translation + exchange * now.rotation,
          exchange * now.translation - 2 * tangents * eta / q * (1 - eta / q) * now.rotation};
}

/// exp(M tau) = e^(m tau) (cosh(s tau) + (M - m) sinh(s tau)/s), m the mean and s half the difference of the eigenvalues.
Temperatures rough_cooling(const RoughGas& gas, const Temperatures& start, double collisions) {
  const Rates rates(gas);
  const double mean = rates.mean(), split = rates.split();
  const double fast = std::exp((mean - split) * collisions), slow = std::exp((mean + split) * collisions);
  const double even = (slow + fast) / 2;
  const double odd = split * collisions > 1e-9 ? (slow - fast) / (2 * split) : collisions * even;
  const Temperatures change = rates(start);
  return {even * start.translation + odd * (change.translation - mean * start.translation),
          even * start.rotation + odd * (change.rotation - mean * start.rotation)};
}

Temperatures rough_cooling_in_time(const RoughGas& gas, const Temperatures& start, double mean_free_times) {
  gsl_set_error_handler_off();
  Rates rates(gas);
  gsl_odeiv2_system system{derivative, nullptr, 2, &rates};
  const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, 0, 1e-11), gsl_odeiv2_driver_free);
  double time = 0, now[] = {start.translation, start.rotation};
  if (gsl_odeiv2_driver_apply(driver.get(), &time, mean_free_times, now) != GSL_SUCCESS)
    return {std::nan(""), std::nan("")};
  return {now[0], now[1]};
}

double rough_temperature_ratio(const RoughGas& gas) {
  const Rates rates(gas);
  const double slow = rates.mean() + rates.split();
  return rates.b > 0 ? (slow - rates.a) / rates.b : HUGE_VAL;
}

}  // namespace sandglass::law
