#pragma once

#include "sim/observe/observer.hpp"

namespace sandglass {

/// What the particles and each side of the box that is not periodic exchange per time, over the time since the previous
/// sample: the force of the particles on the side, component by component; the power of the side, work that it does on the
/// particles per time; or its heat, energy that it takes from them beside that. What particles gain is power less heat.
/// Under gravity the force on the floor is, on average, the weight of what rests and bounces on it.
template <int D>
class WallForce final : public Observer<D> {
 public:
  enum class Kind { force, power, heat };

  /// Reads `bounded`. Throws InputError when every axis is periodic.
  WallForce(const ObserverSpec& spec, Kind kind);
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  bool sums_up() const override { return true; }
  bool measures_at_start() const override { return false; }
  /// Throws InputError for a method that does not count what hits the walls, and for a weight column.
  void start(const View<D>& view) override;
  std::vector<double> save() const override;
  void load(const std::vector<double>& state) override;

 private:
  std::vector<double> totals(const View<D>& view) const;

  std::vector<int> axes_;
  Kind kind_;
  double time_ = 0;
  std::vector<double> before_;  ///< totals at the previous sample
};

}  // namespace sandglass
