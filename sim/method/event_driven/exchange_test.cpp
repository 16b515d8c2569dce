#include "sim/base/exact_sum.hpp"
#include "sim/method/event_driven/test_twin.hpp"
#include "sim/physics/flux_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

// Particles that come and go.

namespace sandglass::event_driven::exchange_test {
namespace {

constexpr double kStep = 0.25;

/// Streams that come in by both sides along x, `rate` particles a step each, with the flux distribution of a gas of unit
/// temperature that moves along x at the speed `drift`. Those of species `kind`, turning a little where they spin.
template <int D>
class Inlets {
 public:
  Inlets(const TestGas<D>& gas, int rate, double drift = 0) : gas_(gas), rate_(rate), drift_(drift) {}

  Entrants<D> draw(std::uint64_t step) const {
    Entrants<D> entrants;
    for (const bool high : {false, true})
      for (int i = 0; i < rate_; ++i)
        add(entrants, high, Random(key(step), static_cast<std::uint64_t>(2 * i + high)));
    return entrants;
  }
  void advance(Simulator<D>& engine, std::uint64_t step) const {
    engine.enter(draw(step), kStep, step);
    engine.step(kStep, step);
  }

 private:
  static StreamKey key(std::uint64_t step) { return {1, Purpose::inflow, 0, step}; }
  void add(Entrants<D>& entrants, bool high, Random random) const {
    const Vector<D>& box = gas_.parameters.geometry.box;
    const bool heavy = gas_.parameters.species.size() > 1 && random.uniform() < 0.5;
    const double radius = gas_.parameters.species[heavy].diameter / 2;
    Phase<D> phase;
    for (int axis = 0; axis < D; ++axis) {
      const double margin = gas_.parameters.geometry.periodic[static_cast<std::size_t>(axis)] ? 0 : radius;
      phase.position[axis] = margin + (box[axis] - 2 * margin) * random.uniform();
    }
    phase.position[0] = high ? box[0] : 0;
    phase.velocity =
        StreamFlux<D>(drift_ * Vector<D>::Unit(0), 1 / std::sqrt(gas_.parameters.species[heavy].mass), 0,
                      high ? -1 : 1)(random);
    entrants.particles.phases.push_back(phase);
    entrants.arrivals.push_back({0, high, kStep * (1 - random.uniform())});
    if (gas_.parameters.species.size() > 1)
      entrants.particles.columns.append(column::species, static_cast<std::uint8_t>(heavy));
    if (gas_.parameters.rough)
      entrants.particles.columns.append(column::spin<D>, Spin<D>(Spin<D>::Constant(random.uniform())));
  }

  const TestGas<D>& gas_;
  int rate_;
  double drift_;
};

double counted(const Simulator<2>& engine, const std::string& name) { return engine.counters().at(name); }

/// Elastic disks, open along x.
TestGas<2> open_gas(int edge = 12, double spacing = 1.6) {
  auto gas = lattice_gas<2>(edge, spacing);
  gas.add_open_sides(0);
  return gas;
}

/// A gas between open sides along x, with a force along it, into which somebody comes by each side every other step. False,
/// and nothing compared, where one did not come in where it was sent: the twin knows no other place.
bool compare_with_twin(double force, std::uint64_t seed) {
  auto gas = lattice_gas<2>(6, 3.0);
  gas.parameters.gravity = {force, 0};
  gas.add_open_sides(0);
  gas.add_walls(1);
  const Inlets<2> inlets(gas, 1);
  AllPairs<2> twin(gas);
  twin.open_sides(0);
  Recorder<2> trace;
  const auto engine = gas.make(&trace);
  for (std::uint64_t step = 0; step < 200; ++step) {
    const Entrants<2> entrants = step % 12 == 0 ? inlets.draw(1000 * seed + step) : Entrants<2>{};
    std::vector<std::size_t> order(entrants.arrivals.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](std::size_t i) { return -entrants.arrivals[i].left; });
    for (const std::size_t i : order)
      twin.add_arrival(kStep * static_cast<double>(step + 1) - entrants.arrivals[i].left,
                       entrants.particles.phases[i]);
    engine->enter(entrants, kStep, step);
    engine->step(kStep, step);
  }
  if (counted(*engine, "entrants-moved") > 0) return false;
  EXPECT_GT(counted(*engine, "particles-left"), 40);
  expect_same_trace(trace, twin, 70, 0);  // a dilute gas: rounding grows faster than in a dense one
  return true;
}

TEST(Exchange, TheTwinSeesTheSameEvents) {
  for (const double force : {0.0, 0.4}) {
    int compared = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) compared += compare_with_twin(force, seed);
    EXPECT_GE(compared, 3) << force;
  }
}

