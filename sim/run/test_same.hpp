#pragma once

#include "sim/run/run.hpp"

#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

namespace sandglass {

inline void expect_same_frame(const Frame& a, const Frame& b) {
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.velocity, b.velocity);
  ASSERT_EQ(a.columns.all().size(), b.columns.all().size());
  for (const NamedColumn& column : a.columns.all()) {
    const NamedColumn* other = b.columns.find(column.info);
    EXPECT_TRUE(other != nullptr && column.numbers == other->numbers) << column.info.name;
  }
}

/// All that a run has worked out.
inline void expect_same(const Record& a, const Record& b) {
  ASSERT_EQ(a.replicas.size(), b.replicas.size());
  for (std::size_t r = 0; r < a.replicas.size(); ++r) {
    EXPECT_EQ(a.replicas[r].counters, b.replicas[r].counters);
    ASSERT_EQ(a.replicas[r].series.size(), b.replicas[r].series.size());
    for (std::size_t s = 0; s < a.replicas[r].series.size(); ++s) {
      EXPECT_EQ(a.replicas[r].series[s].value, b.replicas[r].series[s].value)
          << a.replicas[r].series[s].quantity.name;
      EXPECT_EQ(a.replicas[r].series[s].time, b.replicas[r].series[s].time);
    }
  }
  ASSERT_EQ(a.estimates.size(), b.estimates.size());
  for (std::size_t i = 0; i < a.estimates.size(); ++i) EXPECT_EQ(a.estimates[i].value, b.estimates[i].value);
  ASSERT_EQ(a.trajectory.size(), b.trajectory.size());
  for (std::size_t f = 0; f < a.trajectory.size(); ++f) expect_same_frame(a.trajectory[f], b.trajectory[f]);
}

}  // namespace sandglass
