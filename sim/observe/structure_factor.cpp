#include "sim/observe/structure_factor.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/population.hpp"

#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
/// Whole waves along an axis that place `place` of the transform stands for.
double waves(std::size_t place, std::size_t extent) {
  return place <= extent / 2 ? static_cast<double>(place)
                             : static_cast<double>(place) - static_cast<double>(extent);
}

/// Largest |k| L / 2 pi that every axis of the lattice resolves.
template <int D>
double resolved(const Lattice<D>& lattice, const Vector<D>& box) {
  double least = INFINITY;
  for (int axis = 0; axis < D; ++axis) {
    const auto half = static_cast<double>(lattice.extents[static_cast<std::size_t>(axis)] / 2);
    least = std::min(least, half * box.maxCoeff() / box[axis]);
  }
  return least;
}
}  // namespace

template <int D>
StructureFactor<D>::StructureFactor(const ObserverSpec& spec)
    : bins_(spec.bins), lattice_{spec.grid}, fourier_(spec.grid) {}

template <int D>
Quantity StructureFactor<D>::quantity() const {
  ObserverSpec shells;
  shells.range = {0.5, static_cast<double>(bins_) + 0.5};
  shells.bins = bins_;
  return {"structure-factor",
          "1",
          "structure factor of the density, averaged over shells of |k|",
          {bins_},
          {},
          bin_edges(shells),
          "|k| L / 2 pi"};
}

template <int D>
void StructureFactor<D>::start(const View<D>& view) {
  if (view.particles.empty())
    throw InputError("the observer 'structure-factor' needs particles; remove it, or add particles");
  const double most = resolved(lattice_, view.box);
  if (static_cast<double>(bins_) > most)
    throw InputError(
        fmt::format("'observe.bins' of the observer 'structure-factor' is {}, but the lattice resolves "
                    "wave numbers to {} only; lower 'observe.bins' or refine 'observe.grid'",
                    bins_, std::floor(most)));
}

template <int D>
std::vector<double> StructureFactor<D>::measure(const View<D>& view) {
  std::vector<std::complex<double>> wave(lattice_.size());
  const double squares = with_population(view, [&](const auto& all) {
    double sum = 0;
    for (std::uint32_t i = 0; i < view.particles.size(); ++i) {
      wave[lattice_.bin_of(view.particles[i].position, view.box)] += all.weight(i);
      sum += all.weight(i) * all.weight(i);
    }
    return sum;
  });
  fourier_.forward(wave);
  std::vector<double> values = shells(wave, view.box);
  for (double& value : values) value /= squares;
  return values;
}

/// Mean square of the waves in each shell.
template <int D>
std::vector<double> StructureFactor<D>::shells(const std::vector<std::complex<double>>& wave,
                                               const Vector<D>& box) const {
  const Vector<D> aspect = box.maxCoeff() * box.cwiseInverse();
  std::vector<double> sum(bins_), count(bins_);
  for (std::size_t mode = 1; mode < wave.size(); ++mode) {
    Vector<D> number;
    std::size_t rest = mode;
    for (int axis = D - 1; axis >= 0; --axis) {
      const std::size_t extent = lattice_.extents[static_cast<std::size_t>(axis)];
      number[axis] = waves(rest % extent, extent) * aspect[axis];
      rest /= extent;
    }
    const double nearest = std::round(number.norm());
    if (nearest < 1 || nearest > static_cast<double>(bins_)) continue;
    const auto shell = static_cast<std::size_t>(nearest) - 1;
    sum[shell] += std::norm(wave[mode]);
    ++count[shell];
  }
  for (std::size_t shell = 0; shell < bins_; ++shell) sum[shell] /= count[shell];
  return sum;
}

template class StructureFactor<2>;
template class StructureFactor<3>;

}  // namespace sandglass
