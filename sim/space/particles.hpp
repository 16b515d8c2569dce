#pragma once

#include "sim/base/columns.hpp"
#include "sim/base/particle_columns.hpp"
#include "sim/space/phase.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace sandglass {

/// Particles outside a method: what it starts from, or what it is to add. Columns hold one value per particle each.
template <int D>
struct Particles {
  std::vector<Phase<D>> phases;
  Columns columns;
};

/// Copies of the particles at these places, in their order; a place may come several times. `columns`: of ColumnView.
template <int D, class List>
Particles<D> pick(std::span<const Phase<D>> phases, const List& columns,
                  std::span<const std::uint32_t> places) {
  Particles<D> picked;
  picked.phases.reserve(places.size());
  for (const std::uint32_t place : places) picked.phases.push_back(phases[place]);
  for (const ColumnView& column : columns) picked.columns.set(pick(column, places));
  return picked;
}

/// The same out of particles outside a method.
template <int D>
Particles<D> pick(const Particles<D>& particles, std::span<const std::uint32_t> places) {
  ColumnViews columns;
  for (const NamedColumn& column : particles.columns.all()) columns.add(column.view());
  return pick<D>(particles.phases, columns, places);
}

/// Where and when a particle comes in during a step.
struct Arrival {
  int axis = 0;
  bool high = false;
  double left = 0;  ///< of the step, from then on
};

/// Particles that come in during a step, each as it stands and moves on its way through the side.
template <int D>
struct Entrants {
  Particles<D> particles;
  std::vector<Arrival> arrivals;  ///< of each
};

}  // namespace sandglass
