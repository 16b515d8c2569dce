#include "sim/run/initial.hpp"

#include "sim/run/equilibrate.hpp"
#include "sim/run/initial_species.hpp"
#include "sim/run/initial_velocities.hpp"
#include "sim/run/placement.hpp"

#include <cmath>

namespace sandglass {

namespace {

template <int D>
Particles<D> given_particles(const Scene& scene, const Streams& streams) {
  const bool rough = is_rough(scene);
  Particles<D> particles;
  for (const GivenParticle& given : scene.given) {
    particles.phases.push_back({Eigen::Map<const Vector<D>>(given.position.data()),
                                Eigen::Map<const Vector<D>>(given.velocity.data())});
    if (scene.species.size() > 1)
      particles.columns.append(column::species, static_cast<std::uint8_t>(given.species));
    if (!rough) continue;
    const bool turns = !given.spin.empty();
    particles.columns.append(column::spin<D>, turns ? Spin<D>(Eigen::Map<const Spin<D>>(given.spin.data()))
                                                    : Spin<D>(Spin<D>::Zero()));
  }
  if (scene.initial.velocity_rounding > 0)
    add_uniform_velocities(particles.phases, scene.initial.velocity_rounding, streams);
  return particles;
}

template <int D>
void set_moving(std::vector<Phase<D>>& particles, const Scene& scene) {
  const Initial& initial = scene.initial;
  for (Phase<D>& particle : particles) {
    if (!initial.velocity.empty()) particle.velocity += Eigen::Map<const Vector<D>>(initial.velocity.data());
    if (initial.shear_wave)
      particle.velocity[0] +=
          initial.shear_wave->amplitude *
          std::sin(2 * M_PI * initial.shear_wave->periods * particle.position[1] / scene.domain.size[1]);
  }
}

}  // namespace

template <int D>
Particles<D> initial_particles(const Setup<D>& setup, const Streams& streams) {
  const Scene& scene = setup.scene;
  if (setup.particles == 0) return {};
  if (!scene.given.empty()) return given_particles<D>(scene, streams);
  Particles<D> particles;
  const bool layered = scene.initial.positions == Positions::layers;
  const std::vector<std::uint8_t> species =
      layered ? ordered_species(scene) : shuffled_species(scene, streams);
  if (!species.empty()) particles.columns.set(column::species, species);
  particles.phases = place<D>(scene, setup.particles, streams, species);
  draw_velocities(particles, scene, streams);
  if (is_rough(scene)) draw_spins(particles, scene, streams);
  if (scene.initial.equilibrate_collisions > 0) equilibrate(particles, setup, streams);
  set_moving(particles.phases, scene);
  return particles;
}

template Particles<2> initial_particles(const Setup<2>&, const Streams&);
template Particles<3> initial_particles(const Setup<3>&, const Streams&);

}  // namespace sandglass
