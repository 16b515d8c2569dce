#pragma once

#include "sim/method/dsmc/expected_pairs.hpp"
#include "sim/method/dsmc/local_factor.hpp"
#include "sim/method/dsmc/mixture_factor.hpp"

#include <optional>

namespace sandglass::dsmc {

/// What the pairs of each cell count more than in a dilute gas in a whole cell: contact factor, pairs expected instead of
/// counted, and a smaller volume.
template <int D>
class PairFactor {
 public:
  static bool needed(const Parameters& parameters, const LatticeOfCells<D>& cells) {
    return parameters.factor.formula != nullptr || parameters.pair_count == PairCount::expected ||
           !cells.volumes().empty();
  }
  /// Goes on to read the volumes of `cells`, which may change.
  PairFactor(const Parameters& parameters, const LatticeOfCells<D>& cells,
             const std::array<bool, D>& periodic, double particles);

  /// The volumes have changed.
  void update_volumes();
  /// In the cells of `work`. `offsets` as of ParticleStore; `full` as of LocalContactFactor; `species` of each particle, where there are several.
  void update(std::span<const std::uint32_t> offsets, const SharedCells& work,
              const std::uint8_t* full = nullptr, const std::uint8_t* species = nullptr);
  const double* values() const { return product_.empty() ? contact() : product_.data(); }
  /// As of CollisionStep::contact.
  const double* contact_of_pairs() const { return mixture_ ? mixture_->shares() : nullptr; }
  std::size_t bytes() const;

 private:
  /// Null without a contact factor; of a mixture, the largest of each cell.
  const double* contact() const {
    return contact_ ? contact_->values() : mixture_ ? mixture_->values() : nullptr;
  }

  std::optional<LocalContactFactor<D>> contact_;
  std::optional<ExpectedPairs<D>> expected_;
  std::optional<MixtureContactFactor<D>> mixture_;  ///< instead of these two
  std::span<const double> volumes_;                 ///< as of LatticeOfCells
  std::vector<double> product_;                     ///< empty where there is but a contact factor
};

extern template class PairFactor<2>;
extern template class PairFactor<3>;

}  // namespace sandglass::dsmc
