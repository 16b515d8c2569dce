#include "sim/method/dsmc/cell_stage.hpp"

namespace sandglass::dsmc {

template <int D>
void CellFields<D>::update(const CellNeeds& needs, const ParticleStore<D>& store) {
  const std::size_t cells = store.cells().size();
  density.resize(needs.density ? cells : 0);
  velocity.resize(needs.velocity ? cells : 0);
  energy.resize(needs.energy ? cells : 0);
  const auto fill = [&](auto& field, auto number_of) {
    const auto offsets = store.offsets();
    for (std::size_t cell = 0; cell < field.size(); ++cell)
      if (needs.where.empty() || needs.where[cell] != 0)
        field[cell] =
            number_of(cell, store.phases().subspan(offsets[cell], offsets[cell + 1] - offsets[cell]));
  };
  const std::span<const double> volumes = store.cells().volumes();
  fill(density, [&](std::size_t cell, std::span<const Phase<D>> particles) {
    const double whole = static_cast<double>(particles.size()) / store.grid().cell_volume();
    return volumes.empty() ? whole : whole / volumes[cell];
  });
  const auto mean = [](const Vector<D>& sum, std::size_t particles) {
    return Vector<D>(sum / std::max(static_cast<double>(particles), 1.0));
  };
  if (const auto sums = store.velocity_sums(); !sums.empty())
    for (std::size_t cell = 0; cell < velocity.size(); ++cell)
      velocity[cell] = mean(sums[cell], store.offsets()[cell + 1] - store.offsets()[cell]);
  else
    fill(velocity, [&](std::size_t, std::span<const Phase<D>> particles) {
      Vector<D> sum = Vector<D>::Zero();
      for (const Phase<D>& particle : particles) sum += particle.velocity;
      return mean(sum, particles.size());
    });
  fill(energy, [](std::size_t, std::span<const Phase<D>> particles) {
    double square = 0;
    for (const Phase<D>& particle : particles) square += particle.velocity.squaredNorm();
    return 0.5 * square;
  });
}

template struct CellFields<2>;
template struct CellFields<3>;

}  // namespace sandglass::dsmc
