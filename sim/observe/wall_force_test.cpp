#include "sim/observe/wall_force.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/test_view.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace sandglass::wall_force_test {
namespace {

ObserverSpec bounded(std::vector<int> axes) {
  ObserverSpec spec;
  spec.bounded = std::move(axes);
  return spec;
}

constexpr auto force = WallForce<2>::Kind::force;
constexpr auto power = WallForce<2>::Kind::power;
constexpr auto heat = WallForce<2>::Kind::heat;
constexpr std::size_t floor_side = WallImpulses<2>::side(1, false);

/// Weight 3: momenta (1, -2) and (0, -4) in a time of 4 give the force 3 (1, -6) / 4, and against a floor that rises with
/// 0.5 at the second hit the power 3 * 2 / 4. Of the heat 0.4 it is 3 * 0.4 / 4.
TEST(WallForce, IsMomentumPerTimeSinceTheLastSample) {
  TestSystem<2> system;
  system.add_cell({{{1, 1}, {0, 0}}});
  WallForce<2> forces(bounded({1}), force), powers(bounded({1}), power), heats(bounded({1}), heat);
  EXPECT_FALSE(forces.measures_at_start());
  EXPECT_EQ(forces.quantity().components,
            (std::vector<std::string>{"y-low-x", "y-low-y", "y-high-x", "y-high-y"}));
  EXPECT_EQ(powers.quantity().components, (std::vector<std::string>{"y-low", "y-high"}));
  system.walls.add(floor_side, {100, 100}, {0, 0}, 7);  // before the start
  forces.start(system.view());
  powers.start(system.view());
  heats.start(system.view());
  system.walls.add(floor_side, {1, -2}, {0, 0}, 0);
  system.walls.add(floor_side, {0, -4}, {0, 0.5}, 0.4);
  system.time = 4;
  EXPECT_EQ(forces.measure(system.view()), (std::vector<double>{0.75, -4.5, 0, 0}));
  EXPECT_EQ(powers.measure(system.view()), (std::vector<double>{1.5, 0}));
  EXPECT_EQ(heats.quantity().components, powers.quantity().components);
  EXPECT_NEAR(heats.measure(system.view())[0], 0.3, 1e-15);
  system.walls.add(WallImpulses<2>::side(1, true), {0, 8}, {0, 0}, 0);
  system.time = 6;
  EXPECT_EQ(forces.measure(system.view()), (std::vector<double>{0, 0, 0, 12}));
}

TEST(WallForce, GoesOnFromACheckpoint) {
  TestSystem<2> system;
  system.add_cell({{{1, 1}, {0, 0}}});
  WallForce<2> one(bounded({0, 1}), force), two(bounded({0, 1}), force);
  system.walls.add(floor_side, {0.1, -0.7}, {1, 0}, 0.3);
  one.start(system.view());
  two.load(one.save());
  WallImpulses<2> restored;
  restored.load(system.walls.save());
  EXPECT_EQ(restored.impulse(floor_side), system.walls.impulse(floor_side));
  EXPECT_EQ(restored.work(floor_side), -0.1);
  EXPECT_EQ(restored.heat(floor_side), 0.3);
  system.walls = restored;
  system.walls.add(floor_side, {0.1, 0.3}, {0, 0}, 0);
  system.time = 1;
  EXPECT_EQ(one.measure(system.view()), two.measure(system.view()));
  EXPECT_THROW(restored.load({1, 2, 3}), std::out_of_range);
}

TEST(WallForce, RefusesWhatNobodyCounts) {
  EXPECT_THROW(WallForce<2>(bounded({}), force), InputError);
  TestSystem<2> system;
  system.add_cell({{{1, 1}, {0, 0}}});
  WallForce<2> forces(bounded({1}), force);
  View<2> view = system.view();
  view.walls = nullptr;
  EXPECT_THROW(forces.start(view), InputError);
  system.weights = {2};
  EXPECT_THROW(forces.start(system.view()), InputError);
}

}  // namespace
}  // namespace sandglass::wall_force_test
