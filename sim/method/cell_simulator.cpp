#include "sim/method/cell_simulator.hpp"

namespace sandglass {

template <int D>
CellSimulator<D>::CellSimulator(const LatticeOfCells<D>& cells, const SpeciesTraits& traits, double weight,
                                const motion::MotionParameters<D>& motion, const Streams& streams,
                                const std::vector<ColumnInfo>& columns)
    : streams_(streams),
      store_(cells, columns),
      traits_(traits),
      weight_(weight),
      motion_parameters_(motion),
      motion_(motion::make_motion_stage<D>(motion, cells.grid().box())) {}

template <int D>
void CellSimulator<D>::assign(const Particles<D>& particles) {
  store_.assign(particles);
  time_ = 0;
}

template <int D>
View<D> CellSimulator<D>::view() {
  View<D> view;
  view.particles = store_.phases();
  view.offsets = store_.offsets();
  view.box = store_.grid().box();
  view.columns = store_.columns();
  view.traits = {&traits_, 1};
  view.weight = weight_;
  view.tally = &tally_;
  view.planes = motion_parameters_.planes;
  return view;
}

template <int D>
void CellSimulator<D>::insert(const Particles<D>& particles) {
  store_.insert(particles);
  store_.stay();
  store_.sort();
}

template <int D>
void CellSimulator<D>::remove(std::span<const std::uint32_t> places) {
  store_.stay(places);
  store_.sort();
}

template <int D>
void CellSimulator<D>::end_step(double dt) {
  time_ += dt;
  tally_.moves += store_.size();
  store_.sort();
}

template <int D>
std::array<bool, D> CellSimulator<D>::periodic() const {
  std::array<bool, D> periodic{};
  for (std::size_t axis = 0; axis < D; ++axis) periodic[axis] = !motion_parameters_.walled[axis];
  return periodic;
}

template <int D>
Memory CellSimulator<D>::save() const {
  Memory memory{{"cells/next-id", {static_cast<double>(store_.next_id())}}};
  if (motion_parameters_.walls_move()) memory["motion/time"] = {time_};
  return memory;
}

template <int D>
void CellSimulator<D>::load(const Memory& memory) {
  store_.set_next_id(static_cast<std::uint64_t>(memory.at("cells/next-id").at(0)));
  if (motion_parameters_.walls_move()) time_ = memory.at("motion/time").at(0);
}

template class CellSimulator<2>;
template class CellSimulator<3>;

}  // namespace sandglass
