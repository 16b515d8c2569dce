#include "sim/method/dsmc/pair_factor.hpp"

namespace sandglass::dsmc {

template <int D>
PairFactor<D>::PairFactor(const Parameters& parameters, const Grid<D>& grid,
                          const std::array<bool, D>& periodic, double particles) {
  if (parameters.factor.formula != nullptr) contact_.emplace(parameters, grid, periodic, particles);
  if (parameters.pair_count == PairCount::counted) return;
  expected_.emplace(parameters, grid, periodic, particles);
  product_.resize(grid.size());
}

template <int D>
void PairFactor<D>::update(std::span<const std::uint32_t> offsets, const std::uint8_t* full) {
  if (contact_) contact_->update(offsets, full);
  if (!expected_) return;
  expected_->update(offsets);
  for (std::uint32_t cell = 0; cell < product_.size(); ++cell) {
    const double contact = contact_ ? contact_->values()[cell] : 1;
    product_[cell] = contact * expected_->factor(cell, contact);
  }
}

template <int D>
std::size_t PairFactor<D>::bytes() const {
  return (contact_ ? contact_->bytes() : 0) + (expected_ ? expected_->bytes() : 0) +
         product_.capacity() * sizeof(double);
}

template class PairFactor<2>;
template class PairFactor<3>;

}  // namespace sandglass::dsmc
