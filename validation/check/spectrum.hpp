#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace sandglass {

/// Lines of a power spectrum between zero and the Nyquist frequency, both left out.
struct Spectrum {
  std::vector<double> frequency, power;
  double averages = 1;  ///< independent spectra that were averaged
};

/// Mueller 2001 (3.11)-(3.12) of samples taken every `interval`; the sum of the lines is nearly the variance. No window:
/// leakage falls as f^-2, so exponents must lie above -2.
Spectrum power_spectrum(std::span<const double> samples, double interval);
/// Mean of spectra with the same frequencies.
Spectrum average(const std::vector<Spectrum>& spectra);

}  // namespace sandglass
