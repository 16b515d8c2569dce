#include "sim/space/quad.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace sandglass::quad_test {
namespace {

TEST(Quad, HasTheDigitsOfSingleNumbers) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1e3, 1e3);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quad a{uniform(random), uniform(random), uniform(random), uniform(random)};
    const Quad b{uniform(random), uniform(random), uniform(random), uniform(random)};
    const Quad most = larger(a, b), root = square_root(a * a + b * b), whole = round_off(a);
    for (int k = 0; k < 4; ++k) {
      EXPECT_EQ(most[k], std::max(a[k], b[k]));
      EXPECT_EQ(root[k], std::sqrt(a[k] * a[k] + b[k] * b[k]));
      EXPECT_EQ(whole[k], std::rint(a[k]));
    }
    EXPECT_EQ(smallest(a), std::min({a[0], a[1], a[2], a[3]}));
  }
}

TEST(Quad, RoundsTiesToEven) {
  const Quad whole = round_off(Quad{0.5, 1.5, -0.5, -2.5});
  EXPECT_EQ(whole[0], 0);
  EXPECT_EQ(whole[1], 2);
  EXPECT_EQ(whole[2], 0);
  EXPECT_EQ(whole[3], -2);
}

TEST(Quad, SmallestKeepsInfinity) {
  EXPECT_EQ(smallest(Quad{HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL}), HUGE_VAL);
  EXPECT_EQ(smallest(WholeQuad{7, 5, 9, 5}), 5);
}

TEST(Quad, TransposesRowsToColumns) {
  double numbers[16];
  for (int k = 0; k < 16; ++k) numbers[k] = k;
  Quad rows[4] = {read_quad(numbers), read_quad(numbers + 4), read_quad(numbers + 8),
                  read_quad(numbers + 12)};
  transpose(rows);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) EXPECT_EQ(rows[column][row], numbers[4 * row + column]);
}

}  // namespace
}  // namespace sandglass::quad_test
