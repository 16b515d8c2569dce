#include "validation/check/spectrum_fit.hpp"

#include "sim/base/error.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

namespace sandglass {

namespace {
constexpr std::size_t kFewest = 8;

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// 1, ln f and its square over the lines, each without what the ones before it hold.
struct Basis {
  std::vector<std::vector<double>> columns;

  explicit Basis(const std::vector<double>& frequency) {
    for (int power = 0; power <= 2; ++power) {
      std::vector<double> column;
      for (double f : frequency) column.push_back(std::pow(std::log(f), power));
      for (const std::vector<double>& earlier : columns) {
        const double share = dot(column, earlier) / dot(earlier, earlier);
        for (std::size_t i = 0; i < column.size(); ++i) column[i] -= share * earlier[i];
      }
      columns.push_back(std::move(column));
    }
  }

  double norm(std::size_t k) const { return std::sqrt(dot(columns[k], columns[k])); }
};

/// Coefficients of ln power in the first columns, by Fisher's scoring: the likelihood of exponential lines has the
/// information of a plain fit to logarithms of variance one, and the columns do not mix.
std::vector<double> most_likely(const Basis& basis, std::size_t columns, const std::vector<double>& power) {
  std::vector<double> coefficients(columns, 0.0);
  coefficients[0] =
      std::log(std::max(dot(basis.columns[0], power) / static_cast<double>(power.size()), 1e-300));
  for (int step = 0; step < 500; ++step) {
    std::vector<double> residual(power.size());
    for (std::size_t i = 0; i < power.size(); ++i) {
      double logarithm = 0;
      for (std::size_t k = 0; k < columns; ++k) logarithm += coefficients[k] * basis.columns[k][i];
      residual[i] = std::clamp(power[i] * std::exp(-logarithm) - 1, -1.0, 1e3);
    }
    double largest = 0;  // change of ln power
    std::vector<double> change(columns);
    for (std::size_t k = 0; k < columns; ++k) {
      change[k] = dot(basis.columns[k], residual) / dot(basis.columns[k], basis.columns[k]);
      for (double entry : basis.columns[k]) largest = std::max(largest, std::abs(change[k] * entry));
    }
    for (std::size_t k = 0; k < columns; ++k) coefficients[k] += change[k] * std::min(1.0, 1 / largest);
    if (largest < 1e-10) break;
  }
  return coefficients;
}

/// Multiples of a peak count as well, unless they lie so close that nothing would be left between them.
bool beside(double frequency, const std::vector<double>& peaks, double width) {
  return std::none_of(peaks.begin(), peaks.end(), [&](double peak) {
    const double multiple = peak < 4 * width ? 1 : std::max(1.0, std::round(frequency / peak));
    return std::abs(frequency - multiple * peak) <= width;
  });
}

/// Lines of the range beside the peaks.
Spectrum part_of(const Spectrum& spectrum, const SpectrumRange& range, const std::vector<double>& peaks) {
  const double spacing = spectrum.frequency.at(1) - spectrum.frequency.at(0);
  const double width = (static_cast<double>(range.peak_lines) + 0.5) * spacing;
  Spectrum part;
  part.averages = spectrum.averages;
  for (std::size_t i = 0; i < spectrum.frequency.size(); ++i) {
    const double frequency = spectrum.frequency[i];
    if (frequency < range.low || frequency > range.high || !beside(frequency, peaks, width)) continue;
    part.frequency.push_back(frequency);
    part.power.push_back(spectrum.power[i]);
  }
  if (part.frequency.size() < kFewest)
    throw InputError(
        fmt::format("{} lines of the spectrum lie from {} to {} beside {} peaks, {} are needed: sample "
                    "longer or widen the range",
                    part.frequency.size(), range.low, range.high, peaks.size(), kFewest));
  return part;
}

SpectrumFit fit_lines(const Spectrum& part) {
  const Basis basis(part.frequency);
  const std::vector<double> line = most_likely(basis, 2, part.power);
  const double root = std::sqrt(part.averages);
  SpectrumFit fit;
  fit.exponent = line[1];
  fit.exponent_error = 1 / (basis.norm(1) * root);
  fit.curvature = 2 * most_likely(basis, 3, part.power)[2];
  fit.curvature_error = 2 / (basis.norm(2) * root);
  fit.log_level = line[0] + line[1] * (basis.columns[1][0] - std::log(part.frequency[0]));
  fit.lines = part.power.size();
  for (std::size_t i = 0; i < part.power.size(); ++i)
    fit.scatter += std::pow(part.power[i] / fit.power_at(part.frequency[i]) - 1, 2) * part.averages /
                   static_cast<double>(fit.lines);
  return fit;
}

/// Frequency of the line that stands out most, 0 when chance explains it.
double peak_of(const Spectrum& part, const SpectrumFit& fit, double false_alarm) {
  double highest = 0, frequency = 0;
  for (std::size_t i = 0; i < part.power.size(); ++i) {
    const double ratio = part.power[i] / fit.power_at(part.frequency[i]);
    if (ratio > highest) {
      highest = ratio;
      frequency = part.frequency[i];
    }
  }
  const double chance = gsl_cdf_gamma_Q(highest * part.averages, part.averages, 1);
  return chance * static_cast<double>(part.power.size()) < false_alarm ? frequency : 0;
}
}  // namespace

double SpectrumFit::power_at(double frequency) const {
  return std::exp(log_level + exponent * std::log(frequency));
}

SpectrumFit fit_spectrum(const Spectrum& spectrum, const SpectrumRange& range) {
  SANDGLASS_EXPECT(spectrum.frequency.size() >= 2 && spectrum.averages > 0);
  std::vector<double> peaks;
  while (true) {
    const Spectrum part = part_of(spectrum, range, peaks);
    SpectrumFit fit = fit_lines(part);
    const double peak = peak_of(part, fit, range.false_alarm);
    if (peak == 0) {
      fit.peaks = std::move(peaks);
      return fit;
    }
    peaks.push_back(peak);
  }
}

SpectrumFit fit_spectrum(const Spectrum& spectrum, const SpectrumRange& range, std::vector<double> peaks) {
  SANDGLASS_EXPECT(spectrum.frequency.size() >= 2 && spectrum.averages > 0);
  SpectrumFit fit = fit_lines(part_of(spectrum, range, peaks));
  fit.peaks = std::move(peaks);
  return fit;
}

}  // namespace sandglass
