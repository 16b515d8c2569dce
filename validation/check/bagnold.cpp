#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/shear_cell.hpp"
#include "validation/law/contact.hpp"
#include "validation/law/haff.hpp"
#include "validation/law/uniform_shear.hpp"

#include <cmath>
#include <numbers>

// Stress of a sheared dilute gas between moving walls, against uniform shear at the rate and density that the middle of
// the gap itself has (Mueller 2001, section 3.3).

namespace sandglass {

namespace {
using Some = ShearCell::Some;
constexpr double kMiddle = 0.5;  ///< of the height: what the walls do not reach
constexpr double kInside = 0.3;  ///< of the height: where a profile that bends at the walls has another slope

law::Gas middle_gas(const ShearCell& cell, Some replicas) {
  return cell.gas(cell.bulk(replicas, kMiddle).density, 1);
}

double expected_temperature(const ShearCell& cell, Some replicas) {
  return law::dilute_shear_temperature(middle_gas(cell, replicas), cell.bulk(replicas, kMiddle).rate);
}

double stress_ratio(const ShearCell& cell, Some replicas) {
  const law::Gas gas = middle_gas(cell, replicas);
  return cell.shear_stress(replicas) / (law::number_density(gas) * expected_temperature(cell, replicas) *
                                        law::dilute_shear_stress(gas.dimension, gas.restitution).xy);
}

double temperature_ratio(const ShearCell& cell, Some replicas) {
  return cell.bulk(replicas, kMiddle).temperature / expected_temperature(cell, replicas);
}

double friction_ratio(const ShearCell& cell, Some replicas) {
  const law::Gas gas = middle_gas(cell, replicas);
  const law::ReducedStress stress = law::dilute_shear_stress(gas.dimension, gas.restitution);
  return cell.shear_stress(replicas) / cell.normal_stress(replicas) / (stress.xy / stress.yy);
}

double slope_ratio(const ShearCell& cell, Some replicas) {
  return cell.bulk(replicas, kInside).rate / cell.wall_rate();
}

/// Rate of dissipation per volume of a Maxwellian gas with this density and temperature; without a contact value where
/// the method has none.
double dissipation(const Subject& subject, const law::Gas& gas) {
  const bool dense = has_contact_value(subject.scene());
  const double factor = dense ? 1 : law::contact_value(gas.dimension, gas.fraction);
  return gas.dimension / 2.0 * law::number_density(gas) * gas.temperature * law::cooling_rate(gas) / factor;
}

/// The velocities of a sheared gas are not isotropic. To second order in the traceless part S of the stress over nT,
/// <g^3> of Gaussian relative velocities is larger by 3 S:S/32 (disks), S:S/20 (spheres): from
/// <(1 + n S n)^(3/2)> = 1 + (3/8) <(n S n)^2>.
double anisotropy(const law::Gas& gas) {
  const law::ReducedStress stress = law::dilute_shear_stress(gas.dimension, gas.restitution);
  const double other = gas.dimension == 3 ? stress.yy - 1 : 0;
  const double square =
      std::pow(stress.xx - 1, 2) + std::pow(stress.yy - 1, 2) + other * other + 2 * stress.xy * stress.xy;
  return square * (gas.dimension == 2 ? 3.0 / 32 : 1.0 / 20);
}

/// Two walls take (1 - r_w^2) T at each hit, n sqrt(T/(2 pi m)) hits per area and time: T at the pressure of the walls.
double wall_loss(const Subject& subject, const ShearCell& cell, Some replicas) {
  double loss = 0;
  for (const bool high : {false, true}) {
    const double r = wall_at(subject.scene(), 1, high).surface.restitution;
    const std::size_t bin = high ? cell.bins() - 1 : 0;
    const double temperature = cell.temperature(replicas, bin);
    loss += (1 - r * r) * cell.normal_stress(replicas) *
            std::sqrt(temperature / (2 * std::numbers::pi * subject.species().mass));
  }
  return loss * volume(subject.scene().domain) / subject.scene().domain.size[1];
}

double dissipation_ratio(const Subject& subject, const ShearCell& cell, Some replicas) {
  double expected = 0;
  for (std::size_t bin = 0; bin < cell.bins(); ++bin)
    expected += dissipation(subject, cell.gas(cell.density(replicas, bin), cell.temperature(replicas, bin)));
  expected *= volume(subject.scene().domain) / static_cast<double>(cell.bins());
  expected *= 1 + anisotropy(middle_gas(cell, replicas));
  return cell.dissipated(replicas) / (expected + wall_loss(subject, cell, replicas));
}

Figure velocity_figure(const Subject& subject, const ShearCell& cell) {
  Figure figure{"Velocity between the walls",
                {"height", "length", false},
                {"velocity along x", "length/time", false},
                {},
                {}};
  Figure::Points points{"measured", {}, {}, {}, {}};
  Figure::Line walls{"straight from wall to wall", {0, subject.scene().domain.size[1]}, {}};
  for (const bool high : {false, true}) walls.y.push_back(wall_at(subject.scene(), 1, high).velocity[0]);
  for (std::size_t bin = 0; bin < cell.bins(); ++bin) {
    const Mean mean =
        jackknife(subject.replicas(), [&](Some replicas) { return cell.velocity(replicas, bin); });
    points.x.push_back(cell.height(bin));
    points.y.push_back(mean.value);
    points.error.push_back(mean.standard_error);
    points.expected.push_back(walls.y[0] + (walls.y[1] - walls.y[0]) * points.x.back() / walls.x[1]);
  }
  figure.points.push_back(std::move(points));
  figure.lines.push_back(std::move(walls));
  return figure;
}

template <class Ratio>
Evidence over_law(const Subject& subject, const law::Arguments& numbers, Ratio ratio) {
  const ShearCell cell(subject, numbers.at("settle-time"));
  Evidence evidence =
      from_mean(jackknife(subject.replicas(), [&](Some replicas) { return ratio(cell, replicas); }), 1);
  evidence.figures.push_back(velocity_figure(subject, cell));
  return evidence;
}

Evidence dissipated_power(const Subject& subject, const law::Arguments& numbers) {
  return over_law(subject, numbers, [&subject](const ShearCell& cell, Some replicas) {
    return dissipation_ratio(subject, cell, replicas);
  });
}

template <double (*Ratio)(const ShearCell&, Some)>
Evidence ratio_of(const Subject& subject, const law::Arguments& numbers) {
  return over_law(subject, numbers, Ratio);
}

bool settles(const Scene& scene) { return is_shear_cell(scene) && scene.species.front().restitution < 1; }

CheckInfo shear_check(std::string name, std::string summary, std::string law,
                      std::function<Evidence(const Subject&, const law::Arguments&)> evaluate) {
  return {std::move(name),
          std::move(summary),
          std::move(law),
          {"fields", "wall-force", "wall-power", "energy"},
          true,
          {law::Parameter{"settle-time", "time", "samples before it are left out", 0, 1e12}},
          settles,
          std::move(evaluate)};
}
}  // namespace

std::vector<CheckInfo> bagnold_checks() {
  return {shear_check("shear-profile",
                      "slope of the velocity in the middle 30% of the gap over that from wall to wall", "",
                      ratio_of<slope_ratio>),
          shear_check("shear-stress",
                      "shear stress on the walls over that of uniform shear at the rate and density of the "
                      "middle half",
                      "uniform-shear-xy-stress-dilute", ratio_of<stress_ratio>),
          shear_check("shear-friction", "shear over normal stress on the walls, over that of uniform shear",
                      "uniform-shear-friction-dilute", ratio_of<friction_ratio>),
          shear_check("shear-temperature",
                      "temperature of the middle half over that of uniform shear at its rate and density",
                      "uniform-shear-temperature-dilute", ratio_of<temperature_ratio>),
          shear_check("shear-power",
                      "work of the walls less gain of energy over what collisions lose at the density and "
                      "temperature of each bin",
                      "cooling-rate", dissipated_power)};
}

}  // namespace sandglass
