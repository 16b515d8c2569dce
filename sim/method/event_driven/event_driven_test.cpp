#include "sim/method/event_driven/event_driven.hpp"

#include "sim/base/random.hpp"

namespace sandglass::event_driven::event_driven_test {
namespace {

TEST(EventDriven, TwoDisksMeetHeadOnAndExchangeVelocities) {
  Parameters<2> parameters;
  parameters.geometry = {Vector<2>(10, 10), {true, true}};
  const auto gas = make_event_driven<2>(parameters, {}, {1, 0});
  gas->assign({{{{2, 5}, {1, 0}}, {{6, 5}, {-1, 0}}}, {}});
  gas->step(2, 0);  // they touch at 1.5, at x = 3.5 and 4.5
  const auto particles = gas->view().particles;
  EXPECT_NEAR(particles[0].position[0], 3, 1e-14);
  EXPECT_NEAR(particles[1].position[0], 5, 1e-14);
  EXPECT_EQ(particles[0].velocity[0], -1);
  EXPECT_EQ(gas->tally().collisions, 1u);
}

}  // namespace
}  // namespace sandglass::event_driven::event_driven_test
