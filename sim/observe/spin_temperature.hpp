#pragma once

#include "sim/observe/lattice.hpp"
#include "sim/observe/observer.hpp"

namespace sandglass {

/// Rotational granular temperature <I w^2> per degree of freedom in the bins of a regular grid; no mean is taken off. Shape
/// [bins of axis 0, ...]; empty bins have zero.
template <int D>
class SpinTemperature final : public Observer<D> {
 public:
  explicit SpinTemperature(const ObserverSpec& spec) : bins_{spec.grid} {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  void start(const View<D>& view) override;

 private:
  Lattice<D> bins_;
};

}  // namespace sandglass
