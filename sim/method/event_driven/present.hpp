#pragma once

#include "sim/method/event_driven/cells.hpp"
#include "sim/method/event_driven/gas.hpp"
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
  void take(const Gas<D>& gas, const Geometry<D>& geometry, Read state) {
    box_ = geometry.box;
    here_.clear();
    if (gas.gone > 0) take_columns(gas);
    const std::uint32_t size = gas.size() - gas.gone;
    phases_.resize(size);
    for (std::uint32_t i = 0; i < size; ++i) {
      const ParticleState<D> now = state(gas.gone > 0 ? here_[i] : i);
      phases_[i] = {now.position, now.velocity};
      for (int axis = 0; axis < D; ++axis)
        if (geometry.periodic[static_cast<std::size_t>(axis)])
          phases_[i].position[axis] = wrap(now.position[axis], box_[axis], 1 / box_[axis]);
    }
    blocks_.clear();
    for (std::uint32_t i = 0; i < size; i += kBlock) blocks_.push_back(i);
    blocks_.push_back(size);
  }
  // Columns of the gas, of those who are here.
  std::span<const std::uint64_t> ids(const Gas<D>& gas) const { return either(gas, gas.ids, ids_); }
  std::span<const Spin<D>> spins(const Gas<D>& gas) const { return either(gas, gas.spins, spins_); }
  std::span<const std::uint8_t> species(const Gas<D>& gas) const {
    return either(gas, gas.species, species_);
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

  template <class All, class T>
  static std::span<const T> either(const Gas<D>& gas, const All& all, const std::vector<T>& here) {
    if (gas.gone > 0) return here;
    return all;
  }
  template <class All, class T>
  void gather(const All& all, std::vector<T>& here) const {
    here.clear();
    if (all.empty()) return;
    for (const std::uint32_t place : here_) here.push_back(all[place]);
  }
  void take_columns(const Gas<D>& gas) {
    here_ = gas.places();
    gather(gas.ids, ids_);
    gather(gas.spins, spins_);
    gather(gas.species, species_);
  }

  Vector<D> box_ = Vector<D>::Ones();
  std::vector<Phase<D>> phases_;
  std::vector<std::uint32_t> blocks_;
  // Where somebody has left since the era began: places of the others, and their columns.
  std::vector<std::uint32_t> here_;
  std::vector<std::uint64_t> ids_;
  std::vector<Spin<D>> spins_;
  std::vector<std::uint8_t> species_;
};

}  // namespace sandglass::event_driven
