#include "sim/observe/spin_temperature.hpp"

#include "sim/observe/population.hpp"
#include "sim/observe/rotation.hpp"

namespace sandglass {

template <int D>
Quantity SpinTemperature<D>::quantity() const {
  return {"spin-temperature",
          "mass length^2 time^-2",
          "per bin: rotational granular temperature",
          bins_.extents,
          {},
          {},
          ""};
}

template <int D>
void SpinTemperature<D>::start(const View<D>& view) {
  require_spins(view, "spin-temperature");
}

template <int D>
std::vector<double> SpinTemperature<D>::measure(const View<D>& view) {
  const auto spins = view.columns.get(column::spin<D>);
  return with_population(view, [&](const auto& all) {
    std::vector<double> energy(bins_.size()), count(bins_.size());
    for (std::uint32_t i = 0; i < view.particles.size(); ++i) {
      const std::size_t bin = bins_.bin_of(view.particles[i].position, view.box);
      energy[bin] += all.weight(i) * all.inertia(i) * spins[i].squaredNorm();
      count[bin] += all.weight(i);
    }
    constexpr double freedom = Spin<D>::RowsAtCompileTime;
    for (std::size_t bin = 0; bin < energy.size(); ++bin)
      energy[bin] *= count[bin] > 0 ? all.inertia_unit() / (freedom * count[bin]) : 0;
    return energy;
  });
}

template class SpinTemperature<2>;
template class SpinTemperature<3>;

}  // namespace sandglass
