#include "sim/observe/fields.hpp"

#include "sim/observe/axes.hpp"

#include <algorithm>

namespace sandglass {

template <int D>
Quantity Fields<D>::quantity() const {
  std::vector<std::size_t> shape = spec_.grid;
  shape.push_back(D + 2);
  return {"fields",
          "length^-D; length time^-1; mass length^2 time^-2",
          "per bin: number density, mean velocity, granular temperature",
          shape,
          {},
          {},
          ""};
}

template <int D>
std::size_t Fields<D>::bins() const {
  std::size_t product = 1;
  for (std::size_t extent : spec_.grid) product *= extent;
  return product;
}

template <int D>
std::size_t Fields<D>::bin_of(const Vector<D>& position, const Vector<D>& box) const {
  std::size_t bin = 0;
  for (int axis = 0; axis < D; ++axis) {
    const std::size_t extent = spec_.grid[static_cast<std::size_t>(axis)];
    const auto along = static_cast<std::size_t>(position[axis] / box[axis] * static_cast<double>(extent));
    bin = bin * extent + std::min(along, extent - 1);
  }
  return bin;
}

template <int D>
std::vector<double> Fields<D>::measure(const View<D>& view) {
  struct Sums {
    std::size_t count = 0;
    Vector<D> mean = Vector<D>::Zero();
    double squares = 0;  ///< of the velocity relative to the mean (Welford 1962)
  };
  std::vector<Sums> sums(bins());
  for (const Phase<D>& particle : view.particles) {
    Sums& bin = sums[bin_of(particle.position, view.box)];
    const Vector<D> before = particle.velocity - bin.mean;
    bin.mean += before / static_cast<double>(++bin.count);
    bin.squares += before.dot(particle.velocity - bin.mean);
  }
  const double density = view.weight * static_cast<double>(sums.size()) / view.box.prod();
  std::vector<double> values;
  values.reserve(sums.size() * (D + 2));
  for (const Sums& bin : sums) {
    values.push_back(density * static_cast<double>(bin.count));
    values.insert(values.end(), bin.mean.data(), bin.mean.data() + D);
    values.push_back(bin.count > 1 ? view.mass * bin.squares / (D * (static_cast<double>(bin.count) - 1))
                                   : 0);
  }
  return values;
}

template class Fields<2>;
template class Fields<3>;

}  // namespace sandglass
