#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/gap.hpp"
#include "validation/law/enskog.hpp"
#include "validation/law/transport.hpp"

#include <cmath>
#include <numbers>

// Heat and shear between diffuse walls, from free flight to the continuum.

namespace sandglass {

namespace {
using Some = GapFlow::Some;
using std::numbers::pi;

double middle_of(const law::EndCorrection& correction) { return (correction.least + correction.most) / 2; }

/// An interpolated flux and how much of it the end correction leaves open.
struct Expected {
  double flux, half_width;
};

Expected between(double free, double dense, const law::EndCorrection& correction) {
  const double flux = law::interpolated_flux(free, dense, middle_of(correction));
  return {flux, std::abs(law::interpolated_flux(free, dense, correction.least) - flux)};
}

/// Edge of a cell across the gap over the mean free path; 0 without cells.
double cell_over_path(const Subject& subject) {
  const std::vector<double> cells = cells_along(subject.scene());
  if (cells.empty()) return 0;
  return subject.scene().domain.size[1] / cells[1] / law::mean_free_path(subject.gas(1));
}

/// Excess of viscosity and conductivity that cells and steps of DSMC make, to second order: momentum and energy pass between
/// partners a part of a cell apart, and all fly freely for a step. docs/theory.md
double step_excess(const Subject& subject, double cell_part, double step_part) {
  const double cell = cell_over_path(subject), step = subject.collisions_per_step();
  return cell == 0 ? 0 : cell_part * cell * cell + step_part * step * step;
}
double viscosity_excess(const Subject& subject) {
  return subject.dimension() == 2 ? step_excess(subject, pi / 24, 1.0 / 12)
                                  : step_excess(subject, 16 / (45 * pi), 4.0 / 75);
}
double conductivity_excess(const Subject& subject) {
  return subject.dimension() == 2 ? step_excess(subject, pi / 96, 1.0 / 48)
                                  : step_excess(subject, 32 / (225 * pi), 16.0 / 675);
}

/// Of hard particles: what passes across the diameter, twice the excluded fraction to first order.
double size_excess(const Subject& subject) {
  return touches(subject.scene()) ? 2 * law::excluded_fraction(subject.gas(1)) : 0;
}

/// (T2 - T1)^2/(T2 + T1)^2 over four: the interpolation is exact in both limits, between them to first order.
double nonlinear(const law::Gap& gap) {
  const double part =
      (gap.high_temperature - gap.low_temperature) / (gap.high_temperature + gap.low_temperature);
  return part * part / 4;
}

/// Rise of the viscosity by the heat of the shear itself: T rises by eta U^2/(8 kappa) in the middle, two thirds of it in the
/// mean, and the viscosity goes as its root.
double heating(const law::Gap& gap) {
  const double ratio = law::boltzmann_shear_viscosity(gap.gas, law::SonineOrder::converged) /
                       law::boltzmann_conductivity(gap.gas, law::SonineOrder::converged);
  return ratio * gap.sliding * gap.sliding / 8 / gap.gas.temperature / 3;
}

Figure profile_figure(const GapFlow& flow, bool of_velocity) {
  Figure figure{of_velocity ? "Velocity between the walls" : "Temperature between the walls",
                {"distance", "length", false},
                {of_velocity ? "velocity along x" : "temperature",
                 of_velocity ? "length/time" : "mass length^2 time^-2", false},
                {},
                {}};
  Figure::Points points{"measured", {}, {}, {}, {}};
  for (std::size_t bin = 0; bin < flow.bins(); ++bin) {
    std::vector<double> values;
    for (const std::size_t replica : flow.all())
      values.push_back(of_velocity ? flow.velocity(replica, bin) : flow.temperature(replica, bin));
    const Mean mean = mean_of_independent(values);
    points.x.push_back(flow.height(bin));
    points.y.push_back(mean.value);
    points.error.push_back(mean.standard_error);
  }
  figure.points.push_back(std::move(points));
  const law::Gap& gap = flow.gap();
  const double end = flow.height(flow.bins() - 1) + flow.height(0);
  figure.lines.push_back({"straight from wall to wall",
                          {0, end},
                          {of_velocity ? -gap.sliding / 2 : gap.low_temperature,
                           of_velocity ? gap.sliding / 2 : gap.high_temperature}});
  return figure;
}

Evidence over(const GapFlow& flow, double expected, const std::function<double(Some)>& measured) {
  return from_mean(jackknife(flow.all().size(), [&](Some replicas) { return measured(replicas) / expected; }),
                   1);
}

Evidence wall_heat_flux(const Subject& subject, const law::Arguments& numbers) {
  const GapFlow flow(subject, numbers.at("settle-time"));
  const law::Gap& gap = flow.gap();
  const Expected law =
      between(law::free_molecular_heat_flux(gap), law::continuum_heat_flux(gap), law::jump_correction());
  Evidence evidence = over(flow, law.flux, [&](Some replicas) { return flow.heat(replicas); });
  evidence.budget.systematic = std::abs(law.half_width / law.flux) + nonlinear(gap) +
                               conductivity_excess(subject) + size_excess(subject);
  evidence.budget.reason =
      "jump between its two limits; difference of the walls to second order; cells and steps; size of the "
      "particles";
  evidence.figures.push_back(profile_figure(flow, false));
  return evidence;
}

Evidence wall_shear_stress(const Subject& subject, const law::Arguments& numbers) {
  const GapFlow flow(subject, numbers.at("settle-time"));
  const law::Gap& gap = flow.gap();
  const Expected law = between(law::free_molecular_shear_stress(gap), law::continuum_shear_stress(gap),
                               law::slip_correction());
  Evidence evidence = over(flow, law.flux, [&](Some replicas) { return flow.stress(replicas); });
  evidence.budget.systematic =
      std::abs(law.half_width / law.flux) + heating(gap) + viscosity_excess(subject) + size_excess(subject);
  evidence.budget.reason =
      "slip between its two limits; heat of the shear; cells and steps; size of the particles";
  evidence.figures.push_back(profile_figure(flow, true));
  return evidence;
}

/// What the layers at the walls still are in the outermost bins that count: a hundredth of the slope where these lie two mean
/// free paths away (tables of Sone 2007, sec. 3.1.5), and Burnett's terms, the square of the mean free path over the gap.
double wall_layers(const Subject& subject, const law::Gap& gap) {
  const double path = law::mean_free_path(subject.gas(1)) / gap.width;
  return 0.01 * std::exp(2 - 0.2 / path) + path * path;
}

/// From the straight line of T^(3/2), mean of both walls: between Maxwell's estimate and the largest length known, and off by
/// what the slope is off, over the whole distance from the middle.
Evidence jump_length(const Subject& subject, const law::Arguments& numbers) {
  const GapFlow flow(subject, numbers.at("settle-time"));
  const law::Gap& gap = flow.gap();
  const law::EndCorrection correction = law::jump_correction();
  const double maxwell = law::jump_length_maxwell(gap.gas);
  const double step = std::pow(gap.high_temperature, 1.5) - std::pow(gap.low_temperature, 1.5);
  Evidence evidence = over(flow, maxwell, [&](Some replicas) {
    return (step / flow.temperature_slope(replicas) - gap.width) / 2;
  });
  evidence.expected = middle_of(correction);
  evidence.budget.systematic = (correction.most - correction.least) / 2 +
                               (wall_layers(subject, gap) + conductivity_excess(subject)) *
                                   (gap.width / 2 / maxwell + correction.most) +
                               4 * nonlinear(gap);
  evidence.budget.reason = "between Maxwell's estimate and the largest known; slope of the bulk";
  evidence.figures.push_back(profile_figure(flow, false));
  return evidence;
}

CheckInfo gap_check(std::string name, std::string summary, std::string law, bool (*applies)(const Scene&),
                    Evidence (*evaluate)(const Subject&, const law::Arguments&)) {
  return {std::move(name),
          std::move(summary),
          std::move(law),
          {"fields", applies == is_fourier ? "energy-flux" : "wall-force"},
          true,
          {law::Parameter{"settle-time", "time", "samples before it are left out", 0, 1e12}},
          applies,
          evaluate};
}
}  // namespace

std::vector<CheckInfo> diffuse_wall_checks() {
  return {
      gap_check("wall-heat-flux",
                "heat between two diffuse walls over the interpolation from free flight to the continuum",
                "free-molecular-heat-flux", is_fourier, wall_heat_flux),
      gap_check("wall-shear-stress",
                "shear stress on two diffuse walls over the interpolation from free flight to the continuum",
                "free-molecular-shear-stress", is_couette, wall_shear_stress),
      gap_check(
          "jump-length",
          "length by which the temperature of the middle misses that of the walls, over Maxwell's estimate",
          "jump-length-maxwell", is_fourier, jump_length)};
}

}  // namespace sandglass
