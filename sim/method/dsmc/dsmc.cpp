#include "sim/method/dsmc/dsmc.hpp"

namespace sandglass::dsmc {

namespace {
/// Particles that are collided and then moved while the first cache still holds them.
constexpr std::uint32_t kBlock = 512;

template <int D>
std::array<bool, D> periodic_axes(const motion::MotionParameters<D>& motion) {
  std::array<bool, D> periodic{};
  for (std::size_t axis = 0; axis < D; ++axis) periodic[axis] = !motion.walled[axis];
  return periodic;
}
}  // namespace

template <int D>
Dsmc<D>::Dsmc(const Grid<D>& grid, const Parameters& parameters, const motion::MotionParameters<D>& motion,
              const Streams& streams, Purpose purpose, const std::vector<ColumnInfo>& columns)
    : parameters_(parameters),
      traits_{parameters.diameter, parameters.mass},
      streams_(streams),
      purpose_(purpose),
      motion_parameters_(motion),
      store_(grid, columns),
      collisions_(parameters.faults.any() ? make_faulty_collision_stage<D>(parameters)
                                          : make_collision_stage<D>(parameters)),
      motion_(motion::make_motion_stage<D>(motion, grid.box())),
      stages_(grid, periodic_axes(motion)) {}

template <int D>
void Dsmc<D>::assign(const Particles<D>& particles) {
  store_.assign(particles);
  time_ = 0;
  make_factor(static_cast<double>(particles.phases.size()));
}

template <int D>
void Dsmc<D>::make_factor(double particles) {
  assigned_ = particles;
  if (PairFactor<D>::needed(parameters_))
    factor_.emplace(parameters_, store_.grid(), periodic_axes(motion_parameters_), particles);
}

template <int D>
void Dsmc<D>::insert(const Particles<D>& particles) {
  store_.insert(particles);
  store_.stay();
  store_.sort();
}

template <int D>
void Dsmc<D>::remove(std::span<const std::uint32_t> places) {
  store_.stay(places);
  store_.sort();
}

template <int D>
void Dsmc<D>::step(double dt, std::uint64_t step) {
  const StreamKey key(streams_.seed, purpose_, streams_.replica, step);
  stages_.apply(store_, key, dt);
  if (factor_) factor_->update(store_.offsets());
  collide_and_move({dt, time_, StreamKey(streams_.seed, Purpose::walls, streams_.replica, step)},
                   collision_step(dt, key));
  time_ += dt;
  tally_.moves += store_.size();
  store_.sort();
}

template <int D>
CollisionStep<D> Dsmc<D>::collision_step(double dt, const StreamKey& key) {
  const double coefficient =
      parameters_.weight * parameters_.cross_section * dt / (2 * store_.grid().cell_volume());
  return {key,
          coefficient,
          factor_ ? factor_->values() : nullptr,
          store_.phases().data(),
          store_.offsets().data(),
          &tally_,
          &bound_raised_};
}

template <int D>
void Dsmc<D>::collide_and_move(const motion::MotionStep& motion, const CollisionStep<D>& collisions) {
  const auto offsets = store_.offsets();
  const auto cells = static_cast<std::uint32_t>(offsets.size() - 1);
  store_.begin_step();
  for (std::uint32_t first = 0; first < cells;) {
    std::uint32_t last = first + 1;
    while (last < cells && offsets[last] - offsets[first] < kBlock) ++last;
    collisions_->collide(collisions, first, last);
    motion_->advance(store_, offsets[first], offsets[last], motion);
    first = last;
  }
}

template <int D>
View<D> Dsmc<D>::view() {
  View<D> view;
  view.particles = store_.phases();
  view.offsets = store_.offsets();
  view.box = store_.grid().box();
  view.columns = store_.columns();
  view.traits = {&traits_, 1};
  view.weight = parameters_.weight;
  view.tally = &tally_;
  view.planes = motion_parameters_.planes;
  return view;
}

template <int D>
std::map<std::string, double> Dsmc<D>::counters() const {
  return {{"bound-raised", static_cast<double>(bound_raised_)}};
}

template <int D>
Memory Dsmc<D>::save() const {
  Memory memory{{"dsmc/bound-raised", {static_cast<double>(bound_raised_)}},
                {"dsmc/population", {assigned_, static_cast<double>(store_.next_id())}}};
  if (motion_parameters_.walls_move()) memory["motion/time"] = {time_};
  return memory;
}

template <int D>
void Dsmc<D>::load(const Memory& memory) {
  bound_raised_ = static_cast<std::uint64_t>(memory.at("dsmc/bound-raised").at(0));
  if (motion_parameters_.walls_move()) time_ = memory.at("motion/time").at(0);
  const std::vector<double>& population = memory.at("dsmc/population");
  if (population.at(0) != assigned_) make_factor(population.at(0));
  store_.set_next_id(static_cast<std::uint64_t>(population.at(1)));
}

template <int D>
std::size_t Dsmc<D>::bytes() const {
  return store_.bytes() + stages_.bytes() + (factor_ ? factor_->bytes() : 0);
}

template class Dsmc<2>;
template class Dsmc<3>;

}  // namespace sandglass::dsmc
