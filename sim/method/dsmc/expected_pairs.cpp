#include "sim/method/dsmc/expected_pairs.hpp"

#include "sim/method/dsmc/local_factor.hpp"
#include "sim/physics/collision.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::dsmc {

namespace {
/// Below what one pair counts, whatever the volume of its cell; sums that are not of whole numbers leave a rest.
constexpr double kOnePair = 0.5;
/// Fewer leave a window without any too often (e^-20).
constexpr double kFewPairs = 20;
}  // namespace

template <int D>
ExpectedPairs<D>::ExpectedPairs(const Parameters& parameters, const LatticeOfCells<D>& cells,
                                const std::array<bool, D>& periodic, double particles)
    : faults_(parameters.faults),
      path_of_one_(cells.grid().cell_volume() /
                   (M_SQRT2 * parameters.weight * parameters.cross_section * parameters.offset.length())),
      volumes_(cells.volumes()),
      particles_(cells, periodic, particles / cells.grid().size(), kLargeWindow),
      pairs_(cells, periodic, particles / cells.grid().size(), kLargeWindow) {}

template <int D>
void ExpectedPairs<D>::update(std::span<const std::uint32_t> offsets, const SharedCells& work) {
  particles_.update(offsets, work);
  const std::span<double> pairs = pairs_.values();
  for (std::uint32_t cell = work.first(); cell < work.last(); ++cell) {
    const double count = offsets[cell + 1] - offsets[cell];
    pairs[cell] = count * (count - 1);
    if (!volumes_.empty()) pairs[cell] /= volumes_[cell];
  }
  work.complete(pairs);
  pairs_.sum();
}

double factor_of_missing_pairs(double expected, double pairs, double path, const Faults& faults) {
  if (pairs < kOnePair) return 1;
  const double weight = faults.speeds_forgotten ? 1 : weight_of_missing_pairs(path);
  return std::max(0.0, 1 + weight * (faults.expected_pairs * expected / pairs - 1));
}

template <int D>
double ExpectedPairs<D>::factor(std::uint32_t cell, double contact) const {
  const double per_cell = particles_.sum(cell) / particles_.cells(cell);
  return factor_of_missing_pairs(per_cell * (particles_.sum(cell) - 1), pairs_.sum(cell),
                                 path_of_one_ / (per_cell * contact), faults_);
}

template <int D>
ExpectedPairsOfSpecies<D>::ExpectedPairsOfSpecies(const Parameters& parameters,
                                                  const LatticeOfCells<D>& cells,
                                                  const std::array<bool, D>& periodic, double particles)
    : faults_(parameters.faults),
      path_of_one_(
          cells.grid().cell_volume() /
          (M_SQRT2 * parameters.weight * cross_section(D, parameters.diameter) * parameters.offset.length())),
      volumes_(cells.volumes()) {
  const std::size_t species = parameters.kinds.species.size();
  const double per_cell = particles / cells.grid().size();
  particles_.assign(species, WindowSum<D>(cells, periodic, per_cell, kLargeWindow));
  pairs_.assign(species * (species + 1) / 2, WindowSum<D, double>(cells, periodic, per_cell, kLargeWindow));
}

template <int D>
void ExpectedPairsOfSpecies<D>::set_volumes(std::span<const double> volumes) {
  for (WindowSum<D>& window : particles_) window.set_volumes(volumes);
}

template <int D>
std::size_t ExpectedPairsOfSpecies<D>::index(std::size_t first, std::size_t second) const {
  const auto [low, high] = std::minmax(first, second);
  return high * (high + 1) / 2 + low;
}

template <int D>
void ExpectedPairsOfSpecies<D>::update(std::span<const std::uint32_t> offsets, const SharedCells& work,
                                       const std::uint8_t* species) {
  std::vector<std::uint32_t> held(particles_.size());
  for (std::uint32_t cell = work.first(); cell < work.last(); ++cell) {
    std::ranges::fill(held, 0u);
    for (std::uint32_t i = offsets[cell]; i < offsets[cell + 1]; ++i) ++held[species[i]];
    count(cell, held);
  }
  for (WindowSum<D>& window : particles_) {
    work.complete(window.values());
    window.sum();
  }
  for (WindowSum<D, double>& window : pairs_) {
    work.complete(window.values());
    window.sum();
  }
}

template <int D>
void ExpectedPairsOfSpecies<D>::count(std::uint32_t cell, const std::vector<std::uint32_t>& held) {
  for (std::size_t a = 0; a < held.size(); ++a) {
    particles_[a].values()[cell] = static_cast<float>(held[a]);
    for (std::size_t b = 0; b <= a; ++b) {
      double& pairs = pairs_[index(a, b)].values()[cell];
      pairs = static_cast<double>(held[a]) * (static_cast<double>(held[b]) - (a == b));
      if (!volumes_.empty()) pairs /= volumes_[cell];
    }
  }
}

template <int D>
typename ExpectedPairsOfSpecies<D>::Pairs ExpectedPairsOfSpecies<D>::of(std::uint32_t cell, std::size_t first,
                                                                        std::size_t second) const {
  const double per_cell = particles_[first].sum(cell) / particles_[first].cells(cell);
  return {per_cell * (particles_[second].sum(cell) - (first == second)),
          pairs_[index(first, second)].sum(cell)};
}

template <int D>
typename ExpectedPairsOfSpecies<D>::Pairs ExpectedPairsOfSpecies<D>::of_all(std::uint32_t cell) const {
  Pairs all;
  for (std::size_t a = 0; a < particles_.size(); ++a)
    for (std::size_t b = 0; b <= a; ++b) {
      const Pairs one = of(cell, a, b);
      const double orders = a == b ? 1 : 2;
      all.expected += orders * one.expected;
      all.counted += orders * one.counted;
    }
  return all;
}

template <int D>
double ExpectedPairsOfSpecies<D>::factor(std::uint32_t cell, std::size_t first, std::size_t second,
                                         double contact) const {
  Pairs pairs = of(cell, first, second);
  if (pairs.expected < kFewPairs) pairs = of_all(cell);
  double per_cell = 0;
  for (const WindowSum<D>& window : particles_) per_cell += window.sum(cell) / window.cells(cell);
  return factor_of_missing_pairs(pairs.expected, pairs.counted, path_of_one_ / (per_cell * contact), faults_);
}

template <int D>
std::size_t ExpectedPairsOfSpecies<D>::bytes() const {
  std::size_t all = 0;
  for (const WindowSum<D>& window : particles_) all += window.bytes();
  for (const WindowSum<D, double>& window : pairs_) all += window.bytes();
  return all;
}

template class ExpectedPairs<2>;
template class ExpectedPairs<3>;
template class ExpectedPairsOfSpecies<2>;
template class ExpectedPairsOfSpecies<3>;

}  // namespace sandglass::dsmc
