#include "sim/base/error.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/power_law.hpp"
#include "validation/check/vibrated_bed.hpp"
#include "validation/check/vibrated_bed_reference.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

// How high the centre of mass of a vibrated bed stands: against the law, against hard disks, and from speed to speed
// (Müller 2001, section 3.7).

namespace sandglass {

namespace {
Mean above(Mean height, double rest) {
  height.value -= rest;
  return height;
}

Figure rise_figure(const law::VibratedBed& bed, const Mean& rise) {
  Figure figure{"Rise of the centre of mass", {"V", "m/s", true}, {"H(V) - H(0)", "m", true}, {}, {}};
  figure.points.push_back({"measured", {bed.speed}, {rise.value}, {rise.standard_error}, {}});
  Figure::Points hard{"event-driven reference", {}, {}, {}, {}};
  for (const BedPoint& point : reference_of(bed)) {
    hard.x.push_back(point.speed);
    hard.y.push_back(point.rise);
    hard.error.push_back(point.standard_error);
  }
  if (!hard.x.empty()) figure.points.push_back(std::move(hard));
  Figure::Line line{"balance of energy", {}, {}};
  for (double speed = 0.03; speed < 11; speed *= 1.25) {
    law::VibratedBed other = bed;
    other.speed = speed;
    line.x.push_back(speed);
    line.y.push_back(law::vibrated_bed_rise(other));
  }
  figure.lines.push_back(std::move(line));
  return figure;
}

Evidence rise_evidence(const Subject& subject, const Mean& rise, double expected) {
  Evidence evidence = from_mean(rise, expected);
  evidence.units = "length";
  evidence.figures.push_back(rise_figure(bed_of(subject), rise));
  return evidence;
}

/// Hard particles stand a radius above the bottom, points on it; the height at rest bounds what their size adds.
Evidence against_law(const Subject& subject, const law::Arguments& numbers) {
  const law::VibratedBed bed = bed_of(subject);
  const double expected = law::vibrated_bed_rise(bed), radius = reach(subject.scene());
  Evidence evidence =
      rise_evidence(subject, above(bed_height(subject, settled_from(subject, numbers)), radius), expected);
  const double rest = bed.layers * subject.species().diameter / 2;
  evidence.budget.systematic = law::vibrated_bed_expansion(bed) * expected + rest;
  evidence.budget.reason = "the law is of first order in <U^2> m/T; size of the particles";
  evidence.summary =
      fmt::format("rise of the centre of mass; <U^2> m/T = {:.3g}", law::vibrated_bed_expansion(bed));
  return evidence;
}

Evidence against_hard_disks(const Subject& subject, const law::Arguments& numbers) {
  const law::VibratedBed bed = bed_of(subject);
  const BedPoint point = reference_at(bed, bed.speed);
  const double rest = numbers.at("rest-height");
  const Mean height = bed_height(subject, settled_from(subject, numbers));
  Evidence evidence = from_mean(height, point.rise + rest);
  evidence.units = "length";
  evidence.budget.reference = point.standard_error;
  evidence.summary = "height of the centre of mass, beside hard disks";
  evidence.figures.push_back(rise_figure(bed, above(height, rest)));
  return evidence;
}

Evidence exponent(const Subject& subject, const law::Arguments& numbers) {
  const law::VibratedBed bed = bed_of(subject);
  const Mean rise = above(bed_height(subject, settled_from(subject, numbers)), numbers.at("rest-height"));
  const BedPoint other = reference_at(bed, numbers.at("other-speed"));
  const double step = std::log(bed.speed / other.speed);
  Evidence evidence = from_mean(rise, numbers.at("expected"));
  evidence.value = std::log(rise.value / other.rise) / step;
  evidence.standard_error = std::abs(rise.standard_error / rise.value / step);
  evidence.budget.reference = std::abs(other.standard_error / other.rise / step);
  evidence.summary = fmt::format("d ln(rise)/d ln V from hard disks at V = {:g} to here", other.speed);
  evidence.figures.push_back(rise_figure(bed, rise));
  return evidence;
}
/// Hard disks from one speed to another, and the run at its own.
PowerLawFit fit_with(const law::VibratedBed& bed, const Mean& rise, const law::Arguments& numbers) {
  std::vector<double> speed{bed.speed}, rises{rise.value}, error{rise.standard_error};
  for (const BedPoint& point : reference_of(bed)) {
    if (point.speed < 0.999 * numbers.at("from-speed") || point.speed > 1.001 * numbers.at("to-speed"))
      continue;
    if (std::abs(point.speed / bed.speed - 1) < 1e-3) continue;
    speed.push_back(point.speed);
    rises.push_back(point.rise);
    error.push_back(point.standard_error);
  }
  if (speed.size() < 3)
    throw InputError(
        "a curvature needs two other speeds of the reference between 'from-speed' and 'to-speed'");
  return fit_power_law(speed, rises, error);
}

/// The part of the error that comes from the run: the curvature is linear in the logarithm of its rise.
double error_of_run(const law::VibratedBed& bed, const Mean& rise, const law::Arguments& numbers) {
  const double step = 1e-3;
  Mean higher = rise;
  higher.value *= std::exp(step);
  higher.standard_error *= std::exp(step);
  const double slope =
      (fit_with(bed, higher, numbers).curvature - fit_with(bed, rise, numbers).curvature) / step;
  return std::abs(slope * rise.standard_error / rise.value);
}

Evidence curvature(const Subject& subject, const law::Arguments& numbers) {
  const law::VibratedBed bed = bed_of(subject);
  const Mean rise = above(bed_height(subject, settled_from(subject, numbers)), numbers.at("rest-height"));
  const PowerLawFit fit = fit_with(bed, rise, numbers);
  Evidence evidence = from_mean(rise, numbers.at("expected"));
  evidence.value = fit.curvature;
  evidence.standard_error = error_of_run(bed, rise, numbers);
  evidence.budget.reference =
      std::sqrt(std::max(0.0, std::pow(fit.curvature_error, 2) - std::pow(evidence.standard_error, 2)));
  evidence.summary = fmt::format("d(exponent)/d ln V beside hard disks; exponent {:.3f} ± {:.3f}",
                                 fit.exponent, fit.exponent_error);
  evidence.figures.push_back(rise_figure(bed, rise));
  return evidence;
}
}  // namespace

std::vector<CheckInfo> vibrated_bed_rise_checks() {
  const law::Parameter settle{"settle-share", "1", "share of the run that is left out", 0, 0.9, 0.25};
  const law::Parameter rest{"rest-height", "length", "height of the centre of mass at rest", 0, 1e12};
  const law::Parameter other{"other-speed", "m/s", "V of the reference that the slope starts from", 1e-6,
                             1e6};
  const law::Parameter expected{"expected", "1", "what the value should be", -10, 10};
  const law::Parameter from{"from-speed", "m/s", "lowest V that counts", 1e-6, 1e6};
  const law::Parameter to{"to-speed", "m/s", "highest V that counts", 1e-6, 1e6};
  return {{"vibrated-bed-law",
           "rise of the centre of mass of a vibrated bed against the balance of energy",
           "vibrated-bed-rise",
           {"centre-of-mass"},
           true,
           {settle},
           is_vibrated_bed,
           against_law},
          {"vibrated-bed-height",
           "height of the centre of mass of a vibrated bed against hard disks, event-driven reference",
           "",
           {"centre-of-mass"},
           true,
           {settle, rest},
           is_vibrated_bed,
           against_hard_disks},
          {"vibrated-bed-exponent",
           "slope of ln(rise) against ln V from a speed of the event-driven reference to that of the run",
           "",
           {"centre-of-mass"},
           false,
           {settle, rest, other, expected},
           is_vibrated_bed,
           exponent},
          {"vibrated-bed-curvature",
           "how fast the exponent changes with ln V, hard disks at other speeds and the run at its own",
           "",
           {"centre-of-mass"},
           false,
           {settle, rest, from, to, expected},
           is_vibrated_bed,
           curvature}};
}

}  // namespace sandglass
