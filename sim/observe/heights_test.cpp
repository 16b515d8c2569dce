#include "sim/base/error.hpp"
#include "sim/observe/centre_of_mass.hpp"
#include "sim/observe/free_surface.hpp"
#include "sim/observe/test_view.hpp"

#include <gtest/gtest.h>

namespace sandglass::heights_test {
namespace {

ObserverSpec bounded(std::vector<int> axes) {
  ObserverSpec spec;
  spec.bounded = std::move(axes);
  return spec;
}

TestSystem<2> three_disks() {
  TestSystem<2> system;
  system.add_cell({{{1, 2}, {0, 0}}, {{3, 0.5}, {0, 0}}});
  system.add_cell({{{2, 3.5}, {1, 1}}});
  return system;
}

TEST(CentreOfMass, IsTheMeanPositionOfLikeParticles) {
  auto system = three_disks();
  EXPECT_EQ(CentreOfMass<2>(bounded({0, 1})).measure(system.view()), (std::vector<double>{2, 2}));
}

/// Masses 2, 0.5, 1.5 with weights 1, 4, 2: moments 2, 2 and 3 of 7.
TEST(CentreOfMass, CountsMassAndWeight) {
  auto system = three_disks();
  system.traits = {{1, 2, 0}, {1, 0.5, 0}, {1, 1.5, 0}};
  system.species = {0, 1, 2};
  system.weights = {1, 4, 2};
  const auto centre = CentreOfMass<2>(bounded({0, 1})).measure(system.view());
  EXPECT_DOUBLE_EQ(centre[0], (2 * 1 + 2 * 3 + 3 * 2) / 7.0);
  EXPECT_DOUBLE_EQ(centre[1], (2 * 2 + 2 * 0.5 + 3 * 3.5) / 7.0);
}

TEST(CentreOfMass, HasNoPlaceOnAPeriodicAxis) {
  auto system = random_system<3>({4, 5, 6}, 50, 1);
  const CentreOfMass<3> height(bounded({2}));
  EXPECT_EQ(height.quantity().components, std::vector<std::string>{"z"});
  const auto all = CentreOfMass<3>(bounded({0, 1, 2})).measure(system.view());
  EXPECT_EQ(CentreOfMass<3>(bounded({2})).measure(system.view()), std::vector<double>{all[2]});
  EXPECT_THROW(CentreOfMass<3>(bounded({})), InputError);
}

ObserverSpec columns(int axis, std::vector<std::size_t> grid) {
  ObserverSpec spec;
  spec.axis = axis;
  spec.grid = std::move(grid);
  return spec;
}

TEST(FreeSurface, IsTheHighestParticleOfEachBin) {
  auto system = three_disks();
  system.add_cell({{{1.5, 1.9}, {0, 0}}, {{3.1, -0.5}, {0, 0}}});  // a floor may sink below the box
  EXPECT_EQ(FreeSurface<2>(columns(1, {4, 1})).measure(system.view()), (std::vector<double>{0, 2, 3.5, 0.5}));
  EXPECT_EQ(FreeSurface<2>(columns(0, {1, 2})).measure(system.view()), (std::vector<double>{3.1, 2}));
}

/// Slow twin: for every bin a look at all particles.
TEST(FreeSurface, OfManySpheres) {
  auto system = random_system<3>({4, 5, 6}, 60, 3);
  const FreeSurface<3> shape(columns(2, {3, 5, 1}));
  EXPECT_EQ(shape.quantity().shape, (std::vector<std::size_t>{3, 5}));
  const auto heights = FreeSurface<3>(columns(2, {3, 5, 1})).measure(system.view());
  ASSERT_EQ(heights.size(), 15u);
  int empty = 0;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 5; ++y) {
      double highest = 0;
      for (const Phase<3>& particle : system.particles)
        if (static_cast<int>(particle.position[0] * 3 / 4) == x &&
            static_cast<int>(particle.position[1]) == y)
          highest = std::max(highest, particle.position[2]);
      EXPECT_EQ(heights[static_cast<std::size_t>(5 * x + y)], highest);
      empty += highest == 0;
    }
  EXPECT_LT(empty, 3);
}

TEST(FreeSurface, HasOneHeightOverEachBin) {
  EXPECT_THROW(FreeSurface<2>(columns(1, {4, 2})), InputError);
  EXPECT_THROW(FreeSurface<3>(columns(0, {2, 1, 1})), InputError);
}

}  // namespace
}  // namespace sandglass::heights_test
