#pragma once

#include "sim/observe/shells.hpp"

namespace sandglass {

/// Volume of the shell between two distances: pi (b^2 - a^2), or 4 pi / 3 (b^3 - a^3).
double shell_volume(int dimension, double inner, double outer);

/// Pair correlation g(r) of all particles, whatever their species, in a box that is periodic along every axis: pairs
/// found in a shell over the N (N - 1) / 2 v_shell / V that independent particles would have there. Exact for shells of any
/// width up to half the shortest edge of the box (nearest image).
template <int D>
class PairCorrelation final : public Observer<D> {
 public:
  /// Reads `range` (distances) and `bins`. Throws InputError for a range that is not one of distances.
  explicit PairCorrelation(const ObserverSpec& spec) : spec_(spec), shells_(spec) {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  /// Throws InputError for fewer than 2 particles, for weights, or for a range beyond half the box.
  void start(const View<D>& view) override;

 private:
  ObserverSpec spec_;
  Shells shells_;
};

}  // namespace sandglass
