#include "sim/method/dsmc/local_factor.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::dsmc {

template <int D>
LocalContactFactor<D>::LocalContactFactor(const Parameters& parameters, const LatticeOfCells<D>& cells,
                                          const std::array<bool, D>& periodic, double particles)
    : formula_(parameters.factor.formula),
      smoothed_(parameters.factor.smoothed),
      fraction_per_particle_(parameters.weight * particle_volume(D, parameters.diameter) /
                             cells.grid().cell_volume()),
      densest_(densest_fraction(D)),
      window_(cells, periodic, particles / cells.grid().size(), smoothed_ ? window_particles(parameters) : 0),
      factor_(cells.size()) {}

template <int D>
double LocalContactFactor<D>::smoothed(std::uint32_t cell) const {
  const double quantum = fraction_per_particle_ / window_.cells(cell);
  const double fraction = std::clamp((window_.sum(cell) - 2) * quantum, 0.0, densest_);
  const ContactValue contact = formula_(fraction);
  return std::max(0.0, contact.value - 0.5 * contact.second_derivative * fraction * quantum);
}

template <int D>
double LocalContactFactor<D>::of_density(std::uint32_t cell) const {
  return formula_(std::min(window_.sum(cell) * fraction_per_particle_ / window_.cells(cell), densest_)).value;
}

template <int D>
void LocalContactFactor<D>::update(std::span<const std::uint32_t> offsets, const std::uint8_t* full) {
  window_.update(offsets);
  const auto counts_as_it_is = [&](std::uint32_t cell) {
    return !smoothed_ || (full != nullptr && full[cell] != 0);
  };
  for (std::uint32_t cell = 0; cell < factor_.size(); ++cell)
    factor_[cell] = counts_as_it_is(cell) ? of_density(cell) : smoothed(cell);
}

template class LocalContactFactor<2>;
template class LocalContactFactor<3>;

}  // namespace sandglass::dsmc
