#pragma once

#include "sim/method/event_driven/cells.hpp"
#include "sim/method/event_driven/particle_state.hpp"
#include "sim/observe/view.hpp"
#include "sim/space/flight.hpp"

namespace sandglass::event_driven {

/// All particles brought to the same moment, for observers. Particles themselves stay where they are.
template <int D>
class Present {
 public:
  /// `state` gives a particle as it is now.
  template <class Read>
  void take(std::uint32_t size, const Geometry<D>& geometry, Read state) {
    box_ = geometry.box;
    phases_.resize(size);
    for (std::uint32_t i = 0; i < size; ++i) {
      const ParticleState<D> now = state(i);
      phases_[i] = {now.position, now.velocity};
      for (int axis = 0; axis < D; ++axis)
        if (geometry.periodic[static_cast<std::size_t>(axis)])
          phases_[i].position[axis] = wrap(now.position[axis], box_[axis], 1 / box_[axis]);
    }
    blocks_.clear();
    for (std::uint32_t i = 0; i < size; i += kBlock) blocks_.push_back(i);
    blocks_.push_back(size);
  }
  View<D> view() const {
    View<D> view;
    view.particles = phases_;
    view.offsets = blocks_;
    view.box = box_;
    return view;
  }
  std::size_t bytes() const {
    return phases_.capacity() * sizeof(Phase<D>) + blocks_.capacity() * sizeof(std::uint32_t);
  }

 private:
  static constexpr std::uint32_t kBlock = 1024;  ///< particles whose sums are plain

  Vector<D> box_ = Vector<D>::Ones();
  std::vector<Phase<D>> phases_;
  std::vector<std::uint32_t> blocks_;
};

}  // namespace sandglass::event_driven
