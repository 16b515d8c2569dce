#include "sim/base/exact_sum.hpp"

#include "sim/base/saved.hpp"

#include <bit>
#include <cmath>
#include <limits>

namespace sandglass {

void ExactSum::add(double value) {
  const auto word = std::bit_cast<std::uint64_t>(value);
  const int exponent = static_cast<int>((word >> 52) & 0x7ff);
  if (exponent == 0x7ff) {
    finite_ = false;
    return;
  }
  std::uint64_t mantissa = word & 0xfffffffffffffu;
  if (exponent > 0) mantissa |= std::uint64_t{1} << 52;
  const int position = exponent > 0 ? exponent - 1 : 0;  // bit 0 of the register is worth 2^-1074
  const auto index = static_cast<std::size_t>(position / 32);
  const int shift = position % 32;
  const std::uint64_t low = (mantissa & 0xffffffffu) << shift;
  const std::uint64_t high = (mantissa >> 32) << shift;
  const std::int64_t sign = (word >> 63) != 0 ? -1 : 1;
  limb_[index] += sign * static_cast<std::int64_t>(low & 0xffffffffu);
  limb_[index + 1] += sign * static_cast<std::int64_t>((low >> 32) + (high & 0xffffffffu));
  limb_[index + 2] += sign * static_cast<std::int64_t>(high >> 32);
  if (++pending_ == (1u << 29)) carry();
}

void ExactSum::add(const ExactSum& other) {
  ExactSum normal = other;
  normal.carry();
  carry();
  for (std::size_t i = 0; i < limb_.size(); ++i) limb_[i] += normal.limb_[i];
  finite_ = finite_ && other.finite_;
  carry();
}

/// Leaves every limb but the last in [0, 2^32).
void ExactSum::carry() {
  for (std::size_t i = 0; i + 1 < limb_.size(); ++i) {
    const std::int64_t over = limb_[i] >> 32;
    limb_[i] -= over * (std::int64_t{1} << 32);
    limb_[i + 1] += over;
  }
  pending_ = 0;
}

double ExactSum::value() const {
  if (!finite_) return std::numeric_limits<double>::quiet_NaN();
  ExactSum magnitude = *this;
  magnitude.carry();
  const bool negative = magnitude.limb_.back() < 0;
  if (negative) {
    for (std::int64_t& limb : magnitude.limb_) limb = -limb;
    magnitude.carry();
  }
  int top = kLimbs - 1;
  while (top > 0 && magnitude.limb_[static_cast<std::size_t>(top)] == 0) --top;
  // Three limbs hold at least 65 significant bits; the limbs below only say which way a tie goes.
  std::uint64_t sticky = 0;
  for (int i = 0; i + 3 < top + 1; ++i)
    sticky |= static_cast<std::uint64_t>(magnitude.limb_[static_cast<std::size_t>(i)]);
  __extension__ unsigned __int128 bits = 0;
  const int bottom = top < 2 ? 0 : top - 2;
  for (int i = top; i >= bottom; --i)
    bits = (bits << 32) | static_cast<std::uint64_t>(magnitude.limb_[static_cast<std::size_t>(i)]);
  int exponent = 32 * bottom - 1074;
  while ((bits >> 64) != 0) {
    sticky |= static_cast<std::uint64_t>(bits & 1);
    bits >>= 1;
    ++exponent;
  }
  const auto word = static_cast<std::uint64_t>(bits) | (sticky != 0 ? 1u : 0u);
  // One rounding of a 64-bit integer with a sticky last bit: x87-free and correct for normal results.
  const double result = std::ldexp(static_cast<double>(word), exponent);
  return negative ? -result : result;
}

std::vector<double> ExactSum::save() const {
  ExactSum normal = *this;
  normal.carry();
  std::vector<double> state{finite_ ? 1.0 : 0.0};
  for (std::int64_t limb : normal.limb_) state.push_back(static_cast<double>(limb));
  return state;
}

ExactSum ExactSum::load(const std::vector<double>& state) {
  ExactSum sum;
  sum.finite_ = state.at(0) != 0;
  for (std::size_t i = 0; i < sum.limb_.size(); ++i)
    sum.limb_[i] = static_cast<std::int64_t>(saved_number(state.at(i + 1), -0x1p53, 0x1p53, "a sum"));
  return sum;
}

}  // namespace sandglass
