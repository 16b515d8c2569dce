#include "sim/run/initial_velocities.hpp"

#include "sim/base/error.hpp"
#include "sim/base/random.hpp"

#include <cmath>

#include <boost/random/normal_distribution.hpp>

namespace sandglass {

namespace {

/// The species of each particle, and its weight.
class Kinds {
 public:
  template <int D>
  Kinds(const Scene& scene, const Particles<D>& particles)
      : species_(scene.species),
        of_(particles.columns.get(column::species)),
        weights_(particles.columns.get(column::weight)) {}
  const Species& operator[](std::size_t i) const { return species_[of_.empty() ? 0 : of_[i]]; }
  /// 1 where all are alike.
  double weight(std::size_t i) const { return weights_.empty() ? 1 : weights_[i]; }

 private:
  const std::vector<Species>& species_;
  std::span<const std::uint8_t> of_;
  std::span<const double> weights_;
};

/// Masses count in units of the first species' mass; degrees of freedom per axis as in Population::freedom.
template <int D>
void make_exact(Particles<D>& particles, const Scene& scene, double thermal) {
  const std::size_t count = particles.phases.size();
  if (count < 2)
    throw InputError(
        "'initial.exact' cannot serve a single particle, whose mean velocity is its own; use exact = "
        "false");
  const Kinds kinds(scene, particles);
  const auto mass = [&](std::size_t i) {
    return kinds.weight(i) * (kinds[i].mass / scene.species.front().mass);
  };
  double total = 0, real = 0, shared = 0;
  for (std::size_t i = 0; i < count; ++i) {
    total += mass(i);
    real += kinds.weight(i);
    shared += kinds.weight(i) * mass(i);
  }
  Vector<D> mean = Vector<D>::Zero();
  for (std::size_t i = 0; i < count; ++i) mean += mass(i) * particles.phases[i].velocity / total;
  double square = 0;
  for (std::size_t i = 0; i < count; ++i) {
    particles.phases[i].velocity -= mean;
    square += mass(i) * particles.phases[i].velocity.squaredNorm();
  }
  const double scale = thermal * std::sqrt(D * (real - shared / total) / square);
  for (Phase<D>& particle : particles.phases) particle.velocity *= scale;
}

}  // namespace

template <int D>
void add_uniform_velocities(std::vector<Phase<D>>& particles, double bound, const Streams& streams) {
  const StreamKey key(streams.seed, Purpose::velocities, streams.replica, 0);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    Random random(key, i);
    for (int axis = 0; axis < D; ++axis) particles[i].velocity[axis] += bound * (2 * random.uniform() - 1);
  }
}

template <int D>
void draw_velocities(Particles<D>& particles, const Scene& scene, const Streams& streams) {
  if (scene.initial.uniform_velocity)
    return add_uniform_velocities(particles.phases, *scene.initial.uniform_velocity, streams);
  const StreamKey key(streams.seed, Purpose::velocities, streams.replica, 0);
  const double temperature = scene.initial.temperature;
  const Kinds kinds(scene, particles);
  for (std::size_t i = 0; i < particles.phases.size(); ++i) {
    Random random(key, i);
    boost::random::normal_distribution<double> normal(0, std::sqrt(temperature / kinds[i].mass));
    for (int axis = 0; axis < D; ++axis) particles.phases[i].velocity[axis] = normal(random);
  }
  if (scene.initial.exact && temperature > 0)
    make_exact(particles, scene, std::sqrt(temperature / scene.species.front().mass));
}

template <int D>
void draw_spins(Particles<D>& particles, const Scene& scene, const Streams& streams) {
  const std::size_t count = particles.phases.size();
  const double temperature = scene.initial.spin_temperature;
  particles.columns.set(column::spin<D>, std::vector<Spin<D>>(count, Spin<D>::Zero()));
  if (!(temperature > 0)) return;
  const StreamKey key(streams.seed, Purpose::spins, streams.replica, 0);
  const Kinds kinds(scene, particles);
  const auto spins = particles.columns.edit(column::spin<D>);
  constexpr int kComponents = Spin<D>::SizeAtCompileTime;
  double energy = 0, real = 0;  // twice the mean per degree of freedom
  for (std::size_t i = 0; i < count; ++i) real += kinds.weight(i);
  for (std::size_t i = 0; i < count; ++i) {
    const Species& kind = kinds[i];
    const double inertia =
        inertia_factor(kind, scene.domain.dimension) * kind.mass * kind.diameter * kind.diameter / 4;
    Random random(key, i);
    boost::random::normal_distribution<double> normal(0, std::sqrt(temperature / inertia));
    for (int axis = 0; axis < kComponents; ++axis) spins[i][axis] = normal(random);
    energy += kinds.weight(i) * (inertia * spins[i].squaredNorm() / (kComponents * real));
  }
  if (!scene.initial.exact) return;
  for (Spin<D>& spin : spins) spin *= std::sqrt(temperature / energy);
}

template void add_uniform_velocities(std::vector<Phase<2>>&, double, const Streams&);
template void add_uniform_velocities(std::vector<Phase<3>>&, double, const Streams&);
template void draw_velocities(Particles<2>&, const Scene&, const Streams&);
template void draw_velocities(Particles<3>&, const Scene&, const Streams&);
template void draw_spins(Particles<2>&, const Scene&, const Streams&);
template void draw_spins(Particles<3>&, const Scene&, const Streams&);

}  // namespace sandglass
