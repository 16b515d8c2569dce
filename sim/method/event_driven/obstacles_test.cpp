#include "sim/method/event_driven/test_twin.hpp"

#include <set>

namespace sandglass::event_driven::obstacles_test {
namespace {

constexpr double kSpacing = 4, kRadius = 0.8;

/// Fixed disks on a square lattice, `edge` along each axis, and `count` particles at random places between them, all with
/// the speed 1 (Lorentz's gas, if few).
TestGas<2> lorentz_gas(int edge, int count) {
  TestGas<2> gas(Vector<2>::Constant(edge * kSpacing));
  gas.parameters.obstacles = static_cast<std::uint64_t>(edge) * static_cast<std::uint64_t>(edge);
  for (int i = 0; i < edge * edge; ++i)
    gas.add_obstacle(kSpacing * Vector<2>(i % edge + 0.5, i / edge + 0.5), kRadius);
  Random random(StreamKey(5, Purpose::positions, 0, 0), 0);
  for (int i = 0; i < count; ++i) {
    const auto place =
        static_cast<std::uint64_t>(i) * gas.parameters.obstacles / static_cast<std::uint64_t>(count);
    const double angle = 2 * M_PI * random.uniform();
    gas.add(kSpacing * Vector<2>(static_cast<double>(place % static_cast<std::uint64_t>(edge)),
                                 static_cast<double>(place / static_cast<std::uint64_t>(edge))),
            {std::cos(angle), std::sin(angle)});
  }
  return gas;
}

/// From the centre of the nearest obstacle.
double distance_to_obstacle(const Vector<2>& position) {
  Vector<2> within;
  for (int axis = 0; axis < 2; ++axis) within[axis] = std::fmod(position[axis], kSpacing) - kSpacing / 2;
  return within.norm();
}

/// More than 256: an agent's number is not taken for a particle's.
TEST(Obstacles, ThreeHundredAndTwentyFourAreNeverEntered) {
  const auto gas = lorentz_gas(18, 200);
  Recorder<2> trace;
  const auto engine = gas.make(&trace);
  for (int i = 0; i < 200; ++i) {
    engine->step(0.3, 0);
    for (const auto& phase : engine->view().particles)
      ASSERT_GE(distance_to_obstacle(phase.position), kRadius + 0.5 - 1e-10);
  }
  EXPECT_NEAR(kinetic_energy(*engine), 100, 1e-10);
  std::set<std::uint64_t> hit;
  for (const auto& event : trace.events)
    if (event.kind == Event<2>::Kind::agent) hit.insert(event.second);
  EXPECT_GT(hit.size(), 300u);
  EXPECT_EQ(*hit.rbegin(), 323u);
}

/// The slow twin asks every obstacle about every particle.
TEST(Obstacles, AreHitAsByTheSlowTwin) {
  const auto gas = lorentz_gas(18, 100);
  AllPairs<2> twin(gas);
  for (int i = 0; i < 18 * 18; ++i)
    twin.add_obstacle(kSpacing * Vector<2>(i % 18 + 0.5, i / 18 + 0.5), kRadius);
  expect_same_events(gas, twin, 150);
}

/// An obstacle that counts how often it is asked.
class CountedObstacle final : public Agent<2> {
 public:
  CountedObstacle(std::unique_ptr<Agent<2>> obstacle, std::uint64_t* questions)
      : obstacle_(std::move(obstacle)), questions_(questions) {}
  Box<2> reach() const override { return ++*questions_, obstacle_->reach(); }
  bool reaches(const Box<2>& cell) const override { return ++*questions_, obstacle_->reaches(cell); }
  double next() const override { return ++*questions_, HUGE_VAL; }
  double delay(const ParticleState<2>& particle, double now) const override {
    return ++*questions_, obstacle_->delay(particle, now);
  }
  Outcome act(ParticleState<2>& particle, double now, Random& random) override {
    return obstacle_->act(particle, now, random);
  }

 private:
  std::unique_ptr<Agent<2>> obstacle_;
  std::uint64_t* questions_;
};

/// Questions per event with an obstacle, and per obstacle before the first.
struct Cost {
  double event, obstacle;
};
Cost cost_among(int edge, int count) {
  TestGas<2> gas = lorentz_gas(edge, count);
  std::uint64_t questions = 0;
  for (auto& make : gas.agents)
    make = [plain = make, &questions] { return std::make_unique<CountedObstacle>(plain(), &questions); };
  Recorder<2> trace;
  const auto engine = gas.make(&trace);
  const double before = static_cast<double>(questions);
  for (int i = 0; i < 40; ++i) engine->step(5, 0);
  EXPECT_GT(trace.events.size(), 100u);
  return {(static_cast<double>(questions) - before) / static_cast<double>(trace.events.size()),
          before / static_cast<double>(gas.parameters.obstacles)};
}

TEST(Obstacles, FarAwayCostNothing) {
  const Cost few = cost_among(20, 20), many = cost_among(320, 20);
  EXPECT_LT(many.event, 1.5 * few.event);
  EXPECT_LT(many.event, 60);
  EXPECT_LT(many.obstacle, 30);
}

}  // namespace
}  // namespace sandglass::event_driven::obstacles_test
