#include "sim/observe/wall_impulses.hpp"

#include <stdexcept>

namespace sandglass {

template <int D>
Vector<D> WallImpulses<D>::impulse(std::size_t side) const {
  Vector<D> total;
  for (int axis = 0; axis < D; ++axis) total[axis] = sums_[side][static_cast<std::size_t>(axis)].value();
  return total;
}

template <int D>
void WallImpulses<D>::add(const WallImpulses& other) {
  for (std::size_t side = 0; side < sums_.size(); ++side)
    for (std::size_t i = 0; i < sums_[side].size(); ++i) sums_[side][i].add(other.sums_[side][i]);
}

template <int D>
std::vector<double> WallImpulses<D>::save() const {
  std::vector<double> state;
  for (const auto& side : sums_)
    for (const ExactSum& sum : side) {
      const std::vector<double> numbers = sum.save();
      state.insert(state.end(), numbers.begin(), numbers.end());
    }
  return state;
}

template <int D>
void WallImpulses<D>::load(const std::vector<double>& state) {
  const std::size_t size = ExactSum().save().size();
  if (state.size() != size * 2 * D * (D + 2)) throw std::out_of_range("wall impulses");
  auto from = state.begin();
  for (auto& side : sums_)
    for (ExactSum& sum : side) {
      sum = ExactSum::load({from, from + static_cast<long>(size)});
      from += static_cast<long>(size);
    }
}

template class WallImpulses<2>;
template class WallImpulses<3>;

}  // namespace sandglass
