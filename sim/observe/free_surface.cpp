#include "sim/observe/free_surface.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/axes.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sandglass {

template <int D>
FreeSurface<D>::FreeSurface(const ObserverSpec& spec) : axis_(spec.axis), bins_{spec.grid} {
  if (const std::size_t along = spec.grid.at(static_cast<std::size_t>(axis_)); along != 1)
    throw InputError(
        fmt::format("'observe.grid' of the observer 'free-surface' has {} bins along {}, the axis of the "
                    "height; give 1 there",
                    along, axis_name(axis_)));
}

template <int D>
Quantity FreeSurface<D>::quantity() const {
  std::vector<std::size_t> shape = bins_.extents;
  shape.erase(shape.begin() + axis_);
  return {"free-surface",
          "length",
          "largest coordinate " + axis_name(axis_) + " of the particles in each bin",
          shape,
          {},
          {},
          ""};
}

template <int D>
std::vector<double> FreeSurface<D>::measure(const View<D>& view) {
  std::vector<double> heights(bins_.size());
  for (const Phase<D>& particle : view.particles) {
    double& height = heights[bins_.bin_of(particle.position, view.box)];
    height = std::max(height, particle.position[axis_]);
  }
  return heights;
}

template class FreeSurface<2>;
template class FreeSurface<3>;

}  // namespace sandglass
