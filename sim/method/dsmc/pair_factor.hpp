#pragma once

#include "sim/method/dsmc/expected_pairs.hpp"
#include "sim/method/dsmc/local_factor.hpp"

#include <optional>

namespace sandglass::dsmc {

/// What the pairs of each cell count more than in a dilute gas: contact factor, and pairs expected instead of counted.
template <int D>
class PairFactor {
 public:
  static bool needed(const Parameters& parameters) {
    return parameters.factor.formula != nullptr || parameters.pair_count == PairCount::expected;
  }
  PairFactor(const Parameters& parameters, const Grid<D>& grid, const std::array<bool, D>& periodic,
             double particles);

  /// `offsets` as of ParticleStore; `full` as of LocalContactFactor.
  void update(std::span<const std::uint32_t> offsets, const std::uint8_t* full = nullptr);
  const double* values() const { return expected_ ? product_.data() : contact_->values(); }
  std::size_t bytes() const;

 private:
  std::optional<LocalContactFactor<D>> contact_;
  std::optional<ExpectedPairs<D>> expected_;
  std::vector<double> product_;  ///< only where pairs are expected
};

extern template class PairFactor<2>;
extern template class PairFactor<3>;

}  // namespace sandglass::dsmc
