#include "sim/run/initial.hpp"

#include "sim/run/equilibrate.hpp"
#include "sim/run/initial_species.hpp"
#include "sim/run/initial_velocities.hpp"
#include "sim/run/placement.hpp"

#include <cmath>
#include <map>

namespace sandglass {

namespace {

template <int D>
Particles<D> given_particles(const Setup<D>& setup, const Streams& streams) {
  const Scene& scene = setup.scene;
  const bool rough = is_rough(scene);
  Particles<D> particles;
  for (const GivenParticle& given : scene.given) {
    particles.phases.push_back({Eigen::Map<const Vector<D>>(given.position.data()),
                                Eigen::Map<const Vector<D>>(given.velocity.data())});
    if (scene.species.size() > 1)
      particles.columns.append(column::species, static_cast<std::uint8_t>(given.species));
    if (setup.weights)
      particles.columns.append(column::weight, setup.weights->at(particles.phases.back().position));
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

/// At rest, each of its species.
template <int D>
Particles<D> placed_particles(const Scene& scene, std::uint64_t count, const Streams& streams) {
  Particles<D> particles;
  const bool layered = scene.initial.positions == Positions::layers;
  const std::vector<std::uint8_t> species =
      layered ? ordered_species(scene) : shuffled_species(scene, streams);
  if (!species.empty()) particles.columns.set(column::species, species);
  particles.phases = place<D>(scene, count, streams, species);
  return particles;
}

/// As many particles as if all had the lowest weight. Of those in a region of weight w, one in w over the lowest is kept
/// (every so many-th, so that their mass is right to half a particle), with that weight: independent particles, no copies.
template <int D>
Particles<D> placed_by_weight(const Setup<D>& setup, const Streams& streams) {
  const double lightest = setup.weights->lightest();
  Scene scene = setup.scene;
  for (Species& species : scene.species) {
    species.count = static_cast<std::uint64_t>(std::round(
        static_cast<double>(particle_count(setup.scene, species)) * (setup.scene.method.weight / lightest)));
    species.fraction.reset();
    species.number_density.reset();
  }
  const Particles<D> all = placed_particles<D>(scene, particle_count(scene), streams);
  std::map<double, double> seen;  // of each weight
  std::vector<std::uint32_t> kept;
  std::vector<double> weights;
  for (std::size_t i = 0; i < all.phases.size(); ++i) {
    const double weight = setup.weights->at(all.phases[i].position), share = lightest / weight;
    double& before = seen[weight];
    if (std::floor((before + 1) * share + 0.5) > std::floor(before * share + 0.5)) {
      kept.push_back(static_cast<std::uint32_t>(i));
      weights.push_back(weight);
    }
    ++before;
  }
  Particles<D> particles = pick(all, kept);
  particles.columns.set(column::weight, weights);
  return particles;
}

}  // namespace

template <int D>
Particles<D> initial_particles(const Setup<D>& setup, const Streams& streams) {
  const Scene& scene = setup.scene;
  if (setup.particles == 0) return {};
  if (!scene.given.empty()) return given_particles(setup, streams);
  Particles<D> particles =
      setup.weights ? placed_by_weight(setup, streams) : placed_particles<D>(scene, setup.particles, streams);
  draw_velocities(particles, scene, streams);
  if (is_rough(scene)) draw_spins(particles, scene, streams);
  if (scene.initial.equilibrate_collisions > 0) equilibrate(particles, setup, streams);
  set_moving(particles.phases, scene);
  return particles;
}

template Particles<2> initial_particles(const Setup<2>&, const Streams&);
template Particles<3> initial_particles(const Setup<3>&, const Streams&);

}  // namespace sandglass
