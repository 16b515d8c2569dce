#include "sim/method/mixing/filled_rows.hpp"

#include "sim/base/random.hpp"

#include <gtest/gtest.h>

namespace sandglass::mixing::filled_rows_test {
namespace {

struct Part {
  double x;
  std::uint32_t first, last;
};

/// The twin: rows from the floor that some part between the two places holds.
std::uint32_t filled(const std::vector<Part>& parts, double low, double high, std::uint32_t rows) {
  for (std::uint32_t row = 0; row < rows; ++row) {
    bool any = false;
    for (const Part& part : parts)
      any |= part.x >= low && part.x <= high && part.first <= row && row <= part.last;
    if (!any) return row;
  }
  return rows;
}

TEST(FilledRows, BoundWhatIsFilledFromBothSides) {
  constexpr double kWidth = 10, kColumn = kWidth / 40;
  Random random(StreamKey(1, Purpose::positions, 0, 0), 0);
  std::uint32_t differ = 0, all = 0;
  for (const std::uint32_t rows : {5u, 64u, 150u})
    for (int trial = 0; trial < 300; ++trial) {
      FilledRows filled_rows(kWidth, 40, rows);
      filled_rows.begin(1000);
      std::vector<Part> parts;
      for (std::uint32_t i = 0; i < 8 * rows; ++i) {
        const auto row = static_cast<std::uint32_t>(rows * random.uniform());
        parts.push_back({kWidth * random.uniform(), row, std::min(row + i % 3, rows - 1)});
        filled_rows.add(parts.back().x, row, parts.back().last);
      }
      const double low = 6 * random.uniform(), high = low + 4;
      const std::uint32_t most = filled_rows.touched(low, high), least = filled_rows.within(low, high);
      EXPECT_GE(most, filled(parts, low, high, rows));
      EXPECT_LE(most, filled(parts, low - kColumn, high + kColumn, rows));
      EXPECT_LE(least, filled(parts, low, high, rows));
      EXPECT_GE(least, filled(parts, low + kColumn + 1e-9, high - kColumn - 1e-9, rows));
      differ += least < most;
      all += least == rows;
    }
  EXPECT_GT(differ, 20u);
  EXPECT_GT(all, 100u);
}

TEST(FilledRows, ManyRowsTakeNoMoreMemoryThanParticlesDo) {
  FilledRows filled_rows(1, 1'000'000, 1'000'000);
  filled_rows.begin(10);
  EXPECT_LT(filled_rows.bytes(), 200'000u);
  filled_rows.add(0.9, 0, 999'999);
  EXPECT_EQ(filled_rows.touched(0.1, 0.2), 1'000'000u) << "one column for all";
  EXPECT_EQ(filled_rows.within(0.1, 0.95), 0u);
}

}  // namespace
}  // namespace sandglass::mixing::filled_rows_test
