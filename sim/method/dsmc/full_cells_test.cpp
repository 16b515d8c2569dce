#include "sim/method/dsmc/full_cells.hpp"

#include "sim/method/dsmc/test_crowd.hpp"

#include <gtest/gtest.h>

namespace sandglass::dsmc::full_cells_test {
namespace {

TEST(FullCells, HaveNoRoomForOneMore) {
  const Parameters parameters = crowd_parameters<2>();
  FullCells<2> full(parameters, crowd_grid<2>(2));
  EXPECT_EQ(full.capacity(0), 10U);  // ten are 0.8 exactly, though 0.8 / 0.08 is not
  const std::vector<std::uint32_t> offsets = {0, 9, 19, 30, 30};
  full.update(offsets);
  EXPECT_FALSE(full.full(0));
  EXPECT_TRUE(full.full(1));
  EXPECT_TRUE(full.full(2));
  EXPECT_FALSE(full.full(3));
  EXPECT_FALSE(full.full(4));  // out of the box
  EXPECT_TRUE(full.any());
  EXPECT_TRUE(full.many());
  const std::vector<std::uint32_t> sparse = {0, 9, 18, 18, 18};
  full.update(sparse);
  EXPECT_FALSE(full.any());
  EXPECT_FALSE(full.many());
}

TEST(FullCells, AreManyWhereTheyHoldAQuarterOfTheParticles) {
  FullCells<2> full(crowd_parameters<2>(), crowd_grid<2>(6));
  for (const std::uint32_t others : {29u, 30u}) {
    std::vector<std::uint32_t> offsets = {0, 10};
    for (std::uint32_t cell = 1; cell < 36; ++cell) offsets.push_back(10 + std::min(cell, others));
    full.update(offsets);
    EXPECT_TRUE(full.any());
    EXPECT_EQ(full.many(), others == 29);
  }
}

/// A box around one square on a corner: a quarter cell in each of its corners.
TEST(FullCells, AtWallsHoldByTheirVolume) {
  const Parameters parameters = crowd_parameters<2>();
  const auto cells =
      LatticeOfCells<2>::diagonal(Grid<2>(Vector<2>(M_SQRT2, M_SQRT2), {1, 1}), {false, false});
  FullCells<2> full(parameters, cells);
  ASSERT_EQ(cells.size(), 5U);
  for (const std::uint32_t corner : {0u, 1u, 3u, 4u}) EXPECT_EQ(full.capacity(corner), 2U);
  EXPECT_EQ(full.capacity(2), 10U);
  const std::vector<std::uint32_t> offsets = {0, 1, 3, 12, 15, 15};
  full.update(offsets);
  for (const std::uint32_t cell : {0u, 2u, 4u}) EXPECT_FALSE(full.full(cell));
  for (const std::uint32_t cell : {1u, 3u}) EXPECT_TRUE(full.full(cell));
}

TEST(FullCells, CountRealParticles) {
  Parameters parameters = crowd_parameters<3>();
  parameters.excluded_volume.densest = 0.64;
  parameters.weight = 1;
  // Spheres of diameter one, pi/6 of a unit volume each: 12 in a cell of volume 10, 0.63 of it; 13 would be 0.68.
  EXPECT_EQ(most_in_cell(3, parameters, 10), 12U);
  parameters.weight = 0.5;
  EXPECT_EQ(most_in_cell(3, parameters, 10), 24U);
  EXPECT_EQ(most_in_cell(3, parameters, 0.1), 0U);
  parameters.excluded_volume.densest = 0.6;
  parameters.weight = 0.2 / particle_volume(3, 1);
  ASSERT_LT(0.6 / 0.2, 3);  // division leaves it short
  EXPECT_EQ(most_in_cell(3, parameters, 1), 3U);
}

}  // namespace
}  // namespace sandglass::dsmc::full_cells_test
