#include "sim/method/event_driven/dispenser_agent.hpp"
#include "sim/method/event_driven/filter_agent.hpp"
#include "sim/method/event_driven/outflow_agent.hpp"
#include "sim/method/event_driven/test_gas.hpp"

#include <cmath>

#include <gtest/gtest.h>

// Outlets, filters and dispensers.

namespace sandglass::event_driven::stream_test {
namespace {

const SpeciesTraits kHeavier{1, 4, 0};

LeavingStream<2> stream_out(double speed, bool high = true) {
  LeavingStream<2> stream;
  stream.high = high;
  stream.velocity = {high ? speed : -speed, 0.3};
  stream.temperature = 0.5;
  return stream;
}

struct Returned {
  double share, speed, speed_error;
};

Returned returned(const Backflow<2>& backflow, std::size_t species, double outward) {
  constexpr int kTries = 400000;
  double count = 0, sum = 0, squares = 0;
  for (int i = 0; i < kTries; ++i) {
    Random random(StreamKey(3, Purpose::walls, 0, 0), static_cast<std::uint64_t>(i));
    ParticleState<2> particle;
    particle.species = species;
    particle.velocity = {outward, 0};
    if (!backflow.turns(particle, random)) {
      EXPECT_EQ(particle.velocity[0], outward);
      continue;
    }
    const double back = -particle.velocity[0] * outward;
    EXPECT_GT(back, 0);
    ++count, sum += back, squares += back * back;
  }
  const double mean = sum / count;
  return {count / kTries, mean, std::sqrt((squares / count - mean * mean) / count)};
}

/// Mean of max(0, v) and of its square against the stream, by quadrature: F, and F times the mean returned speed.
std::array<double, 2> moments(double against, double thermal) {
  std::array<double, 2> sums{};
  const double dv = 1e-4;
  for (double v = dv / 2; v < 12; v += dv) {
    const double density =
        std::exp(-std::pow((v - against) / thermal, 2) / 2) / (thermal * std::sqrt(2 * M_PI));
    sums[0] += dv * v * density;
    sums[1] += dv * v * v * density;
  }
  return sums;
}

TEST(Backflow, TurnsBackAsManyAndAsFastAsTheGasBeyondWouldSend) {
  const std::vector<SpeciesTraits> species{{1, 1, 0}, kHeavier};
  for (const double speed : {0.0, 0.2, 0.6})
    for (const bool high : {false, true})
      for (const std::size_t kind : {std::size_t{0}, std::size_t{1}}) {
        const Returned found = returned(Backflow<2>(stream_out(speed, high), species), kind, high ? 1 : -1);
        const double thermal = std::sqrt(0.5 / species[kind].mass);
        const auto back = moments(-speed, thermal), out = moments(speed, thermal);
        const double share = back[0] / out[0];
        EXPECT_NEAR(found.share, share, 4 * std::sqrt(share * (1 - share) / 4e5) + 1e-6);
        EXPECT_NEAR(found.speed, back[1] / back[0], 4 * found.speed_error);
      }
}

TEST(Backflow, ItsFaultDrawsOtherSpeeds) {
  LeavingStream<2> stream = stream_out(0.2);
  stream.maxwellian = true;
  const Returned found = returned(Backflow<2>(stream, {{1, 1, 0}}), 0, 1);
  const auto back = moments(-0.2, std::sqrt(0.5));
  EXPECT_LT(found.speed, back[1] / back[0] - 10 * found.speed_error);
}

/// A stream of disks along x at the fraction `nu` in a periodic channel: a dispenser at the low side and a filter, or at
/// no depth an outlet, at the high one.
struct Stream {
  static constexpr double kSpeed = 0.3, kTemperature = 0.2, kDepth = 3;
  TestGas<2> gas;
  WallImpulses<2> sides;
  Layer<2> layer;

