#include "sim/motion/refusable_motion.hpp"

namespace sandglass::motion {

template <int D>
void RefusableMotion<D>::advance(ParticleStore<D>& store, const MotionStep& step, EntryRule<D>& rule) {
  const std::size_t count = store.size();
  targets_.resize(count);
  arrived_.resize(count + 1);
  refused_.assign(count, 0);
  entering_.assign(store.cells().size() + 1, 0);
  stage_->propose(store, 0, count, step, targets_.data(), arrived_.data());
  count_entering(store.offsets());
  rule.decide(
      {store.cells(), store.offsets(), targets_, std::span(entering_).first(store.cells().size()), refused_});
  if (entering_.back() > 0) let_go(store.removed());
  stage_->advance_accepted(store, 0, count, step, refused_.data(), arrived_.data());
  take_places(store);
}

template <int D>
void RefusableMotion<D>::count_entering(std::span<const std::uint32_t> offsets) {
  for (std::uint32_t cell = 0; cell + 1 < offsets.size(); ++cell)
    for (std::uint32_t i = offsets[cell]; i < offsets[cell + 1]; ++i)
      entering_[targets_[i]] += targets_[i] != cell;
}

/// Whoever would leave the box may.
template <int D>
void RefusableMotion<D>::let_go(std::uint32_t removed) {
  for (std::size_t i = 0; i < targets_.size(); ++i)
    if (targets_[i] == removed) refused_[i] = false;
}

/// In the order (old cell, old place), whatever the order of the flights. Whom an offset has put out of its cell goes back
/// to the edge of the cell, for the offset is refused with the rest of the move.
template <int D>
void RefusableMotion<D>::take_places(ParticleStore<D>& store) const {
  const auto offsets = store.offsets();
  auto* places = store.places();
  std::uint32_t* arrivals = store.arrivals();
  store.begin_step();
  for (std::uint32_t cell = 0; cell + 1 < offsets.size(); ++cell)
    for (std::uint32_t i = offsets[cell]; i < offsets[cell + 1]; ++i) {
      const std::uint32_t to = refused_[i] ? cell : targets_[i];
      places[i] = {to, arrivals[to]++};
      if (refused_[i]) store.cells().put_into(cell, store.phases()[i].position);
    }
}

template class RefusableMotion<2>;
template class RefusableMotion<3>;

}  // namespace sandglass::motion
