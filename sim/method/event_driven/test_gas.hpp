#pragma once

#include "sim/base/random.hpp"
#include "sim/method/event_driven/event_driven.hpp"
#include "sim/method/event_driven/obstacle_agent.hpp"
#include "sim/method/event_driven/open_side_agent.hpp"
#include "sim/method/event_driven/plane_agent.hpp"
#include "sim/method/event_driven/wall_agent.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace sandglass::event_driven {

/// What a test starts from: a scene that can be built any number of times.
template <int D>
struct TestGas {
  Parameters<D> parameters;
  Particles<D> particles;
  std::vector<std::function<std::unique_ptr<Agent<D>>()>> agents;

  explicit TestGas(const Vector<D>& box, bool periodic = true) {
    parameters.geometry.box = box;
    parameters.geometry.periodic.fill(periodic);
    parameters.keep_ids = true;
  }

  void add(const Vector<D>& position, const Vector<D>& velocity) {
    particles.phases.push_back({position, velocity});
    parameters.particles = particles.phases.size();
  }
  void set_restitution(double r) {
    for (Surface& surface : parameters.surfaces) surface.normal.value = r;
  }
  /// Disks or spheres with spin, at rest in rotation.
  void make_rough(double tangential, double friction) {
    parameters.rough = true;
    for (SpeciesTraits& kind : parameters.species)
      kind.inertia = (D == 2 ? 0.5 : 0.4) * kind.mass * kind.diameter * kind.diameter / 4;
    for (Surface& surface : parameters.surfaces) surface.tangential = tangential, surface.friction = friction;
    particles.columns.set(column::spin<D>, std::vector<Spin<D>>(particles.phases.size(), Spin<D>::Zero()));
  }
  /// Every second particle is of another kind.
  void make_mixture(double diameter, double mass) {
    parameters.species.push_back({diameter, mass, 0});
    parameters.surfaces.assign(4, parameters.surfaces.front());
    for (std::size_t i = 0; i < particles.phases.size(); ++i)
      particles.columns.append(column::species, static_cast<std::uint8_t>(i % 2));
  }
  /// Specular walls at both sides of an axis that is not periodic.
  void add_walls(int axis, const WallRule& rule = {}, WallImpulses<D>* impulses = nullptr) {
    for (const bool high : {false, true}) {
      WallPlace<D> place;
      place.axis = axis;
      place.high = high;
      place.edge = high ? parameters.geometry.box[axis] : 0;
      place.largest_radius = parameters.largest_diameter() / 2;
      agents.push_back([this, place, rule, impulses] {
        return std::make_unique<WallAgent<D>>(place, rule, parameters.gravity, impulses);
      });
    }
    parameters.geometry.periodic[static_cast<std::size_t>(axis)] = false;
  }
  /// Both sides of an axis let particles out.
  void add_open_sides(int axis, WallImpulses<D>* impulses = nullptr) {
    for (const bool high : {false, true}) {
      const SidePlace place{axis, high, high ? parameters.geometry.box[axis] : 0};
      agents.push_back([this, place, impulses] {
        return std::make_unique<OpenSideAgent<D>>(place, parameters.gravity, impulses);
      });
    }
    parameters.geometry.periodic[static_cast<std::size_t>(axis)] = false;
  }
  void add_obstacle(const Vector<D>& centre, double radius) {
    agents.push_back([=, this] {
      return std::make_unique<ObstacleAgent<D>>(centre, radius, WallRule{}, parameters.gravity,
                                                parameters.largest_diameter() / 2);
    });
  }

  std::unique_ptr<Simulator<D>> make(EventSink<D>* trace = nullptr) const {
    auto gas = make_bare(trace);
    gas->assign(particles);
    return gas;
  }
  std::unique_ptr<Simulator<D>> make_bare(EventSink<D>* trace = nullptr) const {
    Agents<D> made;
    for (const auto& agent : agents) made.push_back(agent());
    return make_event_driven<D>(parameters, std::move(made), {1, 0}, trace);
  }
};

/// Velocities of a gas at about unit temperature and without a drift.
template <int D>
std::vector<Vector<D>> thermal_velocities(std::size_t count, std::uint64_t seed = 1) {
  Random random(StreamKey(seed, Purpose::velocities, 0, 0), 0);
  std::vector<Vector<D>> velocities(count);
  Vector<D> drift = Vector<D>::Zero();
  for (Vector<D>& velocity : velocities) {
    for (double& component : velocity.reshaped())
      component = 2 * (random.uniform() + random.uniform() + random.uniform() - 1.5);
    drift += velocity / static_cast<double>(count);
  }
  for (Vector<D>& velocity : velocities) velocity -= drift;
  return velocities;
}

