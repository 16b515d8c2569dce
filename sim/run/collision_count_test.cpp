#include "sim/run/collision_count.hpp"

#include <gtest/gtest.h>

namespace sandglass::collision_count_test {
namespace {

TEST(CollisionCount, IsTwoCOverNForAConstantNumber) {
  CollisionCount count(3);
  for (std::uint64_t collisions : {0u, 1u, 7u, 1000u})
    EXPECT_EQ(count.per_particle(collisions, 3), 2 * static_cast<double>(collisions) / 3);
}

TEST(CollisionCount, AddsStretchesOfDifferentNumbers) {
  CollisionCount count(10);
  EXPECT_EQ(count.per_particle(5, 10), 1);
  EXPECT_EQ(count.per_particle(15, 20), 2);  // ten more among twenty
  EXPECT_EQ(count.per_particle(15, 4), 2);
  EXPECT_EQ(count.per_particle(19, 4), 4);
  EXPECT_EQ(count.per_particle(19, 0), 4);
}

TEST(CollisionCount, GoesOnAfterARestart) {
  CollisionCount count(10), again;
  count.per_particle(5, 10);
  count.per_particle(15, 20);
  again.load(count.save());
  EXPECT_EQ(again.per_particle(25, 40), count.per_particle(25, 40));
}

}  // namespace
}  // namespace sandglass::collision_count_test
