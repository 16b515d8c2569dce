#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/pipe.hpp"
#include "validation/check/spectrum_fit.hpp"
#include "validation/law/fluctuation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

// Density in slices of a pipe: variance of the count over that of an elastic fluid, and exponent of its power spectrum.

namespace sandglass {

namespace {
std::vector<PipeSlices> all_runs(const Subject& subject, const law::Arguments& numbers) {
  std::vector<PipeSlices> runs;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    runs.push_back(pipe_slices(subject, replica, numbers.at("settle-time"),
                               static_cast<std::size_t>(numbers.at("slices"))));
  return runs;
}

/// Variance of the number of real particles, which the law knows, in simulated ones: w particles in one scatter as
/// those of the law do at their own density only for weight 1.
double elastic_variance(const Subject& subject, std::size_t slices) {
  const double share = 1 / static_cast<double>(slices);
  return law::count_variance(subject.gas(1), subject.particles() * share, share);
}

Mean variance_ratio(const std::vector<PipeSlices>& runs, double expected) {
  return jackknife(runs.size(),
                   [&](std::span<const std::size_t> used) { return slice_variance(runs, used) / expected; });
}

/// Of the fluid as the cells see it.
double cell_variance(const Subject& subject, std::size_t slices, double window) {
  const Scene& scene = subject.scene();
  const auto along = static_cast<std::size_t>(pipe_axis(scene));
  const double share = 1 / static_cast<double>(slices), length = scene.domain.size[along];
  const law::CellFluid cells{capabilities(scene).cells ? length / cells_along(scene)[along] : 0, window};
  return law::cell_count_variance(subject.gas(1), subject.particles() * share, share, length, cells);
}

Evidence pipe_count_variance(const Subject& subject, const law::Arguments& numbers) {
  const std::vector<PipeSlices> runs = all_runs(subject, numbers);
  const double expected = cell_variance(subject, runs.front().slices, numbers.at("window"));
  return from_mean(variance_ratio(runs, expected), 1);
}

Evidence pipe_waves(const Subject& subject, const law::Arguments& numbers) {
  const std::vector<PipeSlices> runs = all_runs(subject, numbers);
  const double elastic = elastic_variance(subject, runs.front().slices);
  Evidence evidence = from_mean(variance_ratio(runs, elastic), numbers.at("least"));
  evidence.kind = Expectation::between;
  evidence.upper = numbers.at("most");
  return evidence;
}

/// Mean over slices, which share their waves: the average counts as one spectrum a replica.
Spectrum mean_spectrum(const PipeSlices& run) {
  std::vector<Spectrum> spectra;
  for (std::size_t slice = 0; slice < run.slices; ++slice)
    spectra.push_back(power_spectrum(run.slice(slice), run.interval));
  Spectrum mean = average(spectra);
  mean.averages = 1;
  return mean;
}

Spectrum spectrum_of(const std::vector<Spectrum>& spectra, std::span<const std::size_t> used) {
  std::vector<Spectrum> chosen;
  for (const std::size_t replica : used) chosen.push_back(spectra[replica]);
  return average(chosen);
}

/// From `low-cut` passages of the whole pipe to `high-cut` passages of a slice in unit time.
SpectrumRange range_of(const Subject& subject, const std::vector<PipeSlices>& runs,
                       const law::Arguments& numbers) {
  double speed = 0;
  for (std::size_t replica = 0; replica < runs.size(); ++replica)
    speed += typical_speed(subject, replica, numbers.at("settle-time")) / static_cast<double>(runs.size());
  const double thickness = runs.front().thickness;
  const double length = thickness * static_cast<double>(runs.front().slices);
  return {numbers.at("low-cut") * speed / length,
          std::min(numbers.at("high-cut") * speed / thickness, 0.45 / runs.front().interval), 3,
          numbers.at("peak-alarm")};
}

Figure spectrum_figure(const Spectrum& spectrum, const SpectrumRange& range, const SpectrumFit& fit) {
  Figure figure{"Power spectrum of the count in a slice",
                {"frequency", "1/time", true},
                {"power", "particles^2", true},
                {},
                {}};
  Figure::Points points{"measured", {}, {}, {}, {}};
  const double factor = 1.1;  // lines of one bin of the logarithm
  for (std::size_t i = 0; i < spectrum.frequency.size();) {
    double power = 0, frequency = 0, lines = 0;
    const double first = spectrum.frequency[i];
    for (; i < spectrum.frequency.size() && spectrum.frequency[i] < first * factor; ++i, ++lines)
      power += spectrum.power[i], frequency += spectrum.frequency[i];
    points.x.push_back(frequency / lines);
    points.y.push_back(power / lines);
    points.error.push_back(power / lines / std::sqrt(lines * spectrum.averages));
  }
  figure.points.push_back(std::move(points));
  figure.lines.push_back({fmt::format("f^{:.2f} ± {:.2f}", fit.exponent, fit.exponent_error),
                          {range.low, range.high},
                          {fit.power_at(range.low), fit.power_at(range.high)}});
  return figure;
}

Evidence pipe_spectrum(const Subject& subject, const law::Arguments& numbers) {
  const std::vector<PipeSlices> runs = all_runs(subject, numbers);
  std::vector<Spectrum> spectra;
  for (const PipeSlices& run : runs) spectra.push_back(mean_spectrum(run));
  const SpectrumRange range = range_of(subject, runs, numbers);
  std::vector<std::size_t> every(spectra.size());
  std::iota(every.begin(), every.end(), 0U);
  const Spectrum mean = spectrum_of(spectra, every);
  const SpectrumFit fit = fit_spectrum(mean, range);
  Mean exponent{fit.exponent, fit.exponent_error, 0, 0};
  if (spectra.size() > 1)
    exponent = jackknife(spectra.size(), [&](std::span<const std::size_t> used) {
      return fit_spectrum(spectrum_of(spectra, used), range, fit.peaks).exponent;
    });
  Evidence evidence = from_mean(exponent, numbers.at("least"));
  evidence.kind = Expectation::between;
  evidence.upper = numbers.at("most");
  evidence.summary = fmt::format(
      "exponent of the power spectrum from f = {:.3g} to {:.3g}, {} peaks left out; "
      "curvature {:.2f} ± {:.2f}",
      range.low, range.high, fit.peaks.size(), fit.curvature, fit.curvature_error);
  evidence.figures.push_back(spectrum_figure(mean, range, fit));
  return evidence;
}

std::vector<law::Parameter> with_slices(std::vector<law::Parameter> more) {
  std::vector<law::Parameter> all{{"settle-time", "time", "samples before it are left out", 0, 1e12},
                                  {"slices", "1", "slices along the pipe; 0: all bins", 0, 1e6, 0.0}};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

bool has_pipe(const Scene& scene) { return pipe_axis(scene) >= 0; }
}  // namespace

std::vector<CheckInfo> pipe_wave_checks() {
  CheckInfo variance{
      "pipe-count-variance",
      "variance of the number of particles in a slice of a pipe at rest over that of a fluid",
      "cell-count-variance",
      {"fields"},
      true,
      with_slices({{"window", "1", "cells along the pipe that the contact value reads", 1, 1e6, 1.0, 1}}),
      is_pipe_at_rest,
      pipe_count_variance};
  CheckInfo waves{"pipe-waves",
                  "variance of the number of particles in a slice of a pipe over that of an elastic fluid",
                  "count-variance",
                  {"fields"},
                  false,
                  with_slices({{"least", "1", "lower bound of the ratio", 0, 1e6},
                               {"most", "1", "upper bound of the ratio", 0, 1e6}}),
                  is_falling_pipe,
                  pipe_waves};
  CheckInfo spectrum{
      "pipe-spectrum",
      "exponent of the power spectrum of the density in a slice of a pipe",
      "white-spectrum-level",
      {"fields", "energy"},
      false,
      with_slices({{"low-cut", "1", "lowest frequency, in passages of the pipe", 0, 1e6, 2.0},
                   {"high-cut", "1", "highest, in passages of a slice", 0, 1e6, 0.25},
                   {"peak-alarm", "1", "probability to leave out a peak that is none; 0: leave none out", 0,
                    0.5, 0.0},
                   {"least", "1", "lower bound of the exponent", -10, 10},
                   {"most", "1", "upper bound of the exponent", -10, 10}}),
      has_pipe,
      pipe_spectrum};
  return {std::move(variance), std::move(waves), std::move(spectrum)};
}

}  // namespace sandglass
