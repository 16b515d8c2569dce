#include "sim/method/cell_simulator.hpp"

#include "sim/base/saved.hpp"
#include "sim/observe/axes.hpp"

namespace sandglass {

template <int D>
CellSimulator<D>::CellSimulator(const LatticeOfCells<D>& cells, std::vector<SpeciesTraits> traits,
                                double weight, const motion::MotionParameters<D>& motion,
                                const Streams& streams, const std::vector<ColumnInfo>& columns)
    : streams_(streams),
      store_(cells, columns),
      all_cells_(cells.size()),
      columns_(columns),
      traits_(std::move(traits)),
      weight_(weight),
      motion_parameters_(motion),
      motion_(motion::make_motion_stage<D>(motion, cells.grid().box())) {}

template <int D>
void CellSimulator<D>::share(Communicator& ranks) {
  SANDGLASS_EXPECT(!cloner_);  // copies would need ids that no other rank gives
  shared_ = std::make_unique<SharedStore<D>>(store_, columns_, ranks);
}

template <int D>
void CellSimulator<D>::assign(const Particles<D>& particles) {
  store_.assign(particles);
  time_ = 0;
  left_ = {};
  gathered_ = nullptr;
  if (shared_) shared_->keep_own();
}

template <int D>
View<D> CellSimulator<D>::view() {
  View<D> view = view_of(store_);
  if (shared_) view.ranks = &work().ranks();
  return view;
}

template <int D>
View<D> CellSimulator<D>::view_of_all() {
  if (!shared_) return view();
  gather_counts();
  if (gathered_ == nullptr) gathered_ = &shared_->gather();
  return view_of(*gathered_);
}

template <int D>
View<D> CellSimulator<D>::view_of(const ParticleStore<D>& store) {
  View<D> view;
  view.particles = store.phases();
  view.offsets = store.offsets();
  view.box = store.grid().box();
  view.columns = store.columns();
  view.traits = traits_;
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

/// They wait for the sort at the end of the step.
template <int D>
void CellSimulator<D>::enter(const Entrants<D>& entrants, double dt, std::uint64_t step) {
  if (!entrance_) entrance_ = std::make_unique<motion::Entrance<D>>(motion_parameters_, store_.grid().box());
  motion::Arrived<D> arrived = entrance_->fly(entrants, motion_step(dt, step));
  for (const Vector<D>& position : arrived.left) count_one_who_leaves(position);
  if (cloner_) cloner_->apply(arrived.particles, store_, traits_, cloning_key(step));
  store_.insert(arrived.particles);
}

template <int D>
void CellSimulator<D>::remove(std::span<const std::uint32_t> places) {
  store_.stay(places);
  store_.sort();
}

template <int D>
void CellSimulator<D>::end_step(double dt, std::uint64_t step) {
  time_ += dt;
  tally_.moves += store_.size();
  if (store_.arrivals()[store_.removed()] > 0) count_those_who_leave();
  if (cloner_) cloner_->apply(store_, traits_, cloning_key(step));
  gathered_ = nullptr;
  shared_ ? shared_->sort() : store_.sort();
}

/// The flight has left them outside the box, and the sort is about to drop them.
template <int D>
void CellSimulator<D>::count_those_who_leave() {
  const auto particles = store_.phases();
  const auto* places = store_.places();
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (places[i].cell == store_.removed()) count_one_who_leaves(particles[i].position);
}

/// Once, where an offset has put it beyond a corner.
template <int D>
void CellSimulator<D>::count_one_who_leaves(const Vector<D>& position) {
  for (int axis = 0; axis < D; ++axis)
    for (const bool high : {false, true}) {
      const auto index = static_cast<std::size_t>(axis);
      const bool beyond = high ? position[axis] > store_.grid().box()[axis] : position[axis] < 0;
      if (motion_parameters_.open[index][high] && beyond) {
        ++left_[index][high];
        return;
      }
    }
}

template <int D>
std::map<std::string, double> CellSimulator<D>::counters() const {
  std::map<std::string, double> counters = cloner_ ? cloner_->counters() : std::map<std::string, double>{};
  for (std::size_t axis = 0; axis < D; ++axis)
    for (const bool high : {false, true}) {
      if (!motion_parameters_.open[axis][high]) continue;
      const auto left = static_cast<double>(left_[axis][high]);
      counters["particles-left"] += left;
      counters["particles-left-" + side_name(static_cast<int>(axis), high)] = left;
    }
  return counters;
}

template <int D>
std::array<bool, D> CellSimulator<D>::periodic() const {
  std::array<bool, D> periodic{};
  for (std::size_t axis = 0; axis < D; ++axis) periodic[axis] = !motion_parameters_.walled[axis];
  return periodic;
}

template <int D>
std::vector<std::uint64_t*> CellSimulator<D>::counts() {
  std::vector<std::uint64_t*> counts;
  for (auto& sides : left_)
    for (std::uint64_t& count : sides) counts.push_back(&count);
  return counts;
}

template <int D>
void CellSimulator<D>::gather_counts() {
  if (shared_) all_counts().gather(work().ranks());
}

template <int D>
void CellSimulator<D>::clear_counts() {
  all_counts().clear();
}

template <int D>
Memory CellSimulator<D>::save() const {
  Memory memory{{"cells/next-id", {static_cast<double>(store_.next_id())}}};
  if (cloner_) memory["cloning"] = cloner_->save();
  if (motion_parameters_.walls_move()) memory["motion/time"] = {time_};
  if (motion_parameters_.has_open_side())
    for (const auto& sides : left_)
      for (const std::uint64_t count : sides) memory["motion/left"].push_back(static_cast<double>(count));
  return memory;
}

template <int D>
void CellSimulator<D>::load(const Memory& memory) {
  store_.set_next_id(saved_count(memory.at("cells/next-id").at(0)));
  if (cloner_) cloner_->load(memory.at("cloning"));
  if (motion_parameters_.walls_move())
    time_ = saved_number(memory.at("motion/time").at(0), 0, 1e300, "the time");
  if (!motion_parameters_.has_open_side()) return;
  for (std::size_t i = 0; i < 2 * D; ++i) left_[i / 2][i % 2] = saved_count(memory.at("motion/left").at(i));
}

template class CellSimulator<2>;
template class CellSimulator<3>;

}  // namespace sandglass
