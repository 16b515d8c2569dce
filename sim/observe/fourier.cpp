#include "sim/observe/fourier.hpp"

#include "sim/base/error.hpp"

namespace sandglass {

Fourier::Fourier(std::vector<std::size_t> extents) : size_(1) {
  for (auto extent = extents.rbegin(); extent != extents.rend(); ++extent) {
    SANDGLASS_EXPECT(*extent > 0);
    axes_.emplace_back(*extent, size_);
    axes_.back().table.reset(gsl_fft_complex_wavetable_alloc(*extent));
    axes_.back().space.reset(gsl_fft_complex_workspace_alloc(*extent));
    size_ *= *extent;
  }
}

void Fourier::forward(std::vector<std::complex<double>>& values) const {
  SANDGLASS_EXPECT(values.size() == size_);
  double* const data = reinterpret_cast<double*>(values.data());  // [complex.numbers]/4 allows it
  for (const Axis& axis : axes_) {
    const std::size_t slab = axis.extent * axis.stride;
    for (std::size_t start = 0; start < size_; start += slab)
      for (std::size_t row = start; row < start + axis.stride; ++row)
        gsl_fft_complex_forward(data + 2 * row, axis.stride, axis.extent, axis.table.get(), axis.space.get());
  }
}

}  // namespace sandglass
