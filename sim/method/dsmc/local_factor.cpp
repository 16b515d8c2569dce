#include "sim/method/dsmc/local_factor.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::dsmc {

template <int D>
std::uint32_t window_cells(const Parameters& parameters, const LatticeOfCells<D>& cells, double particles) {
  if (parameters.factor.window > 0) return parameters.factor.window;
  const int half =
      WindowSum<D>::half_width_for(cells, particles / cells.grid().size(), window_particles(parameters));
  return 2 * static_cast<std::uint32_t>(half) + 1;
}

template <int D>
LocalContactFactor<D>::LocalContactFactor(const Parameters& parameters, const LatticeOfCells<D>& cells,
                                          const std::array<bool, D>& periodic, double particles)
    : formula_(parameters.factor.formula),
      smoothed_(parameters.factor.smoothed),
      fraction_per_particle_(parameters.weight * particle_volume(D, parameters.diameter) /
                             cells.grid().cell_volume()),
      densest_(densest_fraction(D)),
      window_(cells, periodic,
              smoothed_ ? static_cast<int>(window_cells(parameters, cells, particles) / 2) : 0),
      factor_(cells.size()) {}

template <int D>
double LocalContactFactor<D>::value(std::uint32_t cell, bool scatters) const {
  const double sum = window_.sum(cell), quantum = fraction_per_particle_ / window_.cells(cell);
  const double fraction = scatters ? std::clamp((sum - 2) * quantum, 0.0, densest_)
                                   : std::min(sum * fraction_per_particle_ / window_.cells(cell), densest_);
  const ContactValue contact = formula_(fraction);
  const double half = scatters ? 0.5 : 0;
  return std::max(0.0, contact.value - half * contact.second_derivative * fraction * quantum);
}

template <int D>
void LocalContactFactor<D>::update(std::span<const std::uint32_t> offsets, const SharedCells& work,
                                   const std::uint8_t* full) {
  window_.update(offsets, work);
  const auto fill = [&](auto scatters) {
    for (std::uint32_t cell = work.first(); cell < work.last(); ++cell)
      factor_[cell] = value(cell, scatters(cell));
  };
  if (!smoothed_) return fill([](std::uint32_t) { return false; });
  if (full == nullptr) return fill([](std::uint32_t) { return true; });
  fill([full](std::uint32_t cell) { return full[cell] == 0; });
}

template std::uint32_t window_cells(const Parameters&, const LatticeOfCells<2>&, double);
template std::uint32_t window_cells(const Parameters&, const LatticeOfCells<3>&, double);
template class LocalContactFactor<2>;
template class LocalContactFactor<3>;

}  // namespace sandglass::dsmc
