#pragma once

#include "sim/observe/lattice.hpp"
#include "sim/observe/observer.hpp"

namespace sandglass {

/// Number density of the real particles of each species in the bins of a regular grid. Shape [bins of axis 0, ...,
/// species].
template <int D>
class SpeciesDensity final : public Observer<D> {
 public:
  /// Reads `grid` and `species`.
  explicit SpeciesDensity(const ObserverSpec& spec) : bins_{spec.grid}, species_(spec.species.size()) {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;

 private:
  Lattice<D> bins_;
  std::size_t species_;
};

}  // namespace sandglass