/// A gas on a square or cubic lattice, `edge` particles along each axis, each moved at random within its place.
template <int D>
TestGas<D> lattice_gas(int edge, double spacing, bool periodic = true, std::uint64_t seed = 1) {
  TestGas<D> gas(Vector<D>::Constant(edge * spacing), periodic);
  const auto count = static_cast<std::size_t>(std::lround(std::pow(edge, D)));
  const auto velocities = thermal_velocities<D>(count, seed);
  Random random(StreamKey(seed, Purpose::positions, 0, 0), 0);
  for (std::size_t i = 0; i < count; ++i) {
    Vector<D> position;
    std::size_t rest = i;
    for (double& x : position.reshaped()) {
      x = (static_cast<double>(rest % static_cast<std::size_t>(edge)) + 0.5) * spacing +
          (random.uniform() - 0.5) * (spacing - 1);
      rest /= static_cast<std::size_t>(edge);
    }
    gas.add(position, velocities[i]);
  }
  return gas;
}

/// Disks in the triangular lattice of covered area `nu`.
inline TestGas<2> triangular_gas(int columns, int rows, double nu, std::uint64_t seed = 1) {
  const double spacing = std::sqrt(M_PI / (2 * std::sqrt(3.0) * nu)), height = spacing * std::sqrt(0.75);
  TestGas<2> gas(Vector<2>(columns * spacing, rows * height));
  const auto velocities = thermal_velocities<2>(static_cast<std::size_t>(columns * rows), seed);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      gas.add({(column + 0.25 + 0.5 * (row % 2)) * spacing, (row + 0.5) * height},
              velocities[gas.particles.phases.size()]);
  return gas;
}

/// Spheres in the face-centred cubic lattice of packed volume `nu`.
inline TestGas<3> cubic_gas(int edge, double nu, std::uint64_t seed = 1) {
  const double constant = std::cbrt(4 * M_PI / 6 / nu);
  TestGas<3> gas(Vector<3>::Constant(edge * constant));
  const auto velocities = thermal_velocities<3>(static_cast<std::size_t>(4 * edge * edge * edge), seed);
  for (int x = 0; x < edge; ++x)
    for (int y = 0; y < edge; ++y)
      for (int z = 0; z < edge; ++z)
        for (const Vector<3>& base :
             {Vector<3>(0, 0, 0), Vector<3>(.5, .5, 0), Vector<3>(.5, 0, .5), Vector<3>(0, .5, .5)})
          gas.add((Vector<3>(x, y, z) + base) * constant, velocities[gas.particles.phases.size()]);
  return gas;
}

/// Keeps events.
template <int D>
struct Recorder final : EventSink<D> {
  std::vector<Event<D>> events;
  void record(const Event<D>& event) override { events.push_back(event); }
};

/// Phases in the order of identities.
template <int D>
std::vector<Phase<D>> by_id(Simulator<D>& gas) {
  const auto phases = gas.view().particles;
  std::vector<Phase<D>> sorted(phases.size());
  for (std::size_t i = 0; i < phases.size(); ++i) sorted[gas.ids()[i]] = phases[i];
  return sorted;
}

/// What a restart gets of a simulation beside its memory.
template <int D>
Particles<D> particles_of(Simulator<D>& gas) {
  const View<D> view = gas.view();
  Particles<D> particles{{view.particles.begin(), view.particles.end()}, {}};
  for (const ColumnView& column : view.columns) particles.columns.set(column);
  return particles;
}

/// Sum of m v^2 / 2 for particles of mass 1.
template <int D>
double kinetic_energy(Simulator<D>& gas) {
  double sum = 0;
  for (const Phase<D>& phase : gas.view().particles) sum += phase.velocity.squaredNorm() / 2;
  return sum;
}
template <int D>
Vector<D> momentum(Simulator<D>& gas) {
  Vector<D> sum = Vector<D>::Zero();
  for (const Phase<D>& phase : gas.view().particles) sum += phase.velocity;
  return sum;
}

/// Smallest distance of two particles less their contact distance, by every pair and image.
template <int D>
double smallest_gap(Simulator<D>& gas, const Geometry<D>& geometry) {
  const auto particles = gas.view().particles;
  double smallest = HUGE_VAL;
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Vector<D> r = particles[i].position - particles[j].position;
      for (int axis = 0; axis < D; ++axis)
        if (geometry.periodic[static_cast<std::size_t>(axis)])
          r[axis] -= geometry.box[axis] * std::nearbyint(r[axis] / geometry.box[axis]);
      smallest = std::min(smallest, r.norm() - 1);
    }
  return smallest;
}

}  // namespace sandglass::event_driven
