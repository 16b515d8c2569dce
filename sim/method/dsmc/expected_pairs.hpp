#pragma once

#include "sim/method/dsmc/parameters.hpp"
#include "sim/space/window_sum.hpp"

#include <array>
#include <span>
#include <vector>

namespace sandglass::dsmc {

/// By how much a pair that an offset has taken out of its cell collides more often than an average pair: pairs are
/// missing because they collided, and the fast ones collide more. `path` is the mean free path over the length of the
/// offset. From 1, where pairs part by flying, to nearly 3 pi/32 more, where they part by offsets and all speeds stay as
/// long. Measured for disks and spheres at fractions 0.05 to 0.3, to 0.02.
inline double weight_of_missing_pairs(double path) {
  return 1 + 0.178 / (1 + 1.3 * path + 1.4 * path * path);
}

/// Factor that makes up for missing pairs: `expected` by chance over `pairs` counted, but for the speed of the missing ones.
/// `path` as of weight_of_missing_pairs().
double factor_of_missing_pairs(double expected, double pairs, double path, const Faults& faults);

/// Factor on the pairs of each cell that makes up for those which an offset has taken out of it.
///
/// In a window of M cells that together hold N particles, chance would put N (N - 1)/M ordered pairs into its cells. This
/// number over the pairs counted there is the factor, but for the speed of the missing pairs. Given N, chance makes all
/// cells of a window alike, so that the mean of pairs times factor is N (N - 1)/M^2 exactly, however few particles a cell
/// holds: cells with fewer than two have no pair, and the others of the window make up for them. Where cells differ, the
/// pairs of each are divided by its volume, and M is the volume of the window.
template <int D>
class ExpectedPairs {
 public:
  /// Goes on to read the volumes of `cells`, which may change.
  ExpectedPairs(const Parameters& parameters, const LatticeOfCells<D>& cells,
                const std::array<bool, D>& periodic, double particles);

  /// As WindowSum::set_volumes.
  void set_volumes(std::span<const double> volumes) { particles_.set_volumes(volumes); }
  /// `offsets` as of ParticleStore.
  void update(std::span<const std::uint32_t> offsets, const SharedCells& work);
  /// `contact` is the contact factor of the cell, one without.
  double factor(std::uint32_t cell, double contact) const;
  std::size_t bytes() const { return particles_.bytes() + pairs_.bytes(); }

 private:
  Faults faults_;
  double path_of_one_;               ///< mean free path, in offsets, where a cell holds one particle
  std::span<const double> volumes_;  ///< as of LatticeOfCells
  WindowSum<D> particles_;
  WindowSum<D, double> pairs_;
};

/// The same for each pair of species. Of species so rare that chance would put but a few of their pairs into a window,
/// all pairs together say how many are missing.
template <int D>
class ExpectedPairsOfSpecies {
 public:
  ExpectedPairsOfSpecies(const Parameters& parameters, const LatticeOfCells<D>& cells,
                         const std::array<bool, D>& periodic, double particles);

  void set_volumes(std::span<const double> volumes);
  void update(std::span<const std::uint32_t> offsets, const SharedCells& work, const std::uint8_t* species);
  /// `contact` is the contact factor of the pair.
  double factor(std::uint32_t cell, std::size_t first, std::size_t second, double contact) const;
  std::size_t bytes() const;

 private:
  struct Pairs {
    double expected = 0, counted = 0;
  };
  std::size_t index(std::size_t first, std::size_t second) const;
  Pairs of(std::uint32_t cell, std::size_t first, std::size_t second) const;
  Pairs of_all(std::uint32_t cell) const;
  void count(std::uint32_t cell, const std::vector<std::uint32_t>& held);

  Faults faults_;
  double path_of_one_;                       ///< of a particle of mean size, as of ExpectedPairs
  std::span<const double> volumes_;          ///< as of LatticeOfCells
  std::vector<WindowSum<D>> particles_;      ///< of each species
  std::vector<WindowSum<D, double>> pairs_;  ///< of each pair of them, those of one species counted twice
};

extern template class ExpectedPairs<2>;
extern template class ExpectedPairs<3>;
extern template class ExpectedPairsOfSpecies<2>;
extern template class ExpectedPairsOfSpecies<3>;

}  // namespace sandglass::dsmc
