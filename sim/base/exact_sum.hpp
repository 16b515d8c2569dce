#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace sandglass {

/// Sum of doubles without rounding, hence independent of their order: a fixed-point register that spans every
/// finite double (Kulisch's accumulator). Adding costs about 5 ns. Not-a-number and infinity poison the result.
class ExactSum {
 public:
  void add(double value);
  void add(const ExactSum& other);
  /// The sum, rounded once.
  double value() const;

  /// Exact state as doubles, for checkpoints.
  std::vector<double> save() const;
  static ExactSum load(const std::vector<double>& state);

 private:
  static constexpr int kLimbs = 67;  ///< 32 bits each: 2^-1074 to 2^1023 and room for carries
  void carry();

  std::array<std::int64_t, kLimbs> limb_{};
  std::uint32_t pending_ = 0;  ///< additions since the last carry
  bool finite_ = true;
};

}  // namespace sandglass
