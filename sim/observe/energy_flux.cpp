#include "sim/observe/energy_flux.hpp"

#include "sim/observe/population.hpp"

namespace sandglass {

template <int D>
Quantity EnergyFlux<D>::quantity() const {
  std::vector<std::size_t> shape = bins_.extents;
  shape.push_back(D);
  return {"energy-flux",
          D == 2 ? "mass length time^-3" : "mass time^-3",
          "per bin: flux of the kinetic energy that particles carry, n <m v^2 v>/2",
          shape,
          {},
          {},
          ""};
}

template <int D>
std::vector<double> EnergyFlux<D>::measure(const View<D>& view) {
  return with_population(view, [&](const auto& all) {
    std::vector<double> flux(bins_.size() * D);
    for (std::uint32_t i = 0; i < view.particles.size(); ++i) {
      const Phase<D>& particle = view.particles[i];
      const double energy = all.real_mass(i) * particle.velocity.squaredNorm() / 2;
      double* bin = &flux[bins_.bin_of(particle.position, view.box) * D];
      for (int axis = 0; axis < D; ++axis) bin[axis] += energy * particle.velocity[axis];
    }
    const double unit = all.real_unit() * static_cast<double>(bins_.size()) / view.box.prod();
    for (double& value : flux) value *= unit;
    return flux;
  });
}

template class EnergyFlux<2>;
template class EnergyFlux<3>;

}  // namespace sandglass
