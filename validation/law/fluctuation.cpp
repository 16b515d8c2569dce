#include "validation/law/fluctuation.hpp"

#include "validation/law/state.hpp"

namespace sandglass::law {

double count_variance(const Gas& gas, double mean, double share) {
  return mean * long_wave_structure(gas) * (1 - share);
}

double white_spectrum_level(double variance, double samples) { return 2 * variance / samples; }

}  // namespace sandglass::law
