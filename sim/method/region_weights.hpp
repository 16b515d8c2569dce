#pragma once

#include "sim/scene/scene.hpp"
#include "sim/space/grid.hpp"

#include <span>
#include <vector>

namespace sandglass {

/// Real particles per simulated one in every cell of a scene with regions.
template <int D>
class RegionWeights {
 public:
  RegionWeights(const Scene& scene, const Grid<D>& grid);
  /// With the cells that the scene chose: with regions it has.
  explicit RegionWeights(const Scene& scene);

  std::span<const double> of_cells() const { return weights_; }
  double at(const Vector<D>& position) const { return weights_[grid_.cell_of(position)]; }
  double lightest() const;
  /// Simulated particles per real one, in the mean over the box.
  double mean_inverse() const;

  /// Of the cells along a side of the box.
  struct Side {
    double lightest, mean_inverse;
  };
  Side along(int axis, bool high) const;

 private:
  Grid<D> grid_;
  std::vector<double> weights_;
};

extern template class RegionWeights<2>;
extern template class RegionWeights<3>;

}  // namespace sandglass
