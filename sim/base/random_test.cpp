#include "sim/base/random.hpp"

#include <array>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace sandglass::random_test {
namespace {

/// The slow twin: every draw is a Philox block named by its draw number.
class PhiloxStream {
 public:
  PhiloxStream(std::uint64_t seed, std::uint64_t step, std::uint64_t cell)
      : counter_{{0, step, cell, 3}}, key_{{seed, 1}} {}
  double uniform() {
    ++counter_[0];
    return static_cast<double>(r123::Philox4x64()(counter_, key_)[0] >> 11) * 0x1p-53;
  }

 private:
  r123::Philox4x64::ctr_type counter_;
  r123::Philox4x64::key_type key_;
};

/// Chi-square of pairs (first draw of stream i, second draw of stream i, first draw of stream i+1) in 8^3 boxes.
template <class MakeStream>
double chi_square_of_neighbouring_streams(MakeStream make, int streams) {
  std::array<int, 512> count{};
  for (int i = 0; i < streams; ++i) {
    auto here = make(i);
    auto next = make(i + 1);
    const auto a = static_cast<std::size_t>(8 * here.uniform());
    const auto b = static_cast<std::size_t>(8 * here.uniform());
    const auto c = static_cast<std::size_t>(8 * next.uniform());
    ++count[a * 64 + b * 8 + c];
  }
  double chi = 0;
  const double expected = streams / 512.0;
  for (int n : count) chi += (n - expected) * (n - expected) / expected;
  return chi;
}

// 511 degrees of freedom: mean 511, standard deviation 32; the bounds are five standard deviations.
constexpr double kLow = 511 - 5 * 32, kHigh = 511 + 5 * 32;

TEST(Random, NeighbouringCellsAreIndependent) {
  const StreamKey key(1, Purpose::collisions, 0, 12);
  const double chi = chi_square_of_neighbouring_streams(
      [&](int i) { return Random(key, static_cast<std::uint64_t>(i)); }, 200000);
  EXPECT_GT(chi, kLow);
  EXPECT_LT(chi, kHigh);
}

TEST(Random, NeighbouringStepsAndSeedsAreIndependent) {
  const double steps = chi_square_of_neighbouring_streams(
      [](int i) { return Random(StreamKey(1, Purpose::collisions, 0, static_cast<std::uint64_t>(i)), 5); },
      200000);
  const double seeds = chi_square_of_neighbouring_streams(
      [](int i) { return Random(StreamKey(static_cast<std::uint64_t>(i), Purpose::positions, 0, 0), 5); },
      200000);
  for (double chi : {steps, seeds}) {
    EXPECT_GT(chi, kLow);
    EXPECT_LT(chi, kHigh);
  }
}

TEST(Random, SlowTwinPassesTheSameTest) {
  const double chi = chi_square_of_neighbouring_streams(
      [](int i) { return PhiloxStream(1, 12, static_cast<std::uint64_t>(i)); }, 200000);
  EXPECT_GT(chi, kLow);
  EXPECT_LT(chi, kHigh);
}

TEST(Random, EveryNameCounts) {
  std::set<std::uint64_t> first;
  for (std::uint64_t seed : {1u, 2u})
    for (Purpose purpose : {Purpose::positions, Purpose::collisions})
      for (std::uint64_t replica : {0u, 1u})
        for (std::uint64_t step : {0u, 1u})
          for (std::uint64_t index : {0u, 1u})
            first.insert(Random(StreamKey(seed, purpose, replica, step), index).bits());
  EXPECT_EQ(first.size(), 32u);
}

TEST(Random, UniformHasTheRightMoments) {
  Random random(StreamKey(3, Purpose::positions, 0, 0), 0);
  double sum = 0, square = 0;
  constexpr int kDraws = 1'000'000;
  for (int i = 0; i < kDraws; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
    square += u * u;
  }
  EXPECT_NEAR(sum / kDraws, 0.5, 5 * std::sqrt(1.0 / 12 / kDraws));
  EXPECT_NEAR(square / kDraws, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / kDraws));
}

}  // namespace
}  // namespace sandglass::random_test
