#include "sim/method/dsmc/dsmc.hpp"

namespace sandglass::dsmc {

namespace {
/// Particles that are collided and then moved while the first cache still holds them.
constexpr std::uint32_t kBlock = 512;

template <int D>
std::array<bool, D> periodic_axes(const MotionParameters<D>& motion) {
  std::array<bool, D> periodic{};
  for (std::size_t axis = 0; axis < D; ++axis) periodic[axis] = !motion.walled[axis];
  return periodic;
}
}  // namespace

template <int D>
Dsmc<D>::Dsmc(const Grid<D>& grid, const Parameters& parameters, const MotionParameters<D>& motion,
              const Streams& streams, Purpose purpose, bool keep_ids)
    : parameters_(parameters),
      streams_(streams),
      purpose_(purpose),
      motion_parameters_(motion),
      store_(grid, keep_ids),
      collisions_(parameters.faults.any() ? make_faulty_collision_stage<D>(parameters)
                                          : make_collision_stage<D>(parameters)),
      motion_(make_motion_stage<D>(motion)) {}

template <int D>
void Dsmc<D>::assign(const Particles<D>& particles) {
  store_.assign(particles.phases, particles.ids);
  if (parameters_.factor.formula != nullptr)
    factor_.emplace(parameters_, store_.grid(), periodic_axes(motion_parameters_),
                    static_cast<double>(particles.phases.size()));
}

template <int D>
void Dsmc<D>::step(double dt, std::uint64_t step) {
  const StreamKey key(streams_.seed, purpose_, streams_.replica, step);
  if (factor_) factor_->update(store_.offsets());
  const double coefficient =
      parameters_.weight * parameters_.cross_section * dt / (2 * store_.grid().cell_volume());
  collide_and_move(dt, {key, coefficient, factor_ ? factor_->values() : nullptr, store_.phases().data(),
                        store_.offsets().data(), &tally_, &bound_raised_});
  store_.sort();
  tally_.moves += store_.size();
}

template <int D>
void Dsmc<D>::collide_and_move(double dt, const CollisionStep<D>& collisions) {
  const auto offsets = store_.offsets();
  const auto cells = static_cast<std::uint32_t>(offsets.size() - 1);
  store_.begin_step();
  for (std::uint32_t first = 0; first < cells;) {
    std::uint32_t last = first + 1;
    while (last < cells && offsets[last] - offsets[first] < kBlock) ++last;
    collisions_->collide(collisions, first, last);
    motion_->advance(store_, offsets[first], offsets[last], dt);
    first = last;
  }
}

template <int D>
View<D> Dsmc<D>::view() {
  View<D> view;
  view.particles = store_.phases();
  view.offsets = store_.offsets();
  view.box = store_.grid().box();
  view.mass = parameters_.mass;
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
  return {{"dsmc/bound-raised", {static_cast<double>(bound_raised_)}}};
}

template <int D>
void Dsmc<D>::load(const Memory& memory) {
  bound_raised_ = static_cast<std::uint64_t>(memory.at("dsmc/bound-raised").at(0));
}

template <int D>
std::size_t Dsmc<D>::bytes() const {
  return store_.bytes() + (factor_ ? factor_->bytes() : 0);
}

template class Dsmc<2>;
template class Dsmc<3>;

}  // namespace sandglass::dsmc
