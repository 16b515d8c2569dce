#include "sim/run/initial.hpp"

#include "sim/base/error.hpp"
#include "sim/run/placement.hpp"
#include "sim/run/time_step.hpp"

#include <cmath>

#include <boost/random/normal_distribution.hpp>

namespace sandglass {

namespace {

template <int D>
void draw_velocities(std::vector<Phase<D>>& particles, double thermal, const Streams& streams) {
  const StreamKey key(streams.seed, Purpose::velocities, streams.replica, 0);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    Random random(key, i);
    boost::random::normal_distribution<double> normal(0, thermal);
    for (int axis = 0; axis < D; ++axis) particles[i].velocity[axis] = normal(random);
  }
}

/// No mean velocity and exactly the granular temperature asked for, N - 1 degrees of freedom per axis.
template <int D>
void make_exact(std::vector<Phase<D>>& particles, double thermal) {
  Vector<D> mean = Vector<D>::Zero();
  for (const Phase<D>& particle : particles)
    mean += particle.velocity / static_cast<double>(particles.size());
  double square = 0;
  for (Phase<D>& particle : particles) {
    particle.velocity -= mean;
    square += particle.velocity.squaredNorm();
  }
  const double scale = thermal * std::sqrt(D * (static_cast<double>(particles.size()) - 1) / square);
  for (Phase<D>& particle : particles) particle.velocity *= scale;
}

/// Elastic collisions of the method's own kind, without gravity, before time zero.
template <int D>
void equilibrate(std::vector<Phase<D>>& particles, const Scene& scene, const Setup<D>& setup,
                 const Streams& streams) {
  dsmc::Parameters elastic = setup.parameters;
  elastic.restitution = 1;
  elastic.measure_transfer = false;
  dsmc::MotionParameters<D> motion = setup.motion;
  motion.gravity.setZero();
  dsmc::Dsmc<D> gas(setup.grid, elastic, motion, streams, Purpose::equilibration);
  gas.assign({particles, {}, {}, {}});
  TimeStepper<D> stepper(scene, setup);
  const double wanted = scene.initial.equilibrate_collisions * static_cast<double>(particles.size()) / 2;
  for (std::uint64_t step = 0; static_cast<double>(gas.tally().collisions) < wanted; ++step) {
    if (step > 1'000'000 && gas.tally().collisions == 0)
      throw InputError(
          "equilibration: no collision in a million steps; lower "
          "'initial.equilibrate-collisions-per-particle' or raise 'method.time-step'");
    gas.step(stepper.next(gas.view(), step), step);
  }
  const auto after = gas.view().particles;
  particles.assign(after.begin(), after.end());
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
Particles<D> initial_particles(const Scene& scene, const Setup<D>& setup, const Streams& streams) {
  const double thermal = thermal_speed(scene);
  std::vector<Phase<D>> particles = place<D>(scene, setup.particles, streams);
  draw_velocities(particles, thermal, streams);
  if (scene.initial.exact && scene.initial.temperature > 0) make_exact(particles, thermal);
  if (scene.initial.equilibrate_collisions > 0) equilibrate(particles, scene, setup, streams);
  set_moving(particles, scene);
  return {std::move(particles), {}, {}, {}};
}

template Particles<2> initial_particles(const Scene&, const Setup<2>&, const Streams&);
template Particles<3> initial_particles(const Scene&, const Setup<3>&, const Streams&);

}  // namespace sandglass