  Stream(double nu, bool filtered, WallKind piston = WallKind::specular, Faults faults = {})
      : gas(triangular_gas(20, 12, nu)) {
    const Vector<2> box = gas.parameters.geometry.box;
    for (auto& phase : gas.particles.phases) {
      phase.position[0] = std::clamp(phase.position[0], 0.5, box[0] - 0.5);
      phase.velocity = std::sqrt(kTemperature) * phase.velocity + Vector<2>(kSpeed, 0);
    }
    gas.parameters.impulses = &sides;
    gas.parameters.faults = faults;
    gas.parameters.geometry.periodic[0] = false;
    const double density = nu / (M_PI / 4);
    layer.count = std::ceil(density * box[1]);
    layer.width = layer.count / (density * box[1]);
    layer.velocity = {kSpeed, 0};
    layer.temperature = kTemperature;
    LeavingStream<2> out{0, true, layer.velocity, kTemperature, faults.maxwellian_backflow};
    WallRule rule;
    rule.kind = piston;
    rule.temperature = kTemperature;
    add([this] { return std::make_unique<OpenSideAgent<2>>(SidePlace{0, false, 0}, zero(), &sides); });
    if (filtered) {
      gas.parameters.heavy = HeavyParticles<2>{layer.velocity, SidePlace{0, true, box[0]}.number()};
      gas.parameters.species.push_back(gas.parameters.species.front());
      gas.parameters.surfaces.assign(4, gas.parameters.surfaces.front());
      add([this, box] {
        return std::make_unique<OpenSideAgent<2>>(SidePlace{0, true, box[0]}, zero(), &sides);
      });
      add([this, box, out] {
        return std::make_unique<FilterAgent<2>>(SidePlace{0, true, box[0] - kDepth},
                                                Backflow<2>(out, gas.parameters.species), layer.velocity,
                                                &sides);
      });
    } else {
      add([this, box, out] {
        return std::make_unique<OutflowAgent<2>>(SidePlace{0, true, box[0]},
                                                 Backflow<2>(out, gas.parameters.species), zero(), &sides);
      });
    }
    add([this, rule] {
      return std::make_unique<DispenserAgent<2>>(SidePlace{0, false, 0}, layer, rule, gas.parameters,
                                                 Streams{1, 0}, &sides);
    });
  }
  Stream(const Stream&) = delete;

