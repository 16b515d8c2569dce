#include "sim/base/error.hpp"
#include "sim/observe/collisions.hpp"
#include "sim/observe/test_view.hpp"

#include <gtest/gtest.h>

// What only methods with contacts have: impact parameters, overlaps, the virial of hard particles.

namespace sandglass::contact_test {
namespace {

ObserverSpec bins(std::size_t count) {
  ObserverSpec spec;
  spec.what = "impact-parameter";
  spec.bins = count;
  return spec;
}

TEST(ImpactParameter, CountsSinceThePreviousSample) {
  TestSystem<2> system;
  system.tally.impact = {5, 1, 0};
  ImpactParameter<2> observer(bins(3));
  EXPECT_FALSE(observer.measures_at_start());
  observer.start(system.view());
  system.tally.impact = {7, 1, 4};
  EXPECT_EQ(observer.measure(system.view()), (std::vector<double>{2, 0, 4}));
  EXPECT_EQ(observer.measure(system.view()), (std::vector<double>{0, 0, 0}));
  system.tally.impact = {7, 2, 4};
  EXPECT_EQ(observer.measure(system.view()), (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(observer.quantity().axis, (std::vector<double>{0, 1 / 3.0, 2 / 3.0, 1}));
}

TEST(ImpactParameter, GoesOnFromItsState) {
  TestSystem<3> system;
  system.tally.impact = {5, (1ull << 52) + 1};
  ImpactParameter<3> whole(bins(2)), resumed(bins(2));
  whole.start(system.view());
  resumed.load(whole.save());
  system.tally.impact = {6, (1ull << 52) + 4};
  EXPECT_EQ(whole.measure(system.view()), (std::vector<double>{1, 3}));
  EXPECT_EQ(resumed.measure(system.view()), (std::vector<double>{1, 3}));
}

TEST(ImpactParameter, MethodWithoutContactsIsRefused) {
  TestSystem<2> system;
  EXPECT_THROW(ImpactParameter<2>(bins(3)).start(system.view()), InputError);
}

TEST(Overlap, IsTheDeepestSoFar) {
  TestSystem<2> system;
  EXPECT_EQ(Overlap<2>().measure(system.view())[0], 0);
  system.tally.deepest_overlap = 1e-15;
  EXPECT_EQ(Overlap<2>().measure(system.view())[0], 1e-15);
  EXPECT_FALSE(Overlap<2>().cumulative());
  EXPECT_TRUE(Overlap<2>().measures_at_start());
}

/// Two disks with velocities +-v on a line around a periodic box are the gas of Tonks (1936): the mean force through any
/// plane across the line is F = N m v^2 / (L - N d), of which N m v^2 / L is carried by flight. The rest of F L is D V p_c.
TEST(Pressure, OfTwoDisksOnALineIsThatOfTonks) {
  const double d = 0.7, v = 1.3, length = 4;
  TestSystem<2> system;
  system.weight = 1;
  system.add_cell({{{1, 1}, {v, 0}}, {{1 + d, 1}, {-v, 0}}});  // in contact: the first collision is now
  Pressure<2> pressure;
  pressure.start(system.view());
  const int collisions = 10;
  double separation = -d;  // r_1 - r_2 along the line
  for (int i = 0; i < collisions; ++i) {
    const double impulse = -system.mass * 2 * system.particles[0].velocity[0];
    system.tally.transfer.add(impulse * separation);
    for (Phase<2>& particle : system.particles) particle.velocity[0] *= -1;
    system.time += (length - 2 * d) / (2 * v);  // to the contact on the other side
    separation *= -1;
  }
  const double force = 2 * system.mass * v * v / (length - 2 * d);
  const double expected = (force * length - 2 * system.mass * v * v) / (2 * 16);
  EXPECT_NEAR(pressure.measure(system.view())[1], expected, 1e-14);
}

}  // namespace
}  // namespace sandglass::contact_test
