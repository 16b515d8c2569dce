#pragma once

#include "sim/base/random.hpp"
#include "sim/space/neighbours.hpp"
#include "sim/space/particle_store.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace sandglass::dsmc {

/// Which fields a stage reads.
struct CellNeeds {
  bool density = false, velocity = false, energy = false;
  std::span<const std::uint8_t> where = {};  ///< by cell, not zero where it reads them; empty: everywhere
};

/// Numbers per cell, those that the coming stage needs; the others are empty, and without meaning in cells where it does
/// not read them. A stage may write to them, and keeps columns of its own in itself.
template <int D>
struct CellFields {
  std::vector<double> density;      ///< simulated particles per area or volume
  std::vector<Vector<D>> velocity;  ///< mean of the cell; zero where it is empty
  std::vector<double> energy;       ///< sum of |v|^2/2 over the particles

  void update(const CellNeeds& needs, const ParticleStore<D>& store);
};

template <int D>
struct CellStep {
  StreamKey key;  ///< of the step; index streams by cell
  std::uint64_t number;
  double dt;
  ParticleStore<D>& store;
  CellFields<D>& fields;
  const Neighbours<D>& neighbours;
};

/// A part of the step that works on whole cells and sees their neighbours; called before the collisions, with the
/// particles sorted by cell. It may change velocities, and positions within a cell.
template <int D>
class CellStage {
 public:
  virtual ~CellStage() = default;
  /// Asked before apply() in every step.
  virtual CellNeeds needs(const CellStep<D>&) { return {}; }
  virtual void apply(const CellStep<D>& step) = 0;
};

/// The stages of a simulation in their order, with the fields that they need.
template <int D>
class CellStages {
 public:
  CellStages(const LatticeOfCells<D>& cells, const std::array<bool, D>& periodic)
      : neighbours_(cells, periodic) {}

  void add(std::unique_ptr<CellStage<D>> stage) { stages_.push_back(std::move(stage)); }
  /// `number` is that of the step.
  void apply(ParticleStore<D>& store, const StreamKey& key, std::uint64_t number, double dt) {
    const CellStep<D> step{key, number, dt, store, fields_, neighbours_};
    for (const auto& stage : stages_) {
      fields_.update(stage->needs(step), store);
      stage->apply(step);
      store.velocities_changed();
    }
  }
  std::size_t bytes() const {
    return fields_.density.capacity() * sizeof(double) + fields_.velocity.capacity() * sizeof(Vector<D>) +
           fields_.energy.capacity() * sizeof(double);
  }

 private:
  Neighbours<D> neighbours_;
  CellFields<D> fields_;
  std::vector<std::unique_ptr<CellStage<D>>> stages_;
};

extern template struct CellFields<2>;
extern template struct CellFields<3>;

}  // namespace sandglass::dsmc
