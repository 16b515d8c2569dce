#include "sim/method/dsmc/pair_factor.hpp"

namespace sandglass::dsmc {

template <int D>
PairFactor<D>::PairFactor(const Parameters& parameters, const LatticeOfCells<D>& cells,
                          const std::array<bool, D>& periodic, double particles)
    : volumes_(cells.volumes()) {
  if (parameters.kinds.mixed()) {
    if (has_factors_of_species(parameters)) mixture_.emplace(parameters, cells, periodic, particles);
  } else {
    if (parameters.factor.formula != nullptr) contact_.emplace(parameters, cells, periodic, particles);
    if (parameters.pair_count == PairCount::expected)
      expected_.emplace(parameters, cells, periodic, particles);
  }
  if (expected_ || !volumes_.empty()) product_.resize(cells.size());
}

template <int D>
void PairFactor<D>::update_volumes() {
  if (contact_) contact_->set_volumes(volumes_);
  if (mixture_) mixture_->set_volumes(volumes_);
  if (expected_) expected_->set_volumes(volumes_);
}

template <int D>
void PairFactor<D>::update(std::span<const std::uint32_t> offsets, const SharedCells& work,
                           const std::uint8_t* full, const std::uint8_t* species) {
  if (contact_) contact_->update(offsets, work, full);
  if (mixture_) mixture_->update(offsets, work, species);
  if (expected_) expected_->update(offsets, work);
  if (product_.empty()) return;
  for (std::uint32_t cell = work.first(); cell < work.last(); ++cell) {
    const double contact = this->contact() != nullptr ? this->contact()[cell] : 1;
    product_[cell] = expected_ ? contact * expected_->factor(cell, contact) : contact;
    if (!volumes_.empty()) product_[cell] /= volumes_[cell];
  }
}

template <int D>
std::size_t PairFactor<D>::bytes() const {
  return (contact_ ? contact_->bytes() : 0) + (mixture_ ? mixture_->bytes() : 0) +
         (expected_ ? expected_->bytes() : 0) + product_.capacity() * sizeof(double);
}

template class PairFactor<2>;
template class PairFactor<3>;

}  // namespace sandglass::dsmc
