#pragma once

#include "sim/observe/observer.hpp"

namespace sandglass {

/// Even velocity moments to order 8, relative to the sample's own second moment: of one component (averaged over axes)
/// and of the speed. Components m2, m4, m6, m8, s4, s6, s8. In a mixture of sqrt(m) C, so that a mixture in equilibrium
/// shows Maxwell's values.
template <int D>
class Moments final : public Observer<D> {
 public:
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  void start(const View<D>& view) override;
};

/// Particles by one velocity component; the outer bins take what lies beyond the range.
template <int D>
class VelocityHistogram final : public Observer<D> {
 public:
  explicit VelocityHistogram(const ObserverSpec& spec) : spec_(spec) {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;

 private:
  ObserverSpec spec_;
};

/// Amplitude (2/M) sum m v_x sin(2 pi n y / L_y) of a shear wave, or its cosine part; M is the mass of all particles.
template <int D>
class ShearMode final : public Observer<D> {
 public:
  ShearMode(int periods, bool cosine) : periods_(periods), cosine_(cosine) {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;

 private:
  int periods_;
  bool cosine_;
};

}  // namespace sandglass
