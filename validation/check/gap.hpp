#pragma once

#include "validation/check/subject.hpp"
#include "validation/law/diffuse_walls.hpp"

#include <span>

/// A plain gas between two thermal walls across y, at rest or sliding along x.
namespace sandglass {

bool is_gap(const Scene& scene);
/// The walls differ in temperature alone, or in velocity alone.
bool is_fourier(const Scene& scene);
bool is_couette(const Scene& scene);

/// What a set of replicas shows on average from a time on.
class GapFlow {
 public:
  GapFlow(const Subject& subject, double settle_time);

  using Some = std::span<const std::size_t>;
  /// Heat from the high wall to the low one, per area and time: what the particles carry, mean over the gap, as in a steady
  /// flow it is the same everywhere. Needs `energy-flux`.
  double heat(Some replicas) const { return average(heat_, replicas); }
  /// Shear stress, positive where the high wall slides towards larger x. Needs `wall-force`.
  double stress(Some replicas) const { return average(stress_, replicas); }

  /// Of the straight line through the bins whose centres lie in the middle of the height, of the temperature to the power
  /// 3/2, which is straight where the conductivity goes as its root.
  double temperature_slope(Some replicas) const;

  /// The law's gap: what the centres of the particles can reach, and the density there.
  const law::Gap& gap() const { return gap_; }
  std::vector<std::size_t> all() const;  ///< replicas
  std::size_t bins() const { return velocity_.front().size(); }
  double height(std::size_t bin) const;
  double velocity(std::size_t replica, std::size_t bin) const { return velocity_[replica][bin]; }
  double temperature(std::size_t replica, std::size_t bin) const { return temperature_[replica][bin]; }

 private:
  using Rows = std::vector<std::vector<double>>;  ///< [replica][bin]
  static double average(const std::vector<double>& values, Some replicas);

  const Subject& subject_;
  law::Gap gap_;
  double box_height_;
  Rows velocity_, temperature_;
  std::vector<double> heat_, stress_;
};

}  // namespace sandglass
