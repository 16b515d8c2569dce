#include "sim/method/dsmc/cell_stage.hpp"

namespace sandglass::dsmc {

template <int D>
void CellFields<D>::update(const CellNeeds& needs, const ParticleStore<D>& store) {
  const std::size_t cells = store.cells().size();
  const std::span<const double> volumes = store.cells().volumes();
  density.resize(needs.density ? cells : 0);
  velocity.resize(needs.velocity ? cells : 0);
  energy.resize(needs.energy ? cells : 0);
  if (!needs.density && !needs.velocity && !needs.energy) return;
  const auto offsets = store.offsets();
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const auto particles = store.phases().subspan(offsets[cell], offsets[cell + 1] - offsets[cell]);
    const auto count = static_cast<double>(particles.size());
    Vector<D> momentum = Vector<D>::Zero();
    double square = 0;
    for (const Phase<D>& particle : particles) {
      momentum += particle.velocity;
      square += particle.velocity.squaredNorm();
    }
    if (needs.density) {
      density[cell] = count / store.grid().cell_volume();
      if (!volumes.empty()) density[cell] /= volumes[cell];
    }
    if (needs.velocity) velocity[cell] = momentum / std::max(count, 1.0);
    if (needs.energy) energy[cell] = 0.5 * square;
  }
}

template struct CellFields<2>;
template struct CellFields<3>;

}  // namespace sandglass::dsmc
