#include "sim/base/exact_sum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace sandglass::exact_sum_test {
namespace {

double exact(const std::vector<double>& terms) {
  ExactSum sum;
  for (double term : terms) sum.add(term);
  return sum.value();
}

TEST(ExactSum, KeepsWhatFloatingPointLoses) {
  EXPECT_EQ(exact({1e300, 1.0, -1e300}), 1.0);
  EXPECT_EQ(exact({1.0, 0x1p-53, 0x1p-106}), 1.0 + 0x1p-52);  // just above the tie: rounds up
  EXPECT_EQ(exact({1.0, 0x1p-53}), 1.0);                      // the tie itself: to even
  EXPECT_EQ(exact({-3.5, 1.25}), -2.25);
  EXPECT_EQ(exact({}), 0.0);
}

TEST(ExactSum, HoldsTheWholeRange) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(exact({tiny, tiny}), 2 * tiny);
  EXPECT_EQ(exact({std::numeric_limits<double>::max()}), std::numeric_limits<double>::max());
  EXPECT_TRUE(std::isnan(exact({1.0, std::numeric_limits<double>::infinity()})));
}

TEST(ExactSum, DoesNotDependOnOrder) {
  std::mt19937_64 generator(7);
  std::vector<double> terms;
  for (int i = 0; i < 1000; ++i)
    terms.push_back(std::ldexp(std::uniform_real_distribution<>(-1, 1)(generator),
                               static_cast<int>(generator() % 200) - 100));
  const double first = exact(terms);
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::shuffle(terms.begin(), terms.end(), generator);
    EXPECT_EQ(exact(terms), first);
  }
  long double plain = 0;
  for (double term : terms) plain += term;
  EXPECT_NEAR(first, static_cast<double>(plain), 1e-12 * std::abs(first));
}

TEST(ExactSum, AddsRegistersAndSurvivesASave) {
  ExactSum left, right;
  left.add(-1e20);
  left.add(0.1);
  right.add(1e20);
  left.add(ExactSum::load(right.save()));
  EXPECT_EQ(left.value(), 0.1);
}

}  // namespace
}  // namespace sandglass::exact_sum_test