/// Sums of what is inside: particles, momentum and energy.
template <int D>
Vector<D + 2> inside(Simulator<D>& engine) {
  const View<D> view = engine.view();
  const auto species = view.columns.get(column::species);
  const auto spins = view.columns.get(column::spin<D>);
  std::array<ExactSum, D + 1> sums;
  for (std::size_t i = 0; i < view.particles.size(); ++i) {
    const SpeciesTraits& traits = view.traits[species.empty() ? 0 : species[i]];
    const Vector<D>& v = view.particles[i].velocity;
    for (int axis = 0; axis < D; ++axis) sums[static_cast<std::size_t>(axis)].add(traits.mass * v[axis]);
    const double turning = spins.empty() ? 0 : traits.inertia * spins[i].squaredNorm();
    sums[D].add((traits.mass * v.squaredNorm() + turning) / 2);
  }
  Vector<D + 2> all;
  for (int k = 0; k <= D; ++k) all[k] = sums[static_cast<std::size_t>(k)].value();
  all[D + 1] = static_cast<double>(engine.size());
  return all;
}

/// What the sides have given, in the same order.
template <int D>
Vector<D + 2> given(const WallImpulses<D>& sides, Simulator<D>& engine, double sent) {
  Vector<D + 2> all = Vector<D + 2>::Zero();
  for (std::size_t side = 0; side < 2 * D; ++side) {
    all.template head<D>() -= sides.impulse(side);
    all[D] += sides.work(side) - sides.heat(side);
  }
  const auto counters = engine.counters();
  all[D + 1] = sent - counters.at("particles-left") - counters.at("particles-waiting");
  return all;
}

/// Rough elastic particles of two species between thermal walls that slide: books to rounding. Each event rounds the sums by
/// a last digit of one particle's share.
template <int D>
void expect_balance(TestGas<D> gas) {
  WallImpulses<D> sides;
  gas.make_mixture(0.6, 0.3);
  gas.make_rough(1, std::numeric_limits<double>::infinity());
  gas.add_open_sides(0, &sides);
  gas.add_walls(1, {WallKind::thermal, {}, 1, 1.5}, &sides);
  gas.parameters.impulses = &sides;
  const Inlets<D> inlets(gas, 2, 0.5);
  const auto engine = gas.make();
  const Vector<D + 2> before = inside(*engine);
  const std::uint64_t steps = 2000;
  for (std::uint64_t step = 0; step < steps; ++step) inlets.advance(*engine, step);
  const Vector<D + 2> gained = inside(*engine) - before,
                      taken = given(sides, *engine, 4 * static_cast<double>(steps));
  const double events = static_cast<double>(engine->tally().moves) + 8 * static_cast<double>(steps);
  for (int k = 0; k < D + 1; ++k) EXPECT_NEAR(gained[k], taken[k], 2.2e-16 * events * 10) << k;
  EXPECT_EQ(gained[D + 1], taken[D + 1]);
  EXPECT_GT(events, 20000);
  EXPECT_GT(engine->counters().at("particles-left"), 0.9 * 4 * static_cast<double>(steps));
  EXPECT_LT(engine->tally().deepest_overlap, 1e-11);
}

TEST(Exchange, BooksBalanceToRounding) {
  expect_balance(lattice_gas<2>(8, 2.0));
  expect_balance(lattice_gas<3>(4, 2.0));
}

TEST(Exchange, ALostNewcomerShowsInTheBooks) {
  WallImpulses<2> sides;
  auto gas = lattice_gas<2>(8, 2.0);
  gas.add_open_sides(0, &sides);
  gas.parameters.impulses = &sides;
  gas.parameters.faults.lost_newcomers = true;
  const Inlets<2> inlets(gas, 2);
  const auto engine = gas.make();
  const Vector<4> before = inside(*engine);
  for (std::uint64_t step = 0; step < 100; ++step) inlets.advance(*engine, step);
  const Vector<4> gained = inside(*engine) - before, taken = given(sides, *engine, 400);
  EXPECT_EQ(taken[3] - gained[3], 20);
  EXPECT_GT(taken[2] - gained[2], 1);
}

