#pragma once

#include "sim/observe/fourier.hpp"
#include "sim/observe/lattice.hpp"
#include "sim/observe/observer.hpp"

namespace sandglass {

/// Structure factor S(k) = <|sum_j w_j exp(-i k.x_j)|^2> / sum_j w_j^2 with every particle at the corner of its lattice cell (Müller
/// 2001, section 3.2: fast Fourier transform of the density on a lattice of about one diameter), averaged over the wave
/// vectors of a shell: |k| L / 2 pi nearest to 1, 2, ..., `bins`, L the longest edge of the box. Independent particles give
/// 1 on any lattice; of structure on the scale of a lattice cell nothing is seen. Periodic along every axis.
template <int D>
class StructureFactor final : public Observer<D> {
 public:
  /// Reads `grid` and `bins`.
  explicit StructureFactor(const ObserverSpec& spec);
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  /// Throws InputError for no particles, or more shells than the lattice has whole ones.
  void start(const View<D>& view) override;

 private:
  std::vector<double> shells(const std::vector<std::complex<double>>& wave, const Vector<D>& box) const;

  std::size_t bins_;
  Lattice<D> lattice_;
  Fourier fourier_;
};

}  // namespace sandglass
