#pragma once

#include <complex>
#include <memory>
#include <vector>

#include <gsl/gsl_fft_complex.h>

namespace sandglass {

/// Discrete Fourier transform of an array of any extents (fastest when they have small prime factors), in place:
/// F_k = sum over j of f_j exp(-2 pi i sum_a k_a j_a / M_a). Rows along each axis in turn, by the GNU Scientific Library.
class Fourier {
 public:
  /// The last axis runs fastest.
  explicit Fourier(std::vector<std::size_t> extents);
  /// `values` has the product of the extents.
  void forward(std::vector<std::complex<double>>& values) const;

 private:
  struct Free {
    void operator()(gsl_fft_complex_wavetable* table) const { gsl_fft_complex_wavetable_free(table); }
    void operator()(gsl_fft_complex_workspace* space) const { gsl_fft_complex_workspace_free(space); }
  };
  struct Axis {
    std::size_t extent, stride;
    std::unique_ptr<gsl_fft_complex_wavetable, Free> table;
    std::unique_ptr<gsl_fft_complex_workspace, Free> space;
  };

  std::size_t size_;
  std::vector<Axis> axes_;
};

}  // namespace sandglass
