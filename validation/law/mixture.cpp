#include "validation/law/mixture.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_roots.h>

namespace sandglass::law {

namespace {
using std::numbers::pi;

/// Mean square relative speed per axis.
double spread(const Component& one, const Component& two) {
  return one.temperature / one.mass + two.temperature / two.mass;
}

struct Cooling {
  int dimension;
  double restitution;
  Component one, two;
  ThreePairs contact;

  /// Relative change of T_1 per time less that of T_2, at T_1 = ratio T_2.
  double difference(double ratio) const {
    Component first = one, second = two;
    second.temperature = 1;
    first.temperature = ratio;
    return change(first, first, contact.same_1) + change(first, second, contact.cross) -
           change(second, second, contact.same_2) - change(second, first, contact.cross);
  }
  double change(const Component& of, const Component& with, double value) const {
    return mixture_collision_rate(dimension, of, with, value) * mixture_energy_change(restitution, of, with) /
           of.temperature;
  }
};

double difference_at(double logarithm, void* cooling) {
  return static_cast<const Cooling*>(cooling)->difference(std::exp(logarithm));
}
}  // namespace

double mean_relative_speed(int dimension, const Component& one, const Component& two) {
  return std::sqrt((dimension == 2 ? pi / 2 : 8 / pi) * spread(one, two));
}

double mixture_collision_rate(int dimension, const Component& one, const Component& two,
                              double contact_value) {
  const double reach = (one.diameter + two.diameter) / 2;
  const double section = dimension == 2 ? 2 * reach : pi * reach * reach;
  return two.number_density * section * mean_relative_speed(dimension, one, two) * contact_value;
}

double mixture_contact_value(int dimension, const std::vector<Component>& all, std::size_t i, std::size_t j) {
  double fraction = 0, width = 0;  // of area and diameters in 2D, of volume and surfaces in 3D
  for (const Component& each : all) {
    const double d = each.diameter,
                 unit = each.number_density * (dimension == 2 ? pi / 4 * d : pi / 6 * d * d);
    width += unit;
    fraction += unit * d;
  }
  const double room = 1 - fraction;
  const double harmonic = all[i].diameter * all[j].diameter / (all[i].diameter + all[j].diameter);
  const double x = width * harmonic / room;
  return dimension == 2 ? (1 + 9. / 8 * x) / room : (1 + 3 * x + 2 * x * x) / room;
}

double mixture_compressibility(int dimension, const std::vector<Component>& all) {
  double density = 0, sum = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    density += all[i].number_density;
    for (std::size_t j = 0; j < all.size(); ++j)
      sum += all[i].number_density * all[j].number_density *
             std::pow((all[i].diameter + all[j].diameter) / 2, dimension) *
             mixture_contact_value(dimension, all, i, j);
  }
  return 1 + (dimension == 2 ? pi / 2 : 2 * pi / 3) * sum / density;
}

double mixture_energy_change(double restitution, const Component& one, const Component& two) {
  const double reduced = one.mass * two.mass / (one.mass + two.mass);
  return -2 * (1 + restitution) * reduced / one.mass *
         (one.temperature - (1 + restitution) / 2 * reduced * spread(one, two));
}

double mixture_temperature_ratio(int dimension, double restitution, Component one, Component two,
                                 const ThreePairs& contact) {
  gsl_set_error_handler_off();
  Cooling cooling{dimension, restitution, one, two, contact};
  gsl_function function{difference_at, &cooling};
  const std::unique_ptr<gsl_root_fsolver, void (*)(gsl_root_fsolver*)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  if (gsl_root_fsolver_set(solver.get(), &function, -14, 14) != GSL_SUCCESS) return std::nan("");
  for (int i = 0; i < 200; ++i) {
    gsl_root_fsolver_iterate(solver.get());
    if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver.get()), gsl_root_fsolver_x_upper(solver.get()),
                               1e-12, 0) == GSL_SUCCESS)
      break;
  }
  return std::exp(gsl_root_fsolver_root(solver.get()));
}

}  // namespace sandglass::law
