#include "sim/method/dsmc/mixture_factor.hpp"

#include "sim/method/dsmc/local_factor.hpp"

#include <algorithm>

namespace sandglass::dsmc {

template <int D>
MixtureContactFactor<D>::MixtureContactFactor(const Parameters& parameters, const LatticeOfCells<D>& cells,
                                              const std::array<bool, D>& periodic, double particles)
    : dense_(parameters.factor.formula != nullptr),
      dimension_(parameters.factor.dimension),
      smoothed_(parameters.factor.smoothed),
      of_largest_(parameters.faults.contact_of_largest),
      fewest_(parameters.partners == Partners::contact ? 0 : 2),
      densest_(densest_fraction(D)),
      largest_(cells.size()) {
  const int half_width = smoothed_ ? static_cast<int>(window_cells(parameters, cells, particles) / 2) : 0;
  for (const SpeciesTraits& kind : parameters.kinds.species) {
    diameters_.push_back(kind.diameter);
    crowding_.push_back(crowding_of(D, kind.diameter) * (parameters.weight / cells.grid().cell_volume()));
    windows_.emplace_back(cells, periodic, half_width);
  }
  if (parameters.pair_count == PairCount::expected) expected_.emplace(parameters, cells, periodic, particles);
  shares_.assign(cells.size() * diameters_.size() * diameters_.size(), 1);
}

template <int D>
void MixtureContactFactor<D>::set_volumes(std::span<const double> volumes) {
  for (WindowSum<D>& window : windows_) window.set_volumes(volumes);
  if (expected_) expected_->set_volumes(volumes);
}

template <int D>
void MixtureContactFactor<D>::update(std::span<const std::uint32_t> offsets, const SharedCells& work,
                                     const std::uint8_t* species) {
  count(offsets, work, species);
  if (expected_) expected_->update(offsets, work, species);
  for (std::uint32_t cell = work.first(); cell < work.last(); ++cell)
    if (offsets[cell + 1] - offsets[cell] >= fewest_) update_cell(cell);
}

template <int D>
void MixtureContactFactor<D>::count(std::span<const std::uint32_t> offsets, const SharedCells& work,
                                    const std::uint8_t* species) {
  for (WindowSum<D>& window : windows_) std::ranges::fill(window.values(), 0.0f);
  for (std::uint32_t cell = work.first(); cell < work.last(); ++cell)
    for (std::uint32_t i = offsets[cell]; i < offsets[cell + 1]; ++i)
      windows_[species[i]].values()[cell] += 1;
  for (WindowSum<D>& window : windows_) {
    work.complete(window.values());
    window.sum();
  }
}

template <int D>
void MixtureContactFactor<D>::update_cell(std::uint32_t cell) {
  const std::size_t species = diameters_.size();
  double* shares = &shares_[cell * species * species];
  double largest = 0;
  for (std::size_t a = 0; a < species; ++a)
    for (std::size_t b = 0; b <= a; ++b) {
      const double value = of_pair(cell, a, b);
      shares[a * species + b] = shares[b * species + a] = value;
      largest = std::max(largest, value);
    }
  largest_[cell] = largest;
  for (std::size_t i = 0; i < species * species; ++i)
    shares[i] = of_largest_ || largest == 0 ? 1 : shares[i] / largest;
}

template <int D>
double MixtureContactFactor<D>::of_pair(std::uint32_t cell, std::size_t first, std::size_t second) const {
  const double value = dense_ ? contact(cell, first, second) : 1;
  return expected_ ? value * expected_->factor(cell, first, second, value) : value;
}

/// Smoothed: without the pair itself, and less what the scatter of Poisson counts adds to a convex function.
template <int D>
double MixtureContactFactor<D>::contact(std::uint32_t cell, std::size_t first, std::size_t second) const {
  const double cells = windows_.front().cells(cell);
  const auto others = [&](std::size_t kind) {
    const double taken = smoothed_ ? (kind == first) + (kind == second) : 0;
    return std::max(0.0, windows_[kind].sum(cell) - taken);
  };
  Crowding all;
  for (std::size_t kind = 0; kind < crowding_.size(); ++kind)
    all = all + crowding_[kind] * (others(kind) / cells);
  if (all.fraction > densest_) all = all * (densest_ / all.fraction);
  const MixtureContactValue contact(dimension_, all, diameters_[first], diameters_[second]);
  double value = contact.value();
  if (smoothed_)
    for (std::size_t kind = 0; kind < crowding_.size(); ++kind)
      value -= 0.5 * others(kind) * contact.second_derivative(crowding_[kind] * (1 / cells));
  return std::max(0.0, value);
}

template <int D>
std::size_t MixtureContactFactor<D>::bytes() const {
  std::size_t windows = 0;
  for (const WindowSum<D>& window : windows_) windows += window.bytes();
  return windows + (expected_ ? expected_->bytes() : 0) +
         (largest_.capacity() + shares_.capacity()) * sizeof(double);
}

template class MixtureContactFactor<2>;
template class MixtureContactFactor<3>;

}  // namespace sandglass::dsmc
