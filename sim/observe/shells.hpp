#pragma once

#include "sim/observe/observer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sandglass {

/// Equal bins of the distance of two particles, `range` and `bins` of an observer.
class Shells {
 public:
  /// Throws InputError for a range that is not one of distances.
  explicit Shells(const ObserverSpec& spec);

  /// Throws InputError for what pairs of particles need: two particles, no weights, and a box of at least twice the reach.
  template <int D>
  void require(const View<D>& view) const {
    require(view.particles.size(), !view.columns.get(column::weight).empty(), view.box.minCoeff() / 2);
  }

  std::size_t size() const { return bins_; }
  double reach() const { return range_[1]; }
  /// Shell of a distance below the reach; none for one below the first edge.
  std::optional<std::size_t> shell_of(double square) const {
    const double bin = (std::sqrt(square) - range_[0]) * per_length_;
    if (bin < 0) return std::nullopt;
    // The root may round up to the far edge.
    return static_cast<std::size_t>(std::min(bin, static_cast<double>(bins_) - 0.5));
  }

 private:
  void require(std::size_t particles, bool weighted, double most) const;

  std::string what_;
  std::array<double, 2> range_;
  std::size_t bins_;
  double per_length_;
};

}  // namespace sandglass
