#include "sim/observe/lattice.hpp"

#include <gtest/gtest.h>

namespace sandglass::lattice_test {
namespace {

/// Three bins of length 2 by four of length 1.
TEST(Lattice, TakesWhatIsOutsideToTheBinAtTheEdge) {
  const Lattice<2> lattice{{3, 4}};
  const Vector<2> box(6, 4);
  EXPECT_EQ(lattice.bin_of({2.5, 1.5}, box), 5u);
  EXPECT_EQ(lattice.bin_of({6, 4}, box), 11u);
  EXPECT_EQ(lattice.bin_of({-0.1, 1.5}, box), 1u);
  EXPECT_EQ(lattice.bin_of({2.5, -1e30}, box), 4u);
  EXPECT_EQ(lattice.bin_of({1e30, 1.5}, box), 9u);
}

}  // namespace
}  // namespace sandglass::lattice_test
