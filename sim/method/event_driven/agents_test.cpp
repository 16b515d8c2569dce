#include "sim/method/event_driven/test_gas.hpp"

namespace sandglass::event_driven::agents_test {
namespace {

TEST(Agents, AWallAtRestTurnsTheNormalVelocityRound) {
  TestGas<3> gas({6, 6, 6});
  gas.add_walls(0, {WallKind::specular, {{0.8}}});
  gas.add({3, 1, 2}, {2, 0.1, -0.2});
  const auto engine = gas.make();
  engine->step(2, 0);  // touches at x = 5.5 after 1.25
  EXPECT_NEAR(engine->view().particles[0].position[0], 5.5 - 0.75 * 1.6, 1e-14);
  EXPECT_NEAR(engine->view().particles[0].velocity[0], -1.6, 1e-15);
  EXPECT_EQ(engine->view().particles[0].velocity[1], 0.1);
}

/// A wall that comes with speed u gives 2 u.
TEST(Agents, AMovingWallGivesTwiceItsSpeed) {
  TestGas<2> gas({20, 8});
  gas.parameters.geometry.periodic[0] = false;
  WallPlace<2> place;
  place.velocity = {0.25, 0};
  gas.agents.push_back(
      [place] { return std::make_unique<WallAgent<2>>(place, WallRule{}, Vector<2>(Vector<2>::Zero())); });
  gas.add({5, 2}, {-1, 0});
  const auto engine = gas.make();
  engine->step(10, 0);
  const double contact = 4.5 / 1.25;
  EXPECT_NEAR(engine->view().particles[0].velocity[0], 1.5, 1e-15);
  EXPECT_NEAR(engine->view().particles[0].position[0], 5 - contact + 1.5 * (10 - contact), 1e-13);
}

/// On a plate that vibrates: every bounce happens where ball and plate are at one place, and gives r times the approach.
TEST(Agents, AVibratingPlate) {
  TestGas<2> gas({8, 60});
  gas.parameters.geometry.periodic[1] = false;
  gas.parameters.gravity = {0, -1};
  WallPlace<2> place;
  place.axis = 1;
  place.amplitude = 0.3, place.frequency = 0.7;
  const WallRule rule{WallKind::specular, {{0.8}}};
  gas.agents.push_back([=] { return std::make_unique<WallAgent<2>>(place, rule, Vector<2>(0, -1)); });
  gas.add({4, 5}, {0, 0});
  Recorder<2> trace;
  const auto engine = gas.make(&trace);
  engine->step(200, 0);
  ASSERT_GT(trace.events.size(), 20u);
  const PlaneMotion plate{0, 0, place.amplitude, place.frequency, 0};
  double time = 0, height = 5, speed = 0;
  for (const auto& event : trace.events) {
    const double dt = event.time - time, arrival = speed - dt;
    EXPECT_NEAR(event.position[1] - 0.5, plate.at(event.time), 1e-11);
    EXPECT_NEAR(height + speed * dt - dt * dt / 2, event.position[1], 1e-11);
    EXPECT_NEAR(event.velocity_1[1], plate.velocity_at(event.time) * 1.8 - 0.8 * arrival, 1e-10);
    time = event.time, height = event.position[1], speed = event.velocity_1[1];
  }
}

/// Angular momentum about the centre and energy are kept by a specular disk.
TEST(Agents, AnObstacleKeepsAngularMomentum) {
  TestGas<2> gas({20, 20});
  const Vector<2> centre(10, 10);
  gas.add_obstacle(centre, 2);
  gas.add({10.7, 3}, {0.1, 1});
  const auto momentum_about = [&](const Phase<2>& p) {
    const Vector<2> r = p.position - centre;
    return r[0] * p.velocity[1] - r[1] * p.velocity[0];
  };
  const auto engine = gas.make();
  const double before = momentum_about(engine->view().particles[0]);
  engine->step(7, 0);
  const auto after = engine->view().particles[0];
  EXPECT_NEAR(momentum_about(after), before, 1e-13);
  EXPECT_NEAR(after.velocity.squaredNorm(), 1.01, 1e-14);
  EXPECT_LT(after.velocity[1], 0.9);  // it did bounce
}

TEST(Agents, AnObstacleInAGasIsNeverEntered) {
  for (const double g : {0.0, -0.2}) {
    auto gas = lattice_gas<2>(12, 1.5);
    const Vector<2> centre(9, 9);
    std::erase_if(gas.particles.phases,
                  [&](const Phase<2>& phase) { return (phase.position - centre).norm() < 3.6; });
    gas.parameters.particles = gas.particles.phases.size();
    gas.parameters.gravity = {g, 0};
    gas.add_obstacle(centre, 3);
    const auto engine = gas.make();
    for (int i = 0; i < 100; ++i) {
      engine->step(0.3, 0);
      for (const auto& phase : engine->view().particles)
        ASSERT_GE((phase.position - centre).norm(), 3.5 - 1e-10);
    }
    EXPECT_LT(engine->tally().deepest_overlap, 1e-11);
  }
}

/// Straight flights round the box: n passages each, counted once, wherever the plane stands: inside a cell, on the edge of
/// one, on the periodic boundary.
TEST(Agents, APlaneCountsEveryPassageOnce) {
  for (const double position : {3.21, 2.0, 4.0, 6.0, 0.0}) {
    SCOPED_TRACE(position);
    std::vector<Plane> planes{Plane(0, position, {-10, 0, 10})};
    TestGas<2> gas({12, 12});
    Plane* plane = planes.data();
    gas.agents.push_back(
        [plane] { return std::make_unique<PlaneAgent<2>>(plane, Vector<2>(Vector<2>::Zero())); });
    double up = 0, down = 0;
    const double duration = 1003.3;
    for (int i = 0; i < 6; ++i) {
      const double x = 0.7 + 1.9 * i, speed = (i % 2 == 0 ? 1 : -1) * (0.31 + 0.17 * i);
      gas.add({x, 1 + 2 * i}, {speed, 0});
      const double passages =
          std::floor((x + speed * duration - position) / 12) - std::floor((x - position) / 12);
      (speed > 0 ? up : down) += std::fabs(passages);
    }
    const auto engine = gas.make();
    for (int i = 0; i < 50; ++i) engine->step(duration / 50, 0);
    EXPECT_EQ(plane->up(), up);
    EXPECT_EQ(plane->down(), down);
    EXPECT_GT(up + down, 300);
  }
}

/// A parabola rises and falls through a plane.
TEST(Agents, APlaneUnderGravityCountsBothWays) {
  for (const double position : {3.21, 4.0, 6.0}) {
    SCOPED_TRACE(position);
    std::vector<Plane> planes{Plane(1, position, {-10, 0, 10})};
    TestGas<2> gas({12, 12});
    gas.parameters.gravity = {0, -1};
    gas.add_walls(1);
    Plane* plane = planes.data();
    gas.agents.push_back([plane] { return std::make_unique<PlaneAgent<2>>(plane, Vector<2>(0, -1)); });
    gas.add({3, 7.5}, {0.1, 0});
    const auto engine = gas.make();
    engine->step(std::sqrt(14.0) * 40.5, 0);  // 20 whole bounces and a quarter: the period is 2 sqrt(2 h / g)
    EXPECT_EQ(plane->up(), 20);
    EXPECT_GE(plane->down(), 20);
    EXPECT_LE(plane->down(), 21);
  }
}

/// An endless fall round the box, first up and then down: passages on the way to the summit, and from it.
TEST(Agents, APlaneCountsAnEndlessFall) {
  for (const double position : {3.21, 4.0, 0.0}) {
    SCOPED_TRACE(position);
    std::vector<Plane> planes{Plane(1, position, {-200, 0, 200})};
    TestGas<2> gas({12, 12});
    gas.parameters.gravity = {0, -1};
    Plane* plane = planes.data();
    gas.agents.push_back([plane] { return std::make_unique<PlaneAgent<2>>(plane, Vector<2>(0, -1)); });
    const auto turns = [position](double y) { return std::floor((y - position) / 12); };
    double up = 0, down = 0;
    const double duration = 40.3;
    for (int i = 0; i < 5; ++i) {
      const double y = 1.3 + 2 * i, speed = 7.1 * (i - 1);
      gas.add({1 + 2 * i, y}, {0, speed});
      const double summit = y + std::max(0.0, speed) * speed / 2;
      up += turns(summit) - turns(y);
      down += turns(summit) - turns(y + speed * duration - duration * duration / 2);
    }
    const auto engine = gas.make();
    for (int i = 0; i < 50; ++i) engine->step(duration / 50, 0);
    EXPECT_EQ(plane->up(), up);
    EXPECT_EQ(plane->down(), down);
    EXPECT_EQ(engine->tally().collisions, 0u);
    EXPECT_GT(up, 10);
    EXPECT_GT(down, 100);
  }
}

TEST(Agents, ATimerFiresAtItsTimesAndTurnsParticles) {
  std::vector<double> times;
  const auto action = [&times](ParticleAccess<2>& particles, double now) {
    times.push_back(now);
    ASSERT_EQ(particles.numbers(), 2u);
    particles.set_velocity(0, -particles.state(0).velocity);
  };
  TestGas<2> gas({20, 20});
  gas.agents.push_back(
      [&] { return std::make_unique<TimerAgent<2, std::decay_t<decltype(action)>>>(0.75, 0.5, action); });
  gas.add({2, 2}, {1, 0.5});
  gas.add({9, 15}, {0, 0});
  const auto engine = gas.make();
  for (int i = 0; i < 10; ++i) engine->step(0.28, 0);
  ASSERT_EQ(times.size(), 5u);
  for (std::size_t k = 0; k < times.size(); ++k)
    EXPECT_NEAR(times[k], 0.75 + 0.5 * static_cast<double>(k), 1e-14);
  const double along = 0.75 - 0.5 + 0.5 - 0.5 + 0.5 - 0.05;
  EXPECT_LT((by_id(*engine)[0].position - Vector<2>(2 + along, 2 + along / 2)).norm(), 1e-13);
}

/// After a change of velocity what was predicted is void, and found anew.
TEST(Agents, AParticleOnANewWayCollidesThere) {
  const auto action = [](ParticleAccess<2>& particles, double) {
    for (std::uint32_t i = 0; i < particles.numbers(); ++i)
      if (particles.state(i).velocity.norm() > 0) particles.set_velocity(i, {0, 1});
  };
  TestGas<2> gas({20, 20});
  gas.agents.push_back(
      [&] { return std::make_unique<TimerAgent<2, std::decay_t<decltype(action)>>>(1, 100, action); });
  gas.add({2, 2}, {1, 0});
  gas.add({6, 2}, {0, 0});
  gas.add({3, 6}, {0, 0});
  const auto engine = gas.make();
  engine->step(5, 0);
  const auto phases = by_id(*engine);
  EXPECT_EQ(engine->tally().collisions, 1u);
  EXPECT_EQ(phases[1].velocity, Vector<2>(0, 0));
  EXPECT_LT((phases[2].velocity - Vector<2>(0, 1)).norm(), 1e-15);
  EXPECT_LT((phases[0].position - Vector<2>(3, 5)).norm(), 1e-14);
}

}  // namespace
}  // namespace sandglass::event_driven::agents_test
