#include "validation/check/spectrum.hpp"

#include "sim/base/error.hpp"

#include <memory>

#include <gsl/gsl_fft_real.h>

namespace sandglass {

Spectrum power_spectrum(std::span<const double> samples, double interval) {
  SANDGLASS_EXPECT(samples.size() >= 4 && interval > 0);
  const std::size_t count = samples.size();
  std::vector<double> data(samples.begin(), samples.end());
  const std::unique_ptr<gsl_fft_real_wavetable, void (*)(gsl_fft_real_wavetable*)> table(
      gsl_fft_real_wavetable_alloc(count), gsl_fft_real_wavetable_free);
  const std::unique_ptr<gsl_fft_real_workspace, void (*)(gsl_fft_real_workspace*)> space(
      gsl_fft_real_workspace_alloc(count), gsl_fft_real_workspace_free);
  gsl_fft_real_transform(data.data(), 1, count, table.get(), space.get());
  Spectrum spectrum;
  const auto total = static_cast<double>(count);
  for (std::size_t k = 1; 2 * k < count; ++k) {  // half complex: real part, imaginary part, from k = 1 on
    const double square = data[2 * k - 1] * data[2 * k - 1] + data[2 * k] * data[2 * k];
    spectrum.frequency.push_back(static_cast<double>(k) / (total * interval));
    spectrum.power.push_back(2 * square / (total * total));
  }
  return spectrum;
}

Spectrum average(const std::vector<Spectrum>& spectra) {
  SANDGLASS_EXPECT(!spectra.empty());
  Spectrum mean = spectra.front();
  mean.power.assign(mean.power.size(), 0);
  mean.averages = 0;
  for (const Spectrum& spectrum : spectra) {
    SANDGLASS_EXPECT(spectrum.frequency == mean.frequency);
    mean.averages += spectrum.averages;
    for (std::size_t i = 0; i < mean.power.size(); ++i)
      mean.power[i] += spectrum.averages * spectrum.power[i];
  }
  for (double& power : mean.power) power /= mean.averages;
  return mean;
}

}  // namespace sandglass