/// A crowd at the sides: newcomers look for another place, wait, and never overlap anybody.
TEST(Exchange, WhoFindsNoRoomMovesOrWaits) {
  auto gas = open_gas(12, 1.15);
  gas.add_walls(1);
  const Inlets<2> inlets(gas, 3);
  const auto engine = gas.make();
  for (std::uint64_t step = 0; step < 400; ++step) {
    inlets.advance(*engine, step);
    ASSERT_GE(smallest_gap(*engine, gas.parameters.geometry), -1e-12) << step;
    ASSERT_EQ(static_cast<double>(engine->size()), 144 + 6.0 * static_cast<double>(step + 1) -
                                                       counted(*engine, "particles-left") -
                                                       counted(*engine, "particles-waiting"));
    for (const Phase<2>& phase : engine->view().particles) {
      ASSERT_GE(phase.position[0], 0);
      ASSERT_LE(phase.position[0], gas.parameters.geometry.box[0]);
      ASSERT_GE(phase.position[1], 0.5 - 1e-12);
      ASSERT_LE(phase.position[1], gas.parameters.geometry.box[1] - 0.5 + 1e-12);
    }
  }
  EXPECT_GT(counted(*engine, "entrants-moved"), 100);
  EXPECT_GT(counted(*engine, "entrants-delayed"), 10);
}

/// Nobody leaves a box of mirrors: the run ends when a thousand wait.
TEST(Exchange, AFloodStopsTheRun) {
  auto gas = lattice_gas<2>(12, 1.15);
  gas.add_walls(0);
  const Inlets<2> inlets(gas, 200);
  const auto engine = gas.make();
  EXPECT_THROW(for (std::uint64_t step = 0; step < 20; ++step) inlets.advance(*engine, step), RunError);
}

/// From an empty box to one that is emptied again.
TEST(Exchange, AnEmptyBoxFillsAndEmpties) {
  TestGas<2> gas({30, 20});
  gas.add_open_sides(0);
  gas.parameters.particles = 200;
  const Inlets<2> inlets(gas, 4);
  const auto engine = gas.make();
  EXPECT_EQ(engine->view().particles.size(), 0u);
  for (std::uint64_t step = 0; step < 400; ++step) inlets.advance(*engine, step);
  EXPECT_GT(engine->size(), 150u);
  EXPECT_GT(engine->tally().collisions, 1000u);
  const double most = static_cast<double>(engine->bytes());
  for (std::uint64_t step = 0; step < 4000; ++step) inlets.advance(*engine, step);
  EXPECT_LT(static_cast<double>(engine->bytes()), 3 * most);
  engine->step(1e5, 0);
  EXPECT_LT(engine->size(), 20u) << "those who stand still across";
  EXPECT_EQ(static_cast<double>(engine->size()), 8.0 * 4400 - counted(*engine, "particles-left"));
}

/// Rough particles of two species, thermal walls, gravity, TC model.
TestGas<2> everything() {
  auto gas = lattice_gas<2>(12, 1.5);
  gas.make_mixture(0.6, 0.3);
  gas.set_restitution(0.9);
  gas.make_rough(0.3, 0.2);
  gas.parameters.gravity = {0.02, -0.1};
  gas.parameters.contact_time = 0.02;
  gas.add_open_sides(0);
  gas.add_walls(1, {WallKind::thermal, {}, 1, 1.5});
  return gas;
}

template <int D>
void expect_identical(Simulator<D>& a, Simulator<D>& b) {
  const View<D> left = a.view(), right = b.view();
  ASSERT_EQ(left.particles.size(), right.particles.size());
  for (std::size_t i = 0; i < left.particles.size(); ++i) {
    ASSERT_EQ(left.particles[i].position, right.particles[i].position) << i;
    ASSERT_EQ(left.particles[i].velocity, right.particles[i].velocity) << i;
  }
  ASSERT_TRUE(std::ranges::equal(left.columns.get(column::spin<D>), right.columns.get(column::spin<D>)));
  ASSERT_TRUE(std::ranges::equal(left.columns.get(column::species), right.columns.get(column::species)));
  ASSERT_TRUE(std::ranges::equal(a.ids(), b.ids()));
  ASSERT_EQ(a.counters(), b.counters());
}

