#include "sim/run/frame.hpp"

namespace sandglass {

template <int D>
Frame frame_of(const View<D>& view) {
  Frame frame{view.step, view.time, {}, {}};
  frame.position.reserve(D * view.particles.size());
  frame.velocity.reserve(D * view.particles.size());
  for (const Phase<D>& particle : view.particles) {
    frame.position.insert(frame.position.end(), particle.position.data(), particle.position.data() + D);
    frame.velocity.insert(frame.velocity.end(), particle.velocity.data(), particle.velocity.data() + D);
  }
  for (const ColumnView& column : view.columns) frame.columns.set(column);
  return frame;
}

template <int D>
Particles<D> particles_of(const Frame& frame) {
  Particles<D> particles{std::vector<Phase<D>>(frame.particles(D)), frame.columns};
  for (std::size_t i = 0; i < particles.phases.size(); ++i) {
    particles.phases[i].position = Eigen::Map<const Vector<D>>(&frame.position[D * i]);
    particles.phases[i].velocity = Eigen::Map<const Vector<D>>(&frame.velocity[D * i]);
  }
  return particles;
}

template Frame frame_of(const View<2>&);
template Frame frame_of(const View<3>&);
template Particles<2> particles_of(const Frame&);
template Particles<3> particles_of(const Frame&);

}  // namespace sandglass
