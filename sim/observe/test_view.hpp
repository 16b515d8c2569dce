#pragma once

#include "sim/observe/view.hpp"

#include <vector>

namespace sandglass {

/// A tiny system for tests of observers: cells given as lists of particles.
template <int D>
struct TestSystem {
  std::vector<Phase<D>> particles;
  std::vector<std::uint32_t> offsets{0};
  Tally tally;
  std::vector<Plane> planes;
  Vector<D> box = Vector<D>::Constant(4);
  double mass = 2, weight = 3, time = 0;

  void add_cell(const std::vector<Phase<D>>& members) {
    particles.insert(particles.end(), members.begin(), members.end());
    offsets.push_back(static_cast<std::uint32_t>(particles.size()));
  }
  View<D> view() {
    View<D> view;
    view.particles = particles;
    view.offsets = offsets;
    view.box = box;
    view.mass = mass;
    view.weight = weight;
    view.time = time;
    view.tally = &tally;
    view.planes = &planes;
    return view;
  }
};

}  // namespace sandglass
