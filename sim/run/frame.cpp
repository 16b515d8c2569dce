#include "sim/run/frame.hpp"

#include <algorithm>

namespace sandglass {

namespace {
/// What species differ in, particle by particle, so that a file can be read without its scene.
template <int D>
void add_trait(const View<D>& view, const ColumnKey<double>& key, double SpeciesTraits::*trait,
               Columns& columns) {
  const auto species = view.columns.get(column::species);
  const auto differs = [&](const SpeciesTraits& one) { return one.*trait != view.traits.front().*trait; };
  if (species.empty() || std::ranges::none_of(view.traits, differs)) return;
  std::vector<double> values;
  values.reserve(species.size());
  for (const std::uint8_t kind : species) values.push_back(view.traits[kind].*trait);
  columns.set(key, values);
}
}  // namespace

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
  add_trait(view, column::diameter, &SpeciesTraits::diameter, frame.columns);
  add_trait(view, column::mass, &SpeciesTraits::mass, frame.columns);
  return frame;
}

template <int D>
Particles<D> particles_of(const Frame& frame) {
  Particles<D> particles{std::vector<Phase<D>>(frame.particles(D)), frame.columns};
  for (const auto& key : {column::diameter, column::mass})
    particles.columns.remove(key.name);  // the scene knows
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
