#pragma once

#include "validation/check/spectrum.hpp"

namespace sandglass {

/// A power law by maximum likelihood: each line is an exponential variable around it (of several averages, a Gamma
/// variable), which a fit to logarithms would get wrong.
struct SpectrumFit {
  double exponent = 0, exponent_error = 0;
  double curvature = 0, curvature_error = 0;  ///< d(exponent)/d(ln f) of a parabola in logarithms
  double log_level = 0;                       ///< ln power at ln f = 0
  double scatter = 0;     ///< mean square of power over fit less one, times averages: 1 when the fit holds
  std::size_t lines = 0;  ///< used
  std::vector<double> peaks;  ///< frequencies of the peaks left out, the strongest first

  double power_at(double frequency) const;
};

/// Which lines a fit uses.
struct SpectrumRange {
  double low, high;            ///< frequencies, both included
  std::size_t peak_lines = 3;  ///< left out on either side of a peak and of its multiples
  double false_alarm = 1e-3;   ///< probability to see a peak where there is none
};

/// Fit beside the peaks: a line that stands out of the fit more than chance allows is left out with its neighbours and
/// its multiples (a wave that comes by again and again), and the fit is made again. Throws InputError when fewer than
/// eight lines are left.
SpectrumFit fit_spectrum(const Spectrum& spectrum, const SpectrumRange& range);
/// The same beside peaks that are known.
SpectrumFit fit_spectrum(const Spectrum& spectrum, const SpectrumRange& range, std::vector<double> peaks);

}  // namespace sandglass
