#include "sim/method/dsmc/expected_pairs.hpp"

#include "sim/method/dsmc/local_factor.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::dsmc {

namespace {
/// Below what one pair counts, whatever the volume of its cell; sums that are not of whole numbers leave a rest.
constexpr double kOnePair = 0.5;
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

template <int D>
double ExpectedPairs<D>::factor(std::uint32_t cell, double contact) const {
  const double pairs = pairs_.sum(cell), per_cell = particles_.sum(cell) / particles_.cells(cell);
  if (pairs < kOnePair) return 1;
  const double expected = faults_.expected_pairs * per_cell * (particles_.sum(cell) - 1);
  const double weight =
      faults_.speeds_forgotten ? 1 : weight_of_missing_pairs(path_of_one_ / (per_cell * contact));
  return std::max(0.0, 1 + weight * (expected / pairs - 1));
}

template class ExpectedPairs<2>;
template class ExpectedPairs<3>;

}  // namespace sandglass::dsmc