/// With some gone and, where it is crowded, some waiting. Who looks, and how often, does not show.
void expect_restart(const TestGas<2>& gas, int rate, std::uint64_t moment) {
  const Inlets<2> inlets(gas, rate);
  const auto straight = gas.make();
  for (std::uint64_t step = 0; step < moment; ++step) inlets.advance(*straight, step);
  const auto memory = straight->save();
  const auto resumed = gas.make_bare(), watched = gas.make();
  resumed->assign(particles_of(*straight));
  resumed->load(memory);
  for (std::uint64_t step = 0; step < moment; ++step) {
    inlets.advance(*watched, step);
    watched->view();
    watched->save();
  }
  for (std::uint64_t step = moment; step < moment + 100; ++step) {
    inlets.advance(*straight, step);
    inlets.advance(*resumed, step);
    inlets.advance(*watched, step);
  }
  EXPECT_GT(straight->tally().collisions, 1000u);
  expect_identical(*straight, *watched);
  auto counters = resumed->counters();
  EXPECT_EQ(resumed->size(), straight->size());
  EXPECT_EQ(counters.at("particles-left"), counted(*straight, "particles-left"));
  const View<2> left = straight->view(), right = resumed->view();
  for (std::size_t i = 0; i < left.particles.size(); ++i) {
    ASSERT_EQ(left.particles[i].position, right.particles[i].position) << i;
    ASSERT_EQ(left.particles[i].velocity, right.particles[i].velocity) << i;
  }
  EXPECT_TRUE(std::ranges::equal(straight->ids(), resumed->ids()));
}

TEST(Exchange, ARestartGoesOnToTheLastBit) {
  for (const std::uint64_t moment : {0, 1, 7, 40, 100}) {
    expect_restart(everything(), 2, moment);
    expect_restart(open_gas(12, 1.15), 4, moment);
  }
}

TEST(Exchange, ADamagedQueueIsRefused) {
  const auto gas = open_gas();
  const auto engine = gas.make();
  Inlets<2>(gas, 2).advance(*engine, 0);
  auto memory = engine->save();
  memory.at("event-driven/entrance").push_back(1);
  const auto resumed = gas.make_bare();
  resumed->assign(particles_of(*engine));
  EXPECT_THROW(resumed->load(memory), std::out_of_range);
}

/// Between two steps; an identity is never given twice.
TEST(Exchange, ParticlesComeAndGoBetweenSteps) {
  auto gas = lattice_gas<2>(6, 2.0);
  const auto engine = gas.make();
  engine->step(1, 0);
  const std::vector<std::uint32_t> leaving{3, 5, 35};
  std::vector<std::uint64_t> ids(engine->ids().begin(), engine->ids().end());
  engine->remove(leaving);
  EXPECT_EQ(engine->view().particles.size(), 33u);
  for (const std::uint32_t place : leaving) EXPECT_FALSE(std::ranges::count(engine->ids(), ids[place]));
  for (const auto& phase : engine->view().particles)
    EXPECT_FALSE(engine->has_room(phase.position + Vector<2>(0.3, 0.3), 0));
  Vector<2> place(0.1, 0.1);
  while (!engine->has_room(place, 0)) place += Vector<2>(0.05, 0.03);
  engine->insert(Particles<2>{{{place, {0, 0}}}, {}});
  EXPECT_FALSE(engine->has_room(place, 0));
  EXPECT_EQ(engine->size(), 34u);
  engine->view();
  EXPECT_EQ(*std::ranges::max_element(engine->ids()), 36u);
  for (int i = 0; i < 100; ++i) {
    engine->step(1, 0);
    ASSERT_GE(smallest_gap(*engine, gas.parameters.geometry), -1e-12);
  }
  EXPECT_GT(engine->tally().collisions, 300u);
}

}  // namespace
}  // namespace sandglass::event_driven::exchange_test
