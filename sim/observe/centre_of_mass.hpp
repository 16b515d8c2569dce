#pragma once

#include "sim/observe/observer.hpp"

namespace sandglass {

/// Mean position of the real particles, by mass, along the axes that are not periodic: on a periodic one no point is the
/// middle. Along gravity it is the height of the centre of mass (Müller 2001, section 3.7).
template <int D>
class CentreOfMass final : public Observer<D> {
 public:
  /// Reads `bounded`. Throws InputError when every axis is periodic.
  explicit CentreOfMass(const ObserverSpec& spec);
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;

 private:
  std::vector<int> axes_;
};

}  // namespace sandglass