  static Vector<2> zero() { return Vector<2>::Zero(); }
  template <class Make>
  void add(Make make) {
    gas.agents.push_back(make);
  }
  double piston_at(double time) const {
    const double stroke = layer.width;
    return kSpeed * time - stroke * std::floor(kSpeed * time / stroke * (1 + 1e-12));
  }
  double filter() const { return gas.parameters.geometry.box[0] - kDepth; }
};

double counted(const Simulator<2>& engine, const std::string& name) { return engine.counters().at(name); }

TEST(Dispenser, LaysItsRowsBehindThePistonAndNobodyPassesIt) {
  for (const WallKind kind : {WallKind::specular, WallKind::thermal}) {
    Stream stream(0.6, true, kind);
    const auto engine = stream.gas.make();
    double time = 0;
    for (int i = 0; i < 600; ++i) {
      engine->step(0.05, 0);
      time += 0.05;
      ASSERT_GE(smallest_gap(*engine, stream.gas.parameters.geometry), -1e-11) << time;
      for (const Phase<2>& phase : engine->view().particles)
        ASSERT_GE(phase.position[0], stream.piston_at(time) + 0.5 - 1e-9) << time;
    }
    EXPECT_EQ(counted(*engine, "particles-entered"),
              stream.layer.count * std::floor(Stream::kSpeed * time / stream.layer.width));
    EXPECT_EQ(counted(*engine, "particles-left-x-low"), 0);
  }
}

TEST(Filter, WhoPassesMovesWithTheStreamUntilItLeaves) {
  Stream stream(0.6, true);
  const auto engine = stream.gas.make();
  const Vector<2> velocity(Stream::kSpeed, 0);
  for (int i = 0; i < 400; ++i) {
    engine->step(0.1, 0);
    int heavy = 0;
    for (const Phase<2>& phase : engine->view().particles)
      if (phase.position[0] > stream.filter() + 1e-9) {
        ++heavy;
        ASSERT_LT((phase.velocity - velocity).norm(), 1e-12);
      }
    ASSERT_GT(heavy, 10) << i;
    ASSERT_LT(heavy, 60) << i;
  }
  EXPECT_GT(counted(*engine, "particles-turned-x-high"), 20);
  EXPECT_GT(counted(*engine, "particles-left-x-high"), 50);
}

/// Particles, momentum and energy inside.
Vector<4> inside(Simulator<2>& engine) {
  Vector<4> all;
  all << momentum(engine), kinetic_energy(engine), static_cast<double>(engine.size());
  return all;
}

Vector<4> unaccounted(const Stream& stream, Simulator<2>& engine, const Vector<4>& before) {
  Vector<4> given = Vector<4>::Zero();
  for (std::size_t side = 0; side < 4; ++side) {
    given.head<2>() -= stream.sides.impulse(side);
    given[2] += stream.sides.work(side) - stream.sides.heat(side);
  }
  given[3] = counted(engine, "particles-entered") - counted(engine, "particles-left");
  return inside(engine) - before - given;
}

TEST(Stream, BooksBalanceToRounding) {
  for (const bool filtered : {true, false})
    for (const WallKind kind : {WallKind::specular, WallKind::thermal}) {
      Stream stream(0.55, filtered, kind);
      const auto engine = stream.gas.make();
      const Vector<4> before = inside(*engine);
      for (int i = 0; i < 100; ++i) engine->step(1, 0);
      const Vector<4> lost = unaccounted(stream, *engine, before);
      const double rounding = 2.2e-16 * 20 * static_cast<double>(engine->tally().moves);
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(lost[k], 0, rounding) << k << filtered;
      EXPECT_EQ(lost[3], 0);
      EXPECT_GT(counted(*engine, "particles-left"), 100);
      EXPECT_GT(engine->tally().collisions, 5000u);
    }
}

TEST(Stream, LostNewcomersShowInTheBooks) {
  Faults faults;
  faults.lost_newcomers = true;
  Stream stream(0.55, true, WallKind::specular, faults);
  const auto engine = stream.gas.make();
  const Vector<4> before = inside(*engine);
  for (int i = 0; i < 100; ++i) engine->step(1, 0);
  const Vector<4> lost = unaccounted(stream, *engine, before);
  EXPECT_LT(lost[3], -5);
  EXPECT_LT(lost[0], -1);
}

/// A piston that stays out closes nothing: particles leave where they should come in.
TEST(Stream, APistonThatStaysOutLetsParticlesOut) {
  Faults faults;
  faults.staying_piston = true;
  Stream stream(0.55, true, WallKind::specular, faults);
  const auto engine = stream.gas.make();
  for (int i = 0; i < 100; ++i) engine->step(1, 0);
  EXPECT_GT(counted(*engine, "particles-left-x-low"), 20);
}

/// At rest the piston is a mirror, and what passes the filter stays there: the limiting case of the source.
TEST(Stream, AtRestItIsABox) {
  Stream stream(0.5, true);
  stream.layer.velocity.setZero();
  stream.gas.parameters.heavy->velocity.setZero();
  for (auto& phase : stream.gas.particles.phases) phase.velocity[0] -= Stream::kSpeed;
  const auto engine = stream.gas.make();
  for (int i = 0; i < 100; ++i) engine->step(1, 0);
  EXPECT_EQ(counted(*engine, "particles-entered"), 0);
  EXPECT_EQ(counted(*engine, "particles-left"), 0);
  EXPECT_EQ(engine->size(), stream.gas.particles.phases.size());
}

TEST(Stream, ARestartGoesOnToTheLastBit) {
  for (const double moment : {0.0, 0.7, 11.0, 40.0}) {
    Stream stream(0.6, true, WallKind::thermal);
    const auto straight = stream.gas.make();
    straight->step(moment, 0);
    const auto resumed = stream.gas.make_bare();
    resumed->assign(particles_of(*straight));
    resumed->load(straight->save());
    for (int i = 0; i < 40; ++i) {
      straight->step(0.5, 0);
      resumed->step(0.5, 0);
    }
    const auto left = straight->view().particles, right = resumed->view().particles;
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
      ASSERT_EQ(left[i].position, right[i].position);
      ASSERT_EQ(left[i].velocity, right[i].velocity);
    }
    EXPECT_TRUE(std::ranges::equal(straight->ids(), resumed->ids()));
    EXPECT_GT(straight->tally().collisions, 1000u);
  }
}

}  // namespace
}  // namespace sandglass::event_driven::stream_test
